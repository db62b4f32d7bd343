// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Has the worker make or read operands.
// @ts-check

import { unmoved } from './placement.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./protocol.js').Operand} Operand */

let lastKey = 0;

/**
 * @param {Engine} engine
 * @param {import('./protocol.js').Source} source
 * @param {import('./protocol.js').Placement} [placement]
 * @returns {Promise<Operand>}
 */
export async function loadOperand(engine, source, placement = unmoved()) {
  const key = ++lastKey;
  const loaded = await engine.call('load', { key, source });
  return { ...loaded, key, name: source.name, source, placement };
}

/** @param {Engine} engine @param {Operand[]} operands */
export function forgetOperands(engine, operands) {
  if (operands.length > 0) void engine.call('forget', { keys: operands.map(({ key }) => key) });
}

/**
 * Reads one file after the other; at the first bad one `fail` is called and nothing is kept.
 * @param {Engine} engine
 * @param {File[]} files
 * @param {{ begin: (file: File) => void, fail: (error: unknown, file: File) => void }} listener
 * @returns {Promise<Operand[]>} empty after a failure
 */
export async function readOperands(engine, files, { begin, fail }) {
  /** @type {Operand[]} */
  const loaded = [];
  for (const file of files) {
    begin(file);
    try {
      loaded.push(await loadOperand(engine, { kind: 'file', name: file.name, file }));
    } catch (error) {
      fail(error, file);
      forgetOperands(engine, loaded);
      return [];
    }
  }
  return loaded;
}
