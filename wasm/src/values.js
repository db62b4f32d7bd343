// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a value handed in by a caller is.
// @ts-check

/** Is it a typed array of numbers? @param {unknown} value */
export function isNumberArray(value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView) && !(value instanceof BigInt64Array) && !(value instanceof BigUint64Array);
}

/** What a value is, in words for an error message. @param {unknown} value */
export function describe(value) {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  if (typeof value === 'string') return `the string ${JSON.stringify(value.slice(0, 40))}`;
  if (typeof value !== 'object') return `${typeof value} ${String(value)}`;
  return `an object of type ${value.constructor?.name ?? 'Object'}`;
}
