// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the exit status of the command says.
// @ts-check

export const exitCode = { ok: 0, checkFailed: 1, usage: 2, badInput: 3, refused: 4, cancelled: 130 };

/** @type {Record<import('../index.js').MeshErrorCode, number>} */
const byError = {
  INVALID_ARGUMENT: exitCode.usage,
  NOT_FINITE: exitCode.badInput,
  BAD_INDEX: exitCode.badInput,
  NOT_CLOSED: exitCode.badInput,
  NOT_ORIENTED: exitCode.badInput,
  INSIDE_OUT: exitCode.badInput,
  OUT_OF_RANGE: exitCode.refused,
  RESULT_TOO_LARGE: exitCode.refused,
  PARSE_FAILED: exitCode.badInput,
  UNKNOWN_FORMAT: exitCode.badInput,
  FILE_FAILED: exitCode.badInput,
  CANCELLED: exitCode.cancelled,
  OUT_OF_MEMORY: exitCode.refused,
  INTERNAL_ERROR: exitCode.checkFailed,
};

/**
 * @param {import('../index.js').MeshErrorCode} code
 * @returns {number}
 */
export function exitCodeOf(code) {
  return byError[code] ?? exitCode.checkFailed;
}
