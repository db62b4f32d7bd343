// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page can ask for.
// @ts-check

import { load as loadCore } from 'mortise';

import { displayOf, relativeSegments, sizeOf } from './display.js';
import { addOperand, forgetOperand, placeOperand } from './operand_store.js';
import { normalsFromSources } from './shading.js';

/** @typedef {import('../protocol.js').Calls} Calls */
/** @typedef {import('../protocol.js').Display} Display */

/** @type {import('../protocol.js').Kept} */
let lastResult;

/**
 * @template Value
 * @param {Value} value
 * @param {ArrayBuffer[]} [transfer]
 * @returns {import('../protocol.js').Parcel<Value>}
 */
const parcel = (value, transfer = []) => ({ value, transfer });

/** @param {Display} display */
const buffersOf = ({ positions, normals }) => /** @type {ArrayBuffer[]} */ ([positions.buffer, normals.buffer]);

/**
 * @param {import('mortise').Mortise} mortise
 * @param {import('../protocol.js').Source} source
 */
function meshOf(mortise, source) {
  if (source.kind === 'file') return mortise.readMesh(source.bytes, { name: source.name });
  return mortise.make(source.shape, source.parameters);
}

/** @param {Calls['load'][0]} args */
async function load({ key, source }) {
  const { mesh, normals } = addOperand(key, meshOf(await loadCore(), source));
  const display = displayOf(mesh, normals);
  const value = { vertices: mesh.positions.length / 3, triangles: mesh.triangles.length / 3, size: sizeOf(mesh.positions), display };
  return parcel(value, buffersOf(display));
}

/** @param {Calls['forget'][0]} args */
async function forget({ keys }) {
  keys.forEach(forgetOperand);
  return parcel(null);
}

/**
 * @param {Calls['evaluate'][0]} args
 * @param {(progress: import('../protocol.js').Progress) => void} tell
 */
async function evaluate({ operation, operands }, tell) {
  const mortise = await loadCore();
  const placed = operands.map(({ key, steps }) => placeOperand(mortise, key, steps));
  const { mesh, report, graph, provenance } = mortise[operation](placed.map((operand) => operand.mesh), { onProgress: tell });
  lastResult = mesh;
  const normals = normalsFromSources(provenance, placed.map((operand) => operand.normals));
  const display = displayOf(mesh, normals, provenance.sourceOperand);
  const segments = relativeSegments(graph, display.origin);
  return parcel({ report, display, graph: segments }, [...buffersOf(display), /** @type {ArrayBuffer} */ (segments.buffer)]);
}

/** Binary STL holds float32: the mesh is rounded as a whole, so that it stays welded. @param {Calls['write'][0]} args */
async function write({ format }) {
  const mortise = await loadCore();
  if (lastResult === undefined) throw new Error('there is no result to write');
  const stored = format === 'stl' ? mortise.roundToFloat32(lastResult) : lastResult;
  const bytes = mortise.writeMesh(stored, { format });
  return parcel(bytes, [/** @type {ArrayBuffer} */ (bytes.buffer)]);
}

export const calls = { load, forget, evaluate, write };
