// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Calls that report how far they are and can be cancelled.
// @ts-check

import { checkProgress } from './arguments.js';
import { MeshError } from './errors.js';

/**
 * Keeps an exception of the caller's callback out of the core: it cancels the call and is thrown again outside.
 * @param {((stage: string, fraction: number) => boolean) | undefined} progress
 */
function guardProgress(progress) {
  /** @type {{ thrown?: { cause: unknown } }} */
  const state = {};
  const report = progress && ((/** @type {string} */ stage, /** @type {number} */ fraction) => {
    try {
      return progress(stage, fraction);
    } catch (cause) {
      state.thrown = { cause };
      return false;
    }
  });
  return { report, state };
}

/**
 * The answer of a call that is handed a listener for the core, or none when nobody listens.
 * @template Result
 * @param {{ onProgress?: unknown, signal?: any }} options
 * @param {(listener: ((stage: string, fraction: number) => boolean) | undefined) => Result} call
 * @returns {Result}
 */
export function listenedTo(options, call) {
  const { report, state } = guardProgress(checkProgress(options));
  try {
    return call(report);
  } catch (error) {
    if (state.thrown !== undefined) throw state.thrown.cause;
    if (error instanceof MeshError && error.code === 'CANCELLED') error.cause = options.signal?.reason;
    throw error;
  }
}
