// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An error as data that can be sent to the page.
// @ts-check

import { MeshError } from 'mortise';

/**
 * @param {unknown} error
 * @returns {import('../protocol.js').PlainError}
 */
export function plainError(error) {
  if (error instanceof MeshError) return { code: error.code, message: error.message, details: error.details };
  const message = error instanceof Error ? error.message : String(error);
  return { code: 'INTERNAL_ERROR', message, details: {} };
}
