// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The size wanted at any point: a number in the core, asked through this.
// @ts-check

import { checkMesh, checkOptions } from './arguments.js';
import { invalidArgument } from './errors.js';
import { Kept } from './kept.js';
import { checkGrowth, checkModelOf, checkPoint, checkSize, checkSizeSources, checkSmallest } from './size_sources.js';
import { describe } from './values.js';

/** @typedef {import('./mesh_operations.js').Ask} Ask */
/** @typedef {import('./kept.js').Session} Session */
/** @typedef {import('./index.js').Box} Box */

/**
 * The box round all vertices; undefined when there are none.
 * @param {ArrayLike<number>} positions
 * @returns {Box | undefined}
 */
function boxRound(positions) {
  if (positions.length === 0) return undefined;
  /** @type {Box} */
  const box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let i = 0; i < positions.length; ++i) {
    box.min[i % 3] = Math.min(box.min[i % 3], positions[i]);
    box.max[i % 3] = Math.max(box.max[i % 3], positions[i]);
  }
  return box;
}

export class Sizing extends Kept {
  #ask;
  #box;

  /**
   * @param {Session} session
   * @param {Ask} ask
   * @param {{ number: number, box: Box | undefined }} made
   */
  constructor(session, ask, { number, box }) {
    super({ session, number, forget: 'forgetSizing' });
    this.#ask = ask;
    this.#box = box;
  }

  /**
   * Its number in a core.
   * @param {Session} session
   * @param {string} name how the caller knows it
   */
  numberIn(session, name) {
    const handle = this.handleOf(name);
    if (handle.session !== session) throw invalidArgument(`${name} was made by another core, or one that stopped: make it again`);
    return handle.number;
  }

  /** @param {any} points */
  sizeAt(points) {
    const { number } = this.handleOf('the sizing');
    const isMany = points instanceof Float64Array || points instanceof Float32Array;
    if (isMany && points.length % 3 !== 0) throw invalidArgument(`sizeAt takes three numbers for each point, not ${points.length} in all`);
    const flat = isMany ? points : Float64Array.from(checkPoint(points, 'point'));
    const sizes = this.#ask((core) => core.sizesAt(number, flat));
    return isMany ? sizes : sizes[0];
  }

  /** @param {any} [box] */
  toGmshView(box = this.#box) {
    const { number } = this.handleOf('the sizing');
    if (box === undefined) throw invalidArgument('toGmshView needs a box {min, max}, or a sizing that was given a mesh or a model');
    if (typeof box !== 'object' || box === null) throw invalidArgument(`box must be {min, max}, not ${describe(box)}`);
    const corners = Float64Array.of(...checkPoint(box.min, 'box.min'), ...checkPoint(box.max, 'box.max'));
    return this.#ask((core) => core.gmshView(number, corners));
  }
}

/**
 * @param {Session} session
 * @param {Ask} ask
 * @param {any} options
 */
export function makeSizing(session, ask, options) {
  const { size, smallest = 0, growth = 1.2, sources = [], model, mesh } = checkOptions(options, ['size', 'smallest', 'growth', 'sources', 'model', 'mesh']);
  const limits = { size: checkSize(size, 'size'), smallest: checkSmallest(smallest, 'smallest') };
  if (smallest > size) throw invalidArgument(`smallest is ${smallest}, more than the size ${size}`);
  if (model !== undefined) checkModelOf(model, 'model');
  const about = mesh ?? model?.mesh;
  const box = about === undefined ? undefined : boxRound(checkMesh(about, 'mesh').positions);
  const request = checkSizeSources(sources, { growth: checkGrowth(growth, 'growth'), size, model, mesh });
  const number = ask((core) => core.makeSizing({ ...request, ...limits }));
  return new Sizing(session, ask, { number, box });
}
