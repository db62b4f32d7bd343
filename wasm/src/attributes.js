// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Attributes of models: checked and flattened for the core, made of what it answers, measured.
// @ts-check

import { invalidArgument } from './errors.js';
import { describe } from './values.js';

/** @typedef {import('./index.js').Attribute} Attribute */
/** @typedef {import('./index.js').ModelTables} Tables */
/** @typedef {import('./glue_types.js').FlatAttribute} FlatAttribute */

/**
 * By the numbers the core has for them.
 * @type {import('./index.js').ModelEntity['dimension'][]}
 */
export const dimensions = ['vertex', 'edge', 'face', 'region'];

/** @type {NonNullable<Attribute['kind']>[]} */
const kinds = ['material', 'boundaryCondition', 'load', 'size', 'user'];

/** @type {Record<'split' | 'merge' | 'delete', string[]>} */
const choices = { split: ['copy', 'largest', 'drop'], merge: ['union', 'first', 'second', 'error', 'drop'], delete: ['drop', 'toNeighbours'] };

/** How many entities of each dimension there are. @param {Tables} tables */
export function entityCounts({ meshVertex, edgeStart, faceGenus, regionVolume }) {
  return [meshVertex.length, edgeStart.length, faceGenus.length, regionVolume.length];
}

/**
 * Dimension and number of an entity of a model.
 * @param {any} entity
 * @param {number[] | undefined} counts of the model, where it is known
 * @param {string} name how the caller knows it
 */
export function checkEntity(entity, counts, name) {
  const dimension = dimensions.indexOf(entity?.dimension);
  if (dimension < 0) throw invalidArgument(`${name} must be {dimension, id} with one of ${dimensions.join(', ')}, not ${describe(entity?.dimension ?? entity)}`);
  const { id } = entity;
  if (!Number.isInteger(id) || id < 0) throw invalidArgument(`${name}.id must be a number of a ${dimensions[dimension]}, not ${describe(id)}`);
  if (counts !== undefined && id >= counts[dimension]) throw invalidArgument(`${name}: the model has no ${dimensions[dimension]} ${id}: there are ${counts[dimension]}`);
  return [dimension, id];
}

/**
 * Its place in a list of names.
 * @param {any} value
 * @param {string[]} known
 * @param {string} name
 */
function codeOf(value, known, name) {
  const code = known.indexOf(value);
  if (code < 0) throw invalidArgument(`${name} is one of ${known.join(', ')}, not ${describe(value)}`);
  return code;
}

/**
 * JSON with the keys of objects in order, so that equal values have equal texts.
 * @param {unknown} value
 * @param {string} name
 */
function jsonOf(value, name) {
  const inOrder = (/** @type {string} */ _, /** @type {any} */ item) => {
    if (typeof item === 'number' && !Number.isFinite(item)) throw new TypeError(`${item} is no number of JSON`);
    if (typeof item !== 'object' || item === null || Array.isArray(item)) return item;
    return Object.fromEntries(Object.entries(item).sort(([a], [b]) => (a < b ? -1 : 1)));
  };
  try {
    const text = JSON.stringify(value, inOrder);
    if (typeof text === 'string') return text;
  } catch (cause) {
    throw invalidArgument(`${name} must be a value JSON can hold: ${/** @type {Error} */ (cause).message}`);
  }
  throw invalidArgument(`${name} must be a value JSON can hold, not ${describe(value)}`);
}

/** @param {any} policy @param {string} name */
function checkPolicy(policy, name) {
  if (typeof policy !== 'object' || policy === null) throw invalidArgument(`${name} must be an object, not ${describe(policy)}`);
  const { pieceName = '', ...chosen } = policy;
  const unknown = Object.keys(chosen).find((key) => !Object.hasOwn(choices, key));
  if (unknown !== undefined) throw invalidArgument(`${name} has no '${unknown}'; known: ${Object.keys(choices).join(', ')}, pieceName`);
  if (typeof pieceName !== 'string') throw invalidArgument(`${name}.pieceName must be a string like '{name} {piece}', not ${describe(pieceName)}`);
  return { pieceName, codes: Object.entries(choices).map(([key, known]) => codeOf(chosen[key] ?? known[0], known, `${name}.${key}`)) };
}

/**
 * @param {any} attribute
 * @param {number[]} counts
 * @param {string} name
 * @returns {FlatAttribute}
 */
function flattened(attribute, counts, name) {
  if (typeof attribute !== 'object' || attribute === null) throw invalidArgument(`${name} must be {name, targets}, not ${describe(attribute)}`);
  const { kind = 'user', value = null, targets, policy = {} } = attribute;
  if (typeof attribute.name !== 'string' || attribute.name === '') throw invalidArgument(`${name}.name must be a string that is not empty, not ${describe(attribute.name)}`);
  if (!Array.isArray(targets)) throw invalidArgument(`${name}.targets must be an array of {dimension, id}, not ${describe(targets)}`);
  const { pieceName, codes } = checkPolicy(policy, `${name}.policy`);
  return {
    name: attribute.name,
    value: jsonOf(value, `${name}.value`),
    pieceName,
    codes: Uint32Array.of(codeOf(kind, kinds, `${name}.kind`), ...codes),
    targets: Uint32Array.from(targets.flatMap((target, i) => checkEntity(target, counts, `${name}.targets[${i}]`))),
  };
}

/**
 * @param {any} attributes
 * @param {number[]} counts of the entities of their model
 * @param {string} name how the caller knows them
 */
export function flatAttributes(attributes, counts, name) {
  if (!Array.isArray(attributes)) throw invalidArgument(`${name} must be an array, not ${describe(attributes)}`);
  return attributes.map((attribute, i) => flattened(attribute, counts, `${name}[${i}]`));
}

/** @param {FlatAttribute} flat @returns {Attribute} */
function whole({ name, value, pieceName, codes, targets }) {
  const policy = /** @type {import('./index.js').AttributePolicy} */ (Object.fromEntries(Object.entries(choices).map(([key, known], i) => [key, known[codes[i + 1]]])));
  if (pieceName !== '') policy.pieceName = pieceName;
  const entities = Array.from({ length: targets.length / 2 }, (_, i) => ({ dimension: dimensions[targets[2 * i]], id: targets[2 * i + 1] }));
  return { name, targets: entities, kind: kinds[codes[0]], value: JSON.parse(value), policy };
}

/** @param {FlatAttribute[]} flat */
export function wholeAttributes(flat) {
  return flat.map(whole);
}

/**
 * One for each label that is not empty, on the faces that have it.
 * @param {{ faceLabels?: ArrayLike<number>, labelNames?: readonly string[] }} mesh
 * @param {Uint32Array} triangleFace
 * @returns {Attribute[]}
 */
export function labelAttributes({ faceLabels, labelNames = [] }, triangleFace) {
  /** @type {Map<string, Set<number>>} */
  const facesOf = new Map(labelNames.map((name) => [name, new Set()]));
  triangleFace.forEach((face, t) => facesOf.get(labelNames[faceLabels?.[t] ?? -1])?.add(face));
  return [...facesOf].filter(([name, faces]) => name !== '' && faces.size > 0).map(([name, faces]) => ({ name, targets: [...faces].sort((a, b) => a - b).map((id) => ({ dimension: 'face', id })) }));
}

/**
 * One row per name, ascending.
 * @param {FlatAttribute[]} attributes
 * @param {Tables} tables
 */
export function measuresOf(attributes, { edgeLength, faceArea, regionVolume }) {
  /** @type {Map<string, [Set<number>, Set<number>, Set<number>, Set<number>]>} */
  const covered = new Map();
  for (const { name, targets } of attributes) {
    const sets = covered.get(name) ?? [new Set(), new Set(), new Set(), new Set()];
    covered.set(name, sets);
    for (let i = 0; i < targets.length; i += 2) sets[targets[i]].add(targets[i + 1]);
  }
  const sum = (/** @type {Set<number>} */ ids, /** @type {Float64Array} */ measures) => [...ids].sort((a, b) => a - b).reduce((total, id) => total + measures[id], 0);
  const names = [...covered.keys()].sort();
  return names.map((name) => {
    const [vertices, edges, faces, regions] = /** @type {[Set<number>, Set<number>, Set<number>, Set<number>]} */ (covered.get(name));
    return { name, vertices: vertices.size, length: sum(edges, edgeLength), area: sum(faces, faceArea), volume: sum(regions, regionVolume) };
  });
}
