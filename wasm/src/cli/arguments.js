// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reads a verb's command line: options in the order typed, and values that begin with a minus sign.
// @ts-check

import { parseArgs } from 'node:util';

import { invalidArgument } from '../errors.js';

/**
 * @typedef {{ type: 'string' | 'boolean', short?: string }} Option
 * @typedef {{ name: string, value: string }} TypedOption
 * @typedef {{ positionals: string[], values: Record<string, any>, typed: TypedOption[] }} Arguments
 */

/**
 * Joins `--translate -1,2,3` into `--translate=-1,2,3`: parseArgs takes the second word for an option.
 * @param {string[]} argv
 * @param {Record<string, Option>} options
 */
function joinNegativeValues(argv, options) {
  /** @type {string[]} */
  const joined = [];
  for (const word of argv) {
    const before = joined.at(-1) ?? '';
    const takesValue = before.startsWith('--') && options[before.slice(2)]?.type === 'string';
    if (takesValue && /^-[\d.]/.test(word) && !joined.includes('--')) joined[joined.length - 1] = `${before}=${word}`;
    else joined.push(word);
  }
  return joined;
}

/**
 * @param {string[]} argv the words after the verb
 * @param {Record<string, Option>} options
 * @returns {Arguments}
 */
export function parseArguments(argv, options) {
  try {
    const { positionals, values, tokens } = parseArgs({ args: joinNegativeValues(argv, options), options, allowPositionals: true, tokens: true });
    const typed = tokens.flatMap((token) => (token.kind === 'option' && token.value !== undefined ? [{ name: token.name, value: token.value }] : []));
    return { positionals, values, typed };
  } catch (cause) {
    throw invalidArgument(/** @type {Error} */ (cause).message.split('. ')[0]);
  }
}

/**
 * @param {string} text
 * @param {string} option
 */
export function parseNumber(text, option) {
  const number = text.trim() === '' ? NaN : Number(text);
  if (!Number.isFinite(number)) throw invalidArgument(`--${option} needs a number, not '${text}'`);
  return number;
}

/**
 * The number of an option that may be missing.
 * @param {Arguments} args
 * @param {string} option
 */
export function parseOptional({ values }, option) {
  return values[option] === undefined ? undefined : parseNumber(values[option], option);
}

/**
 * @param {string} text "1,2,3"
 * @param {string} option
 * @param {number} count
 */
export function parseNumbers(text, option, count) {
  const parts = text.split(',');
  if (parts.length !== count) throw invalidArgument(`--${option} needs ${count} numbers with commas between them, not '${text}'`);
  return parts.map((part) => parseNumber(part, option));
}
