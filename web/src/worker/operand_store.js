// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operands in doubles. Each remembers how it was placed last: while one part is dragged the others are not moved again.
// @ts-check

import { MeshError } from 'mortise';

import { faceNormals } from './shading.js';

/** @typedef {import('mortise').Mesh} Mesh */
/** @typedef {import('mortise').Mortise} Mortise */
/** @typedef {import('../protocol.js').PlacedOperand} PlacedOperand */
/** @typedef {{ mesh: Mesh, normals: Float32Array }} Shaped a mesh with the normals of its faces */
/** @typedef {{ original: Shaped, placed: Shaped, steps: string }} Stored */

/** @type {Map<number, Stored>} */
const store = new Map();

/** @param {Mesh} mesh @returns {Shaped} */
const shaped = (mesh) => ({ mesh, normals: faceNormals(mesh) });

/** @param {File} file */
async function bytesOf(file) {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    throw new MeshError('FILE_FAILED', 'the file cannot be read: changed or moved since it was chosen, or a folder? Drop it once more', {}, { cause });
  }
}

/**
 * @param {Mortise} mortise
 * @param {number} key
 * @param {import('../protocol.js').Source} source
 */
export async function loadOperand(mortise, key, source) {
  const isFile = source.kind === 'file';
  const mesh = isFile ? mortise.readMesh(await bytesOf(source.file), { name: source.name }) : mortise.make(source.shape, source.parameters);
  const original = shaped(mesh);
  store.set(key, { original, placed: original, steps: '[]' });
  return original;
}

/** @param {number} key */
export function forgetOperand(key) {
  store.delete(key);
}

/** @param {Mortise} mortise @param {PlacedOperand} operand */
async function placeOperand(mortise, { key, source, steps }) {
  if (!store.has(key)) await loadOperand(mortise, key, source);
  const operand = /** @type {Stored} */ (store.get(key));
  const wanted = JSON.stringify(steps);
  if (operand.steps !== wanted) {
    operand.placed = steps.length === 0 ? operand.original : shaped(mortise.transform(operand.original.mesh, steps));
    operand.steps = wanted;
  }
  return operand.placed;
}

/**
 * The operands where they are wanted; an error says which of them it is about.
 * @param {Mortise} mortise
 * @param {PlacedOperand[]} operands
 */
export async function placeOperands(mortise, operands) {
  const placed = [];
  for (const [position, operand] of operands.entries()) {
    try {
      placed.push(await placeOperand(mortise, operand));
    } catch (error) {
      if (error instanceof MeshError) error.details = { ...error.details, operand: position };
      throw error;
    }
  }
  return placed;
}
