// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Checks the data channels of a mesh: values at its vertices and at the corners of its triangles.
// @ts-check

import { invalidArgument } from './errors.js';
import { describe, isNumberArray } from './values.js';

const kinds = ['value', 'vector', 'normal'];

/**
 * @param {any} channel
 * @param {string} name
 * @returns {number}
 */
function checkComponents(channel, name) {
  const components = channel.components ?? channel.itemSize;
  if (Number.isInteger(components) && components > 0) return components;
  throw invalidArgument(`${name}.components must be a positive integer, not ${describe(components)}`);
}

/**
 * Numbers, NaN where there is no value.
 * @param {any} channel
 * @param {string} name
 * @returns {Float64Array | Float32Array}
 */
function checkValues(channel, name) {
  const values = channel.values ?? channel.array;
  if (values instanceof Float64Array || values instanceof Float32Array) return values;
  if (!Array.isArray(values) && !isNumberArray(values)) {
    throw invalidArgument(`${name}.values must be a Float64Array, a Float32Array or an array of numbers, not ${describe(values)}`);
  }
  const wrong = Array.prototype.findIndex.call(values, (/** @type {unknown} */ x) => typeof x !== 'number');
  if (wrong >= 0) throw invalidArgument(`${name}.values[${wrong}] must be a number, NaN for no value, not ${describe(values[wrong])}`);
  return Float64Array.from(values);
}

/**
 * @param {any} channel
 * @param {string} key its own name
 * @param {string} name how the caller knows it
 * @param {number} places that have values
 * @returns {import('./glue_types.js').CheckedChannel}
 */
function checkChannel(channel, key, name, places) {
  if (typeof channel !== 'object' || channel === null) throw invalidArgument(`${name} must be {components, values}, not ${describe(channel)}`);
  if (channel.isInterleavedBufferAttribute === true || channel.normalized === true) {
    throw invalidArgument(`${name} is an interleaved or normalized attribute: pass {components, values} with its numbers one after the other`);
  }
  const components = checkComponents(channel, name);
  const values = checkValues(channel, name);
  if (values.length !== places * components) {
    throw invalidArgument(`${name} has ${values.length} values for ${places} places of ${components} components`);
  }
  const kind = channel.kind ?? (key === 'normal' && components === 3 ? 'normal' : 'value');
  if (!kinds.includes(kind)) throw invalidArgument(`${name}.kind is one of ${kinds.join(', ')}, not ${describe(kind)}`);
  return { name: key, components, kind, values };
}

/**
 * @param {any} channels
 * @param {string} name
 * @param {number} places
 */
function checkChannels(channels, name, places) {
  if (typeof channels !== 'object' || channels === null || Array.isArray(channels)) {
    throw invalidArgument(`${name} must be an object of channels {components, values} by their names, not ${describe(channels)}`);
  }
  return Object.entries(channels).map(([key, channel]) => checkChannel(channel, key, `${name}.${key}`, places));
}

/**
 * The data of a mesh as lists of channels.
 * @param {any} mesh
 * @param {{ vertices: number, corners: number }} places
 * @param {string} name
 */
export function checkData({ vertexData, cornerData }, places, name) {
  return {
    ...(vertexData === undefined ? {} : { vertexData: checkChannels(vertexData, `${name}.vertexData`, places.vertices) }),
    ...(cornerData === undefined ? {} : { cornerData: checkChannels(cornerData, `${name}.cornerData`, places.corners) }),
  };
}
