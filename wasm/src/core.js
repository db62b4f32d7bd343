// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Starts the WebAssembly core from compiled code. The glue is the same in Node, browsers and workers.
// @ts-check

import glue from '../dist/glue.mjs';
import { MeshError, invalidArgument } from './errors.js';

/** @typedef {import('./glue_types.js').Core} Core */

const createGlue = /** @type {import('./glue_types.js').CreateGlue} */ (/** @type {unknown} */ (glue));

/**
 * A running core.
 * @param {WebAssembly.Module} module
 * @returns {Promise<Core>}
 */
async function startCore(module) {
  /** @type {(reason: unknown) => void} */
  let fail = () => {};
  /** @type {Promise<never>} */
  const failed = new Promise((_, reject) => {
    fail = reject;
  });
  const started = createGlue({
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module), fail);
      return {};
    },
  });
  // A rejection inside the hook never reaches the factory's promise, hence the race.
  return Promise.race([started, failed]);
}

/**
 * Compiled code from what the caller hands in, or from where the package keeps its own.
 * @param {import('./index.js').LoadOptions} options
 * @param {(url: string | URL | undefined) => Promise<WebAssembly.Module>} compileFrom
 */
async function compiledModule({ wasmModule, wasmBinary, wasmUrl }, compileFrom) {
  if (wasmModule !== undefined) {
    if (!(wasmModule instanceof WebAssembly.Module)) throw invalidArgument('wasmModule must be a WebAssembly.Module');
    return wasmModule;
  }
  if (wasmBinary !== undefined) return WebAssembly.compile(/** @type {BufferSource} */ (wasmBinary));
  return compileFrom(wasmUrl);
}

/**
 * The one core of this program: `start` runs it at the first call, `forget` drops one that stopped. After a failed start and after
 * `forget` the next `start` begins anew.
 * @param {(url: string | URL | undefined) => Promise<WebAssembly.Module>} compileFrom
 * @returns {{ start: (options?: import('./index.js').LoadOptions) => Promise<Core>, forget: () => void }}
 */
export function coreLoader(compileFrom) {
  /** @type {Promise<Core> | undefined} */
  let core;
  const forget = () => {
    core = undefined;
  };
  return {
    start(options = {}) {
      core ??= compiledModule(options, compileFrom)
        .then(startCore)
        .catch((cause) => {
          forget();
          throw cause instanceof MeshError ? cause : new MeshError('FILE_FAILED', `the WebAssembly core does not start: ${cause?.message ?? cause}`, {}, { cause });
        });
      return core;
    },
    forget,
  };
}
