// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The package in Node: core.wasm and mesh files are read from disk.
// @ts-check

import { readFile } from 'node:fs/promises';

import { createAsyncApi } from './async_api.js';
import { readBytes, writeBytes } from './node_files.js';

/** @param {string | URL | undefined} wasmUrl */
async function compileFrom(wasmUrl) {
  return WebAssembly.compile(await readFile(wasmUrl ?? new URL('../dist/core.wasm', import.meta.url)));
}

/** @type {import('./mesh_files.js').Host} */
const host = { readFile: readBytes, writeFile: writeBytes };

export const { union, intersect, subtract, symmetricDifference, partition, combine, keep, imprint, implant, resolve, prepare, inspect, model, resultModel, readModel, writeModel, gmshProject, transform, roundToFloat32, make, split, splitPinches, repair, extrudeTo, sizing, remesh, predictTriangles, quality, slice, cornersToVertices, groupByLabel, readMesh, writeMesh, load } =
  createAsyncApi(compileFrom, host);
export { MeshError } from './errors.js';
