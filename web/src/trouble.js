// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page keeps of an error.
// @ts-check

import { EngineError } from './engine.js';

/** Did the person not want to wait any longer? @param {unknown} error */
export const isCancelled = (error) => error instanceof EngineError && error.code === 'CANCELLED';

/**
 * @param {unknown} error
 * @param {string} about
 * @returns {import('./protocol.js').Trouble}
 */
export function troubleOf(error, about) {
  if (error instanceof EngineError) return { code: error.code, message: error.message, details: error.details, about };
  return { code: 'INTERNAL_ERROR', message: error instanceof Error ? error.message : String(error), details: {}, about };
}
