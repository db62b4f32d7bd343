// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The one error type users see. Copies of the package in one program recognise each other's errors.
// @ts-check

const brand = Symbol.for('mortise.MeshError');

/** Thrown by every function of the package. `code` is for programs, `message` for people, `details` says where. */
export class MeshError extends Error {
  /**
   * @param {import('./index.js').MeshErrorCode} code
   * @param {string} message
   * @param {import('./index.js').MeshErrorDetails} [details]
   * @param {{ cause?: unknown }} [options]
   */
  constructor(code, message, details = {}, options = undefined) {
    super(message, options);
    this.name = 'MeshError';
    this.code = code;
    this.details = details;
    Object.defineProperty(this, brand, { value: true });
  }

  /** @param {unknown} value @returns {value is MeshError} */
  static [Symbol.hasInstance](value) {
    return typeof value === 'object' && value !== null && brand in value;
  }
}

/**
 * An error about how a function was called.
 * @param {string} message
 * @param {import('./index.js').MeshErrorDetails} [details]
 */
export function invalidArgument(message, details = undefined) {
  return new MeshError('INVALID_ARGUMENT', message, details);
}
