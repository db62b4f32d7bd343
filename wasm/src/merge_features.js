// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What is to be remeshed, without its small features.
// @ts-check

import { listenedTo } from './progress.js';

/** @typedef {import('./index.js').Mortise} Mortise */
/** @typedef {import('./model.js').Model<any>} AnyModel */

/** Further sources of facets, CSR. */
const otherSources = ['otherSourceOperand', 'otherSourceFace', 'otherSourceFlipped'];

/**
 * Values of an array at some places, in an array of its kind.
 * @param {any} array
 * @param {Iterable<number>} places
 */
const pick = (array, places) => array && array.constructor.from(places, (/** @type {number} */ i) => array[i]);

/**
 * What a provenance says of some triangles, in their order.
 * @param {any} provenance
 * @param {Uint32Array} triangles
 */
function provenanceOf(provenance, triangles) {
  const { sourceOperand, sourceFace, flipped, covering, coveringFront, coveringSets, otherSourceBegin: begin } = provenance;
  const ofTriangles = { sourceOperand: pick(sourceOperand, triangles), sourceFace: pick(sourceFace, triangles), flipped: pick(flipped, triangles), covering: pick(covering, triangles), coveringFront: pick(coveringFront, triangles), coveringSets };
  if (begin === undefined) return ofTriangles;
  /** @type {number[]} */
  const places = [];
  const otherSourceBegin = [0];
  for (const t of triangles) {
    for (let i = begin[t]; i < begin[t + 1]; ++i) places.push(i);
    otherSourceBegin.push(places.length);
  }
  return { ...ofTriangles, otherSourceBegin: Uint32Array.from(otherSourceBegin), ...Object.fromEntries(otherSources.map((name) => [name, pick(provenance[name], places)])) };
}

/** How a model was made of its mesh. @param {any} settings */
function waysOf({ faceAngle, weakAngle, edgeAngle, leastDangling, splitAtLabels, seams }) {
  return { faceAngle, weakAngle, edgeAngle, leastDangling, splitAtLabels, seams };
}

/**
 * A mesh, a result or a model as before, and what became of the triangles given. A model is one of a result then, with the attributes it had.
 * @param {{ ask: import('./mesh_operations.js').Ask, resultModel: Mortise['resultModel'] }} core
 * @param {{ about: import('./glue_types.js').GivenModel, provenance: any, model?: AnyModel }} asked
 * @param {{ least: number | undefined, listening: any }} how
 */
export function mergeFeatures({ ask, resultModel }, { about, provenance, model }, { least, listening }) {
  const { mesh, sources, ...merged } = listenedTo(listening, (listener) => ask((core) => core.mergeFeatures(about, { least, listener }), [about.mesh]));
  const left = provenance && provenanceOf(provenance, sources);
  const after = { provenance: left, sources, merged };
  if (model === undefined) return { ...after, given: left === undefined ? mesh : { mesh, provenance: left } };
  const origin = /** @type {any} */ ({ sourceOperand: new Uint32Array(sources.length), sourceFace: sources, flipped: new Uint8Array(sources.length) });
  return { ...after, given: resultModel({ mesh, provenance: origin }, [model], waysOf(about.settings)) };
}
