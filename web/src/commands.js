// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The page's state as command lines: typed in a folder with the same files, they give the same result.
// @ts-check

import { choices, inOrder } from './choices.js';
import { letterOf } from './model.js';
import { stepsOf } from './placement.js';

/** @typedef {import('./protocol.js').Operand} Operand */

/** `majorRadius`, `rotateX` as options: `major-radius`, `rotate-x`. @param {string} name */
const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** A word for the shell. @param {string} word */
function quoted(word) {
  const safe = word.startsWith('-') ? `./${word}` : word;
  return /^[\w./-]+$/.test(safe) ? safe : `'${safe.replaceAll("'", "'\\''")}'`;
}

/** @param {[string, number | readonly number[] | string]} entry */
const option = ([name, value]) => `--${kebab(name)}=${[value].flat().join(',')}`;

/** @param {Operand} operand @param {string} file */
function makeLine({ source }, file) {
  if (source.kind === 'file') return [];
  return [['npx mortise make', kebab(source.shape), ...Object.entries(source.parameters).map(option), '-o', file].join(' ')];
}

/**
 * The file of an operand where it is placed, and the lines that make it.
 * @param {Operand} operand
 * @param {number} position
 */
function operandLines(operand, position) {
  const letter = letterOf(position).toLowerCase().replace('#', 'part-');
  const original = operand.source.kind === 'file' ? quoted(operand.source.name) : `${letter}.ply`;
  const lines = makeLine(operand, original);
  const steps = stepsOf(operand.placement, operand.display.origin).flatMap((step) => Object.entries(step).map(option));
  if (steps.length === 0) return { file: original, lines };
  const file = `${letter}-placed.ply`;
  return { file, lines: [...lines, ['npx mortise transform', original, ...steps, '-o', file].join(' ')] };
}

/** @param {Pick<import('./model.js').Model, 'operands' | 'choice'>} model */
export function commandsOf({ operands, choice }) {
  const made = operands.map(operandLines);
  const files = inOrder(choice, made).map(({ file }) => file);
  return [...made.flatMap(({ lines }) => lines), ['npx mortise', choices[choice].operation, ...files, '-o', 'result.ply'].join(' ')];
}
