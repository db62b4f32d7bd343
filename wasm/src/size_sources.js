// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sources of sizes as callers write them, checked and flattened for the core.
// @ts-check

import { checkMesh } from './arguments.js';
import { checkEntity, entityCounts } from './attributes.js';
import { invalidArgument } from './errors.js';
import { Model } from './model.js';
import { describe, isNumberArray } from './values.js';

/** @typedef {import('./glue_types.js').CheckedSizeSource} CheckedSizeSource */
/** @typedef {import('./glue_types.js').CheckedSizeSources} CheckedSizeSources */

/**
 * What sources are about that do not say it, and what all of them share.
 * @typedef {object} Defaults
 * @property {number} growth
 * @property {number} size where no source asks for less
 * @property {any} [model]
 * @property {any} [mesh]
 */

const common = ['growth', 'radius'];

/** @param {unknown} value @param {string} name */
export function checkSize(value, name) {
  if (typeof value !== 'number' || !(value > 0 && value < Infinity)) throw invalidArgument(`${name} must be a positive number, not ${describe(value)}`);
  return value;
}

/** @param {unknown} value @param {string} name */
export function checkSmallest(value, name) {
  if (typeof value !== 'number' || !(value >= 0 && value < Infinity)) throw invalidArgument(`${name} must be a number, 0 or more, not ${describe(value)}`);
  return value;
}

/** @param {unknown} value @param {string} name */
export function checkGrowth(value, name) {
  if (typeof value !== 'number' || !(value >= 1 && value < Infinity)) throw invalidArgument(`${name} must be a number, 1 or more, not ${describe(value)}`);
  return value;
}

/**
 * Three finite numbers.
 * @param {any} point
 * @param {string} name
 * @returns {number[]}
 */
export function checkPoint(point, name) {
  const isPoint = (Array.isArray(point) || isNumberArray(point)) && point.length === 3 && Array.prototype.every.call(point, (x) => Number.isFinite(x));
  if (!isPoint) throw invalidArgument(`${name} must be three finite numbers, not ${describe(point)}`);
  return [...point];
}

/**
 * @param {any} source
 * @param {string[]} known
 * @param {string} name
 */
function checkKeys(source, known, name) {
  const unknown = Object.keys(source).find((key) => !known.includes(key) && !common.includes(key));
  if (unknown !== undefined) throw invalidArgument(`${name} has an unknown '${unknown}'; known: ${[...known, ...common].join(', ')}`);
}

/**
 * One size, or as many as one of the counts.
 * @param {any} size
 * @param {number[]} counts
 * @param {string} name
 */
function checkSizes(size, counts, name) {
  if (typeof size === 'number') return Float64Array.of(checkSize(size, `${name}.size`));
  const isList = (Array.isArray(size) || isNumberArray(size)) && counts.includes(size.length);
  if (!isList) throw invalidArgument(`${name}.size must be ${counts.length === 0 ? 'a number' : `a number, or ${counts.join(' or ')} of them`}, not ${describe(size)}`);
  return Float64Array.from(size, (/** @type {unknown} */ s, /** @type {number} */ i) => checkSize(s, `${name}.size[${i}]`));
}

/**
 * @param {any} graph
 * @param {string} name
 */
function checkGraph(graph, name) {
  if (graph?.graph !== undefined) throw invalidArgument(`${name} is a result: pass its .graph`);
  const { points, edges } = graph ?? {};
  if (!(points instanceof Float64Array || points instanceof Float32Array) || !(edges instanceof Uint32Array) || points.length % 3 !== 0 || edges.length % 2 !== 0) {
    throw invalidArgument(`${name} must be the graph of a result, {points, edges}, not ${describe(graph)}`);
  }
  return { points, edges };
}

/**
 * @param {any} size
 * @param {string} name
 */
function sizeIfAny(size, name) {
  return size === undefined ? undefined : checkSize(size, `${name}.size`);
}

/** Sources by their type. @type {Record<string, { keys: string[], read: (source: any, name: string) => any }>} */
const types = {
  point: {
    keys: ['at', 'size'],
    read: ({ at, size }, name) => ({ kind: 'plain', corners: Float64Array.from(checkPoint(at, `${name}.at`)), sizes: checkSizes(size, [], name) }),
  },
  segment: {
    keys: ['from', 'to', 'size'],
    read: ({ from, to, size }, name) => {
      const corners = Float64Array.of(...checkPoint(from, `${name}.from`), ...checkPoint(to, `${name}.to`));
      return { kind: 'plain', corners, sizes: checkSizes(size, [2, 3], name) };
    },
  },
  segments: { keys: ['from', 'size'], read: ({ from, size }, name) => ({ kind: 'graph', ...checkGraph(from, `${name}.from`), size: sizeIfAny(size, name) }) },
  triangle: {
    keys: ['corners', 'size'],
    read: ({ corners, size }, name) => {
      if (!Array.isArray(corners) || corners.length !== 3) throw invalidArgument(`${name}.corners must be three points, not ${describe(corners)}`);
      const flat = corners.flatMap((corner, i) => checkPoint(corner, `${name}.corners[${i}]`));
      return { kind: 'plain', corners: Float64Array.from(flat), sizes: checkSizes(size, [3, 6], name) };
    },
  },
};

class SourceChecker {
  /** @type {Map<Model<any>, number>} */
  #numbers = new Map();
  /** @type {CheckedSizeSources['models']} */
  models = [];

  /** @param {Defaults} defaults */
  constructor(defaults) {
    this.defaults = defaults;
  }

  /**
   * @param {any} source
   * @param {string} name
   * @returns {CheckedSizeSource}
   */
  check(source, name) {
    if (typeof source !== 'object' || source === null || Array.isArray(source)) throw invalidArgument(`${name} must be an object, not ${describe(source)}`);
    const growth = source.growth === undefined ? this.defaults.growth : checkGrowth(source.growth, `${name}.growth`);
    return { ...this.#read(source, name), growth, radius: checkSmallest(source.radius ?? 0, `${name}.radius`) };
  }

  /**
   * @param {any} source
   * @param {string} name
   * @returns {any}
   */
  #read(source, name) {
    if (source.type !== undefined) return this.#readType(source, name);
    if (source.graph !== undefined) {
      checkKeys(source, ['graph', 'size'], name);
      return { kind: 'graph', ...checkGraph(source.graph, `${name}.graph`), size: sizeIfAny(source.size, name) };
    }
    if (source.entity !== undefined) return this.#readEntity(source, name);
    if (source.curvature !== undefined) return this.#readCurvature(source, name);
    if (source.edgeCount !== undefined) return this.#readEdgeCount(source, name);
    if (source.sizes !== undefined) return this.#readSizes(source, name);
    if (source.attributes === true) {
      checkKeys(source, ['model', 'attributes'], name);
      return { kind: 'attributes', model: this.#modelOf(source, name) };
    }
    throw invalidArgument(`${name} must have a type (${Object.keys(types).join(', ')}), or graph, entity, curvature, edgeCount, sizes, or attributes: true`);
  }

  /** @param {any} source @param {string} name */
  #readType(source, name) {
    if (!Object.hasOwn(types, source.type)) throw invalidArgument(`${name}.type is one of ${Object.keys(types).join(', ')}, not ${describe(source.type)}`);
    const { keys, read } = types[source.type];
    checkKeys(source, ['type', ...keys], name);
    return read(source, name);
  }

  /** @param {any} source @param {string} name */
  #readEntity(source, name) {
    checkKeys(source, ['model', 'entity', 'size'], name);
    const model = this.#modelOf(source, name);
    const { tables } = /** @type {Model<any>} */ (source.model ?? this.defaults.model);
    return { kind: 'entity', model, entity: checkEntity(source.entity, entityCounts(tables), `${name}.entity`), size: checkSize(source.size, `${name}.size`) };
  }

  /** @param {any} source @param {string} name */
  #readCurvature(source, name) {
    checkKeys(source, ['model', 'curvature'], name);
    const { chordError, perTurn, smallest = 0, ...unknown } = Object(source.curvature);
    if (Object.keys(unknown).length > 0 || (chordError === undefined && perTurn === undefined)) {
      throw invalidArgument(`${name}.curvature must be {chordError, perTurn, smallest}, with at least one of the first two, not ${describe(source.curvature)}`);
    }
    if (chordError !== undefined) checkSize(chordError, `${name}.curvature.chordError`);
    if (perTurn !== undefined) checkSize(perTurn, `${name}.curvature.perTurn`);
    return { kind: 'curvature', model: this.#modelOf(source, name), chordError, perTurn, smallest: checkSmallest(smallest, `${name}.curvature.smallest`), largest: this.defaults.size };
  }

  /** @param {any} source @param {string} name */
  #readEdgeCount(source, name) {
    checkKeys(source, ['model', 'edgeCount', 'smallest'], name);
    const { edgeCount, smallest = 0 } = source;
    if (!Number.isInteger(edgeCount) || edgeCount < 1 || edgeCount > 0xffffffff) throw invalidArgument(`${name}.edgeCount must be a number of elements, 1 or more, not ${describe(edgeCount)}`);
    return { kind: 'edgeCount', model: this.#modelOf(source, name), count: edgeCount, smallest: checkSmallest(smallest, `${name}.smallest`) };
  }

  /** @param {any} source @param {string} name */
  #readSizes(source, name) {
    checkKeys(source, ['mesh', 'sizes'], name);
    const given = source.mesh ?? this.defaults.mesh ?? this.defaults.model?.mesh;
    const mesh = checkMesh(given, `${name}.mesh`);
    const count = mesh.positions.length / 3;
    const { sizes } = source;
    if (typeof sizes === 'function') {
      const at = (/** @type {unknown} */ _, /** @type {number} */ i) => checkSize(sizes(...mesh.positions.subarray(3 * i, 3 * i + 3)), `${name}.sizes of vertex ${i}`);
      return { kind: 'vertexSizes', mesh, sizes: Float64Array.from({ length: count }, at) };
    }
    if ((!Array.isArray(sizes) && !isNumberArray(sizes)) || sizes.length !== count) throw invalidArgument(`${name}.sizes must be ${count} numbers, one for each vertex, or a function, not ${describe(sizes)}`);
    return { kind: 'vertexSizes', mesh, sizes: Float64Array.from(sizes, (/** @type {unknown} */ s, /** @type {number} */ i) => checkSize(s, `${name}.sizes[${i}]`)) };
  }

  /**
   * The place of its model among those that cross.
   * @param {any} source
   * @param {string} name
   */
  #modelOf(source, name) {
    const model = checkModelOf(source.model ?? this.defaults.model, `${name}.model`);
    const known = this.#numbers.get(model);
    if (known !== undefined) return known;
    this.#numbers.set(model, this.models.length);
    return this.models.push(model.checked(`${name}.model`)) - 1;
  }
}

/**
 * @param {any} model
 * @param {string} name
 * @returns {Model<any>}
 */
export function checkModelOf(model, name) {
  if (model instanceof Promise) throw invalidArgument(`${name} is a promise: await it first`);
  if (!(model instanceof Model)) throw invalidArgument(`${name} must be what model, resultModel or readModel gives, not ${describe(model)}`);
  return model;
}

/**
 * What calls that take `sources` hand to the core.
 * @param {any} sources
 * @param {Defaults} defaults
 * @returns {CheckedSizeSources}
 */
export function checkSizeSources(sources, defaults) {
  if (!Array.isArray(sources)) throw invalidArgument(`sources must be an array, not ${describe(sources)}`);
  const checker = new SourceChecker(defaults);
  const checked = sources.map((source, i) => checker.check(source, `sources[${i}]`));
  return { sources: checked, models: checker.models };
}
