// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model of a result: which entities of its operands it comes from, and what became of them.
// @ts-check

import { describe } from './arguments.js';
import { checkEntity, dimensions } from './attributes.js';
import { invalidArgument } from './errors.js';
import { Model } from './model.js';

/** @typedef {import('./index.js').Mesh} Mesh */
/** @typedef {import('./index.js').ModelEntity} ModelEntity */
/** @typedef {import('./glue_types.js').Links} Links */

/**
 * Counts of its entities by dimension, and of those of its operands where these are known; `provenance` where these are operands of one operation.
 * @typedef {{ links: Links, counts: number[], operands: (number[] | undefined)[], interfaces: import('./index.js').Attribute[], provenance: import('./index.js').Provenance | undefined }} Inherited
 */

/** @param {number[]} numbers */
const keyOf = (...numbers) => numbers.join(' ');

/**
 * Places of links by a key of each.
 * @param {Links} links
 * @param {(i: number) => string} key
 */
function placesBy({ result }, key) {
  /** @type {Map<string, number[]>} */
  const places = new Map();
  for (let i = 0; i < result.length; ++i) {
    const found = places.get(key(i));
    if (found === undefined) places.set(key(i), [i]);
    else found.push(i);
  }
  return places;
}

/** @extends {Model<Mesh>} */
export class ResultModel extends Model {
  #inherited;
  /** @type {Map<string, number[]> | undefined} */
  #byResult;
  /** @type {Map<string, number[]> | undefined} */
  #bySource;

  /**
   * @param {import('./model.js').Parts<Mesh>} parts
   * @param {Inherited} inherited
   */
  constructor(parts, inherited) {
    super(parts);
    this.#inherited = inherited;
    this.interfaces = inherited.interfaces;
  }

  /** Where its triangles come from, as long as they are those of the result. */
  get provenance() {
    return this.#inherited.provenance;
  }

  /**
   * @override
   * @param {Mesh} mesh
   * @param {import('./index.js').ModelTables} tables
   */
  on(mesh, tables) {
    return new ResultModel(this.partsOn(mesh, tables), { ...this.#inherited, provenance: undefined, interfaces: structuredClone(this.interfaces) });
  }

  /** @param {ModelEntity} entity */
  sourcesOf(entity) {
    const { links, counts } = this.#inherited;
    const { dimension, result, operand, source, measure } = links;
    this.#byResult ??= placesBy(links, (i) => keyOf(dimension[i], result[i]));
    const places = this.#byResult.get(keyOf(...checkEntity(entity, counts, 'entity'))) ?? [];
    return places.map((i) => ({ operand: operand[i], dimension: dimensions[dimension[i]], id: source[i], measure: measure[i] }));
  }

  /**
   * @param {number} operand
   * @param {ModelEntity} entity
   */
  partsOf(operand, entity) {
    const { links, operands } = this.#inherited;
    if (!Number.isInteger(operand) || operand < 0 || operand >= operands.length) {
      throw invalidArgument(`operand must be a number below ${operands.length}, not ${describe(operand)}`);
    }
    this.#bySource ??= placesBy(links, (i) => keyOf(links.operand[i], links.dimension[i], links.source[i]));
    const places = this.#bySource.get(keyOf(operand, ...checkEntity(entity, operands[operand], 'entity'))) ?? [];
    return places.map((i) => ({ dimension: dimensions[links.dimension[i]], id: links.result[i], measure: links.measure[i] }));
  }
}
