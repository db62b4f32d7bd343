// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page can ask for.
// @ts-check

import { compiledCore, runningCore } from './core.js';
import { displayOf, relativeSegments, sizeOf } from './display.js';
import { forgetOperand, loadOperand, placeOperands } from './operand_store.js';
import { predictMade, remeshMade } from './remeshing.js';
import { normalsFromSources } from './shading.js';

/** @typedef {import('../protocol.js').Calls} Calls */

/**
 * @template Value
 * @param {Value} value
 * @param {(ArrayBufferView | undefined)[]} [arrays] that are handed over with it
 * @returns {import('../protocol.js').Parcel<Value>}
 */
function parcel(value, arrays = []) {
  return { value, transfer: arrays.flatMap((array) => (array === undefined ? [] : [/** @type {ArrayBuffer} */ (array.buffer)])) };
}

/** @param {Calls['start'][0]} args */
async function start({ wasmModule }) {
  return parcel(await compiledCore(wasmModule));
}

/** @param {Calls['load'][0]} args */
async function load({ key, source }) {
  const { mesh, normals } = await loadOperand(await runningCore(), key, source);
  const display = displayOf(mesh, normals);
  const value = { vertices: mesh.positions.length / 3, triangles: mesh.triangles.length / 3, size: sizeOf(mesh.positions), display };
  return parcel(value, [display.positions, display.normals]);
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
async function evaluate({ operation, operands, inspect }, tell) {
  const mortise = await runningCore();
  const placed = await placeOperands(mortise, operands);
  const { mesh, report, graph, provenance } = mortise[operation](placed.map((operand) => operand.mesh), { onProgress: tell, inspect, kind: 'solid' });
  const normals = normalsFromSources(provenance, placed.map((operand) => operand.normals));
  const display = displayOf(mesh, normals, provenance.sourceOperand);
  const segments = relativeSegments(graph, display.origin);
  const curves = { points: graph.points, edges: graph.edges };
  const origins = Object.values(provenance).filter((array) => ArrayBuffer.isView(array));
  const arrays = [mesh.positions, mesh.triangles, mesh.faceLabels, curves.points, curves.edges, display.positions, display.normals, segments, ...origins];
  return parcel({ mesh, provenance, curves, report, display, graph: segments }, arrays);
}

/** @param {Calls['predict'][0]} args */
async function predict({ made, operands, wish }) {
  const mortise = await runningCore();
  return parcel(predictMade(mortise, { made, placed: await placeOperands(mortise, operands), wish }));
}

/**
 * @param {Calls['remesh'][0]} args
 * @param {(progress: import('../protocol.js').Progress) => void} tell
 */
async function remesh({ made, operands, wish, origin }, tell) {
  const mortise = await runningCore();
  const placed = await placeOperands(mortise, operands);
  const value = remeshMade(mortise, { made, placed, wish, origin }, tell);
  const { mesh, display, before, after } = value;
  return parcel(value, [mesh.positions, mesh.triangles, mesh.faceLabels, display.positions, display.normals, before.bins, after.bins]);
}

/** Binary STL holds float32: the mesh is rounded as a whole, so that it stays welded. @param {Calls['write'][0]} args */
async function write({ mesh, format }) {
  const mortise = await runningCore();
  const bytes = mortise.writeMesh(format === 'stl' ? mortise.roundToFloat32(mesh) : mesh, { format });
  return parcel(bytes, [bytes]);
}

export const calls = { start, load, forget, evaluate, predict, remesh, write };
