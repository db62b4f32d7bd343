// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The package in browsers and their workers: core.wasm is fetched, files are bytes or Blobs.
// @ts-check

import { createAsyncApi } from './async_api.js';
import { MeshError, invalidArgument } from './errors.js';

/** @param {string | URL | undefined} wasmUrl */
async function compileFrom(wasmUrl) {
  const url = wasmUrl ?? new URL('../dist/core.wasm', import.meta.url);
  const response = await fetch(url);
  if (!response.ok) throw new MeshError('FILE_FAILED', `cannot fetch ${url} (HTTP ${response.status}): is this where your site serves core.wasm?`);
  const type = response.headers.get('content-type') ?? '';
  if (type.startsWith('application/wasm')) return WebAssembly.compileStreaming(response);
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (!isWasm(bytes)) throw new MeshError('FILE_FAILED', `${url} is not a WebAssembly file but ${type || 'something else'}: wrong address?`);
  return WebAssembly.compile(bytes);
}

/** @param {Uint8Array} bytes */
function isWasm(bytes) {
  return bytes[0] === 0x00 && bytes[1] === 0x61 && bytes[2] === 0x73 && bytes[3] === 0x6d;
}

/** @returns {never} */
function refusePath() {
  throw invalidArgument('there are no file names in a browser: pass bytes (Uint8Array, ArrayBuffer) or a Blob, and take bytes from writeMesh(mesh, {format})');
}

/** @type {import('./mesh_files.js').Host} */
const host = { readFile: refusePath, writeFile: refusePath };

export const { union, intersect, subtract, symmetricDifference, partition, combine, keep, imprint, implant, resolve, prepare, inspect, model, resultModel, readModel, writeModel, gmshProject, transform, roundToFloat32, make, split, splitPinches, repair, extrudeTo, sizing, remesh, predictTriangles, quality, slice, cornersToVertices, groupByLabel, readMesh, writeMesh, load } =
  createAsyncApi(compileFrom, host);
export { MeshError } from './errors.js';
