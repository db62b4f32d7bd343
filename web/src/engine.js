// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The worker as seen from the page: calls are promises.
// @ts-check

/** @typedef {import('./protocol.js').Calls} Calls */
/** @typedef {import('./protocol.js').Progress} Progress */

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
 * @property {(value: any) => void} resolve
 * @property {(error: EngineError) => void} reject
 * @property {(progress: Progress) => void} [onProgress]
 */

/** Starts the worker. */
export function startEngine() {
  const worker = new Worker(new URL('./worker/main.js', import.meta.url), { type: 'module' });
  /** @type {Map<number, Waiting>} */
  const waiting = new Map();
  let lastId = 0;

  /** @param {MessageEvent<import('./protocol.js').Answer>} event */
  worker.onmessage = ({ data }) => {
    const call = waiting.get(data.id);
    if ('progress' in data) return call?.onProgress?.(data.progress);
    waiting.delete(data.id);
    if ('error' in data) return call?.reject(new EngineError(data.error));
    return call?.resolve(data.value);
  };
  worker.onerror = (event) => {
    const error = new EngineError({ code: 'INTERNAL_ERROR', message: `the worker stopped: ${event.message ?? 'it could not be loaded'}`, details: {} });
    for (const call of waiting.values()) call.reject(error);
    waiting.clear();
  };

  /**
   * @template {keyof Calls} Name
   * @param {Name} name
   * @param {Calls[Name][0]} args
   * @param {{ transfer?: ArrayBuffer[], onProgress?: (progress: Progress) => void }} [options]
   * @returns {Promise<Calls[Name][1]>}
   */
  function call(name, args, { transfer = [], onProgress } = {}) {
    const id = ++lastId;
    return new Promise((resolve, reject) => {
      waiting.set(id, { resolve, reject, onProgress });
      worker.postMessage({ id, name, args }, transfer);
    });
  }
  return { call };
}

/** @typedef {ReturnType<typeof startEngine>} Engine */
