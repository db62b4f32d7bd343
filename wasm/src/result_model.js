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
  #links;
  #counts;
  #operands;
  /** @type {Map<string, number[]> | undefined} */
  #byResult;
  /** @type {Map<string, number[]> | undefined} */
  #bySource;

  /**
   * @param {import('./model.js').Parts<Mesh>} parts
   * @param {{ links: Links, counts: number[], operands: (number[] | undefined)[], interfaces: import('./index.js').Attribute[] }} inherited counts of its
   *   entities by dimension, and of those of its operands where these are known
   */
  constructor(parts, { links, counts, operands, interfaces }) {
    super(parts);
    this.#links = links;
    this.#counts = counts;
    this.#operands = operands;
    this.interfaces = interfaces;
  }

  /** @param {ModelEntity} entity */
  sourcesOf(entity) {
    const { dimension, result, operand, source, measure } = this.#links;
    this.#byResult ??= placesBy(this.#links, (i) => keyOf(dimension[i], result[i]));
    const places = this.#byResult.get(keyOf(...checkEntity(entity, this.#counts, 'entity'))) ?? [];
    return places.map((i) => ({ operand: operand[i], dimension: dimensions[dimension[i]], id: source[i], measure: measure[i] }));
  }

  /**
   * @param {number} operand
   * @param {ModelEntity} entity
   */
  partsOf(operand, entity) {
    const links = this.#links;
    if (!Number.isInteger(operand) || operand < 0 || operand >= this.#operands.length) {
      throw invalidArgument(`operand must be a number below ${this.#operands.length}, not ${describe(operand)}`);
    }
    this.#bySource ??= placesBy(links, (i) => keyOf(links.operand[i], links.dimension[i], links.source[i]));
    const places = this.#bySource.get(keyOf(operand, ...checkEntity(entity, this.#operands[operand], 'entity'))) ?? [];
    return places.map((i) => ({ dimension: dimensions[links.dimension[i]], id: links.result[i], measure: links.measure[i] }));
  }
}
