// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The shapes of make(): their parameters in the order the core takes them, and their defaults.
// @ts-check

import { describe } from './arguments.js';
import { invalidArgument } from './errors.js';

/**
 * One parameter of a shape.
 * @typedef {object} Parameter
 * @property {string} wanted what it takes, in words
 * @property {any} [fallback] its default; without one it must be given
 * @property {(value: any) => number[] | undefined} numbers its numbers, or undefined when the value makes no sense
 */

/** @param {unknown} value */
const isNumber = (value) => typeof value === 'number';

/** @param {unknown} value @param {number} length */
const isTuple = (value, length) => Array.isArray(value) && value.length === length && value.every(isNumber);

/** @param {number} fallback @returns {Parameter} */
const length = (fallback) => ({ wanted: 'a number', fallback, numbers: (value) => (isNumber(value) ? [value] : undefined) });

/** @param {number} fallback @returns {Parameter} */
const count = (fallback) => ({ wanted: 'a whole number', fallback, numbers: (value) => (Number.isInteger(value) ? [value] : undefined) });

/** @param {[number, number, number]} fallback @returns {Parameter} */
const point = (fallback) => ({ wanted: 'three numbers', fallback, numbers: (value) => (isTuple(value, 3) ? value : undefined) });

/** @type {Parameter} */
const polygon = {
  wanted: 'an array of at least three pairs of numbers',
  numbers: (value) => (Array.isArray(value) && value.length >= 3 && value.every((pair) => isTuple(pair, 2)) ? value.flat() : undefined),
};

/**
 * Parameters in the order of the core; `core` is its name there.
 * @type {Record<string, { core: string, parameters: Record<string, Parameter> }>}
 */
export const shapes = {
  box: { core: 'box', parameters: { lo: point([0, 0, 0]), hi: point([1, 1, 1]) } },
  sphere: { core: 'sphere', parameters: { radius: length(1), around: count(64), rings: count(32) } },
  icosphere: { core: 'icosphere', parameters: { radius: length(1), levels: count(4) } },
  cylinder: { core: 'cylinder', parameters: { radius: length(1), height: length(1), around: count(64) } },
  cone: { core: 'cone', parameters: { radius: length(1), height: length(1), around: count(64) } },
  torus: { core: 'torus', parameters: { majorRadius: length(1), minorRadius: length(0.25), around: count(64), across: count(32) } },
  gridSheet: { core: 'grid_sheet', parameters: { width: length(1), depth: length(1), cellsX: count(8), cellsY: count(8) } },
  extrude: { core: 'extrude', parameters: { height: length(1), outline: polygon } },
  revolve: { core: 'revolve', parameters: { around: count(64), profile: polygon } },
};

/**
 * The core's name of a shape and all its numbers.
 * @param {any} shape
 * @param {any} [given]
 * @returns {[string, Float64Array]}
 */
export function checkShape(shape, given = {}) {
  if (typeof shape !== 'string' || !Object.hasOwn(shapes, shape)) throw invalidArgument(`the shapes are ${Object.keys(shapes).join(', ')}, not ${describe(shape)}`);
  if (typeof given !== 'object' || given === null) throw invalidArgument(`the parameters of ${shape} are an object, not ${describe(given)}`);
  const { core, parameters } = shapes[shape];
  const unknown = Object.keys(given).find((name) => !Object.hasOwn(parameters, name));
  if (unknown !== undefined) throw invalidArgument(`${shape} has no parameter '${unknown}'; it has ${Object.keys(parameters).join(', ')}`);
  const numbers = Object.entries(parameters).flatMap(([name, { wanted, fallback, numbers: numbersOf }]) => {
    const value = given[name] ?? fallback;
    const found = numbersOf(value);
    if (found === undefined) throw invalidArgument(`${name} of ${shape} must be ${wanted}, not ${describe(value)}`);
    return found;
  });
  return [core, Float64Array.from(numbers)];
}
