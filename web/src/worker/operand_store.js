// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operands in doubles. Each remembers how it was placed last: while one part is dragged the others are not moved again.
// @ts-check

import { faceNormals } from './shading.js';

/** @typedef {import('mortise').Mesh} Mesh */
/** @typedef {{ mesh: Mesh, normals: Float32Array }} Shaped a mesh with the normals of its faces */
/** @typedef {{ original: Shaped, placed: Shaped, steps: string }} Stored */

/** @type {Map<number, Stored>} */
const store = new Map();

/** @param {Mesh} mesh @returns {Shaped} */
const shaped = (mesh) => ({ mesh, normals: faceNormals(mesh) });

/** @param {number} key @param {Mesh} mesh */
export function addOperand(key, mesh) {
  const original = shaped(mesh);
  store.set(key, { original, placed: original, steps: '[]' });
  return original;
}

/** @param {number} key */
export function forgetOperand(key) {
  store.delete(key);
}

/**
 * @param {import('mortise').Mortise} mortise
 * @param {number} key
 * @param {import('mortise').TransformStep[]} steps
 */
export function placeOperand(mortise, key, steps) {
  const operand = store.get(key);
  if (operand === undefined) throw new Error(`there is no operand ${key}`);
  const wanted = JSON.stringify(steps);
  if (operand.steps !== wanted) {
    operand.placed = steps.length === 0 ? operand.original : shaped(mortise.transform(operand.original.mesh, steps));
    operand.steps = wanted;
  }
  return operand.placed;
}
