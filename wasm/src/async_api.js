// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The functions as most programs call them: the core is loaded by the first call.
// @ts-check

import { coreLoader } from './core.js';
import { isBlob } from './mesh_files.js';
import { createSyncApi } from './sync_api.js';

/**
 * @param {(url: string | URL | undefined) => Promise<WebAssembly.Module>} compileFrom
 * @param {import('./mesh_files.js').Host} host
 */
export function createAsyncApi(compileFrom, host) {
  const loader = coreLoader(compileFrom);
  /** @type {WeakMap<object, import('./index.js').Mortise>} */
  const apis = new WeakMap();

  /** @type {typeof import('./index.js').load} */
  async function load(options) {
    const core = await loader.start(options);
    const api = apis.get(core) ?? createSyncApi(core, host, loader.forget);
    apis.set(core, api);
    return api;
  }

  /**
   * @template {keyof import('./index.js').Mortise} Name
   * @param {Name} name
   * @returns {any}
   */
  const later = (name) => async (/** @type {any[]} */ ...args) => /** @type {any} */ ((await load())[name])(...args);

  /**
   * The same for functions that read: bytes of a Blob have to be waited for.
   * @param {'readMesh' | 'readModel'} name
   * @returns {any}
   */
  const reader = (name) => async (/** @type {any} */ source, /** @type {any} */ options) => {
    const api = await load();
    if (!isBlob(source)) return api[name](source, options);
    const bytes = new Uint8Array(await source.arrayBuffer());
    return api[name](bytes, { ...(source instanceof File ? { name: source.name } : {}), ...options });
  };

  return {
    /** @type {typeof import('./index.js').union} */
    union: later('union'),
    /** @type {typeof import('./index.js').intersect} */
    intersect: later('intersect'),
    /** @type {typeof import('./index.js').subtract} */
    subtract: later('subtract'),
    /** @type {typeof import('./index.js').symmetricDifference} */
    symmetricDifference: later('symmetricDifference'),
    /** @type {typeof import('./index.js').partition} */
    partition: later('partition'),
    /** @type {typeof import('./index.js').combine} */
    combine: later('combine'),
    /** @type {typeof import('./index.js').keep} */
    keep: later('keep'),
    /** @type {typeof import('./index.js').imprint} */
    imprint: later('imprint'),
    /** @type {typeof import('./index.js').implant} */
    implant: later('implant'),
    /** @type {typeof import('./index.js').resolve} */
    resolve: later('resolve'),
    /** @type {typeof import('./index.js').prepare} */
    prepare: later('prepare'),
    /** @type {typeof import('./index.js').inspect} */
    inspect: later('inspect'),
    /** @type {typeof import('./index.js').transform} */
    transform: later('transform'),
    /** @type {typeof import('./index.js').roundToFloat32} */
    roundToFloat32: later('roundToFloat32'),
    /** @type {typeof import('./index.js').make} */
    make: later('make'),
    /** @type {typeof import('./index.js').split} */
    split: later('split'),
    /** @type {typeof import('./index.js').splitPinches} */
    splitPinches: later('splitPinches'),
    /** @type {typeof import('./index.js').repair} */
    repair: later('repair'),
    /** @type {typeof import('./index.js').extrudeTo} */
    extrudeTo: later('extrudeTo'),
    /** @type {typeof import('./index.js').model} */
    model: later('model'),
    /** @type {typeof import('./index.js').resultModel} */
    resultModel: later('resultModel'),
    /** @type {typeof import('./index.js').readModel} */
    readModel: reader('readModel'),
    /** @type {typeof import('./index.js').writeModel} */
    writeModel: later('writeModel'),
    /** @type {typeof import('./index.js').gmshProject} */
    gmshProject: later('gmshProject'),
    /** @type {typeof import('./index.js').sizing} */
    sizing: later('sizing'),
    /** @type {typeof import('./index.js').remesh} */
    remesh: later('remesh'),
    /** @type {typeof import('./index.js').predictTriangles} */
    predictTriangles: later('predictTriangles'),
    /** @type {typeof import('./index.js').quality} */
    quality: later('quality'),
    /** @type {typeof import('./index.js').slice} */
    slice: later('slice'),
    /** @type {typeof import('./index.js').cornersToVertices} */
    cornersToVertices: later('cornersToVertices'),
    /** @type {typeof import('./index.js').groupByLabel} */
    groupByLabel: later('groupByLabel'),
    /** @type {typeof import('./index.js').writeMesh} */
    writeMesh: later('writeMesh'),
    /** @type {typeof import('./index.js').readMesh} */
    readMesh: reader('readMesh'),
    load,
  };
}
