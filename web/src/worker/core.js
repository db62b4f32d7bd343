// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh core of this worker. Its compiled code comes from the page, which has it from an earlier worker, or else is fetched.
// @ts-check

import { load, MeshError } from 'mortise';
import coreUrl from 'mortise/core.wasm?url';

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

async function fetchCore() {
  const response = await fetch(coreUrl);
  if (!response.ok) throw new MeshError('FILE_FAILED', `cannot fetch ${coreUrl} (HTTP ${response.status})`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** The compiled code. After a failure the next call tries again. @param {WebAssembly.Module} [given] */
export function compiledCore(given) {
  if (given !== undefined) compiled = Promise.resolve(given);
  compiled ??= fetchCore().catch((error) => {
    compiled = undefined;
    throw error;
  });
  return compiled;
}

/** The functions of the package; after a trap those of a new core. */
export async function runningCore() {
  return load({ wasmModule: await compiledCore() });
}
