// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The worker as seen from the page: calls are promises. A busy worker hears nothing, so cancelling stops it and starts another one from
// the code the first one compiled. What a call needs comes with it: the new worker has no memory of the old one.
// @ts-check

/** @typedef {import('./protocol.js').Calls} Calls */
/** @typedef {import('./protocol.js').Progress} Progress */
/** @typedef {import('./protocol.js').Request} Request */

/** An error of the worker. */
export class EngineError extends Error {
  /** @param {import('./protocol.js').PlainError} error */
  constructor({ code, message, details }) {
    super(message);
    this.code = code;
    this.details = details;
  }
}

/**
 * @typedef {object} Waiting
 * @property {Request} request
 * @property {(value: any) => void} resolve
 * @property {(error: EngineError) => void} reject
 * @property {(progress: Progress) => void} [onProgress]
 */

/** What the person waits for. The others are short, and asked of the next worker again. @type {(keyof Calls)[]} */
const cancellable = ['start', 'load', 'evaluate', 'remesh'];

/** Starts the worker. */
export function startEngine() {
  /** @type {Map<number, Waiting>} */
  const waiting = new Map();
  /** @type {WebAssembly.Module | undefined} */
  let wasmModule;
  let lastId = 0;
  let worker = startWorker();

  function startWorker() {
    const started = new Worker(new URL('./worker/main.js', import.meta.url), { type: 'module' });
    started.onmessage = receive;
    started.onerror = ({ message }) => rejectAll({ code: 'INTERNAL_ERROR', message: `the worker stopped: ${message ?? 'it could not be loaded'}`, details: {} });
    return started;
  }

  /** @param {MessageEvent<import('./protocol.js').Answer>} event */
  function receive({ data }) {
    const call = waiting.get(data.id);
    if ('progress' in data) return call?.onProgress?.(data.progress);
    waiting.delete(data.id);
    if ('error' in data) return call?.reject(new EngineError(data.error));
    return call?.resolve(data.value);
  }

  /** @param {import('./protocol.js').PlainError} error @param {(name: keyof Calls) => boolean} [concerns] */
  function rejectAll(error, concerns = () => true) {
    for (const [id, { request, reject }] of waiting) {
      if (!concerns(request.name)) continue;
      waiting.delete(id);
      reject(new EngineError(error));
    }
  }

  /** The code is kept for the next worker. A core that cannot be had is reported by the calls that need it. */
  function handOverCore() {
    call('start', { wasmModule }).then(
      (compiled) => (wasmModule = compiled),
      () => {},
    );
  }

  /**
   * @template {keyof Calls} Name
   * @param {Name} name
   * @param {Calls[Name][0]} args
   * @param {{ onProgress?: (progress: Progress) => void }} [options]
   * @returns {Promise<Calls[Name][1]>}
   */
  function call(name, args, { onProgress } = {}) {
    const request = { id: ++lastId, name, args };
    return new Promise((resolve, reject) => {
      waiting.set(request.id, { request, resolve, reject, onProgress });
      worker.postMessage(request);
    });
  }

  /** Whatever is being read or computed is rejected as CANCELLED, at once. @param {(keyof Calls)[]} [names] of the calls that are not wanted any more */
  function cancel(names = cancellable) {
    worker.onmessage = worker.onerror = null;
    worker.terminate();
    rejectAll({ code: 'CANCELLED', message: 'cancelled', details: {} }, (name) => names.includes(name));
    worker = startWorker();
    const kept = [...waiting.values()];
    handOverCore();
    for (const { request } of kept) worker.postMessage(request);
  }

  handOverCore();
  return { call, cancel };
}

/** @typedef {ReturnType<typeof startEngine>} Engine */
