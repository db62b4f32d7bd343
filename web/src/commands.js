// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The page's state as command lines: typed in a folder with the same files, they give the same result.
// @ts-check

import { choices, inOrder } from './choices.js';
import { letterOf } from './model.js';
import { stepsOf } from './placement.js';
import { isForCommand } from './remesh_wish.js';

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

/** A name that is none of those taken: no file of the person is overwritten. @param {string} stem @param {string[]} taken */
function freeName(stem, taken) {
  let name = `${stem}.ply`;
  for (let i = 2; taken.includes(name); ++i) name = `${stem}-${i}.ply`;
  return name;
}

/**
 * The file of an operand where it is placed, and the lines that make it.
 * @param {Operand} operand
 * @param {string} letter
 * @param {string[]} taken names of files
 */
function operandLines({ source, placement, display }, letter, taken) {
  const original = source.kind === 'file' ? quoted(source.name) : freeName(letter, taken);
  const made = source.kind === 'file' ? [] : [['npx mortise make', kebab(source.shape), ...Object.entries(source.parameters).map(option), '-o', original].join(' ')];
  const steps = stepsOf(placement, display.origin).flatMap((step) => Object.entries(step).map(option));
  if (steps.length === 0) return { file: original, lines: made };
  const file = freeName(`${letter}-placed`, taken);
  return { file, lines: [...made, ['npx mortise transform', original, ...steps, '-o', file].join(' ')] };
}

/** What the command is told of remeshing; nothing when it has no words for the wish. @param {import('./protocol.js').RemeshWish | undefined} wish */
function remeshOptions(wish) {
  if (wish === undefined || !isForCommand(wish)) return [];
  return [option(['remesh', wish.size]), ...(wish.layers > 0 ? [option(['layers', wish.layers])] : [])];
}

/**
 * @param {Pick<import('./model.js').Model, 'operands' | 'choice'>} model
 * @param {import('./protocol.js').RemeshWish} [wish] when the result was remeshed
 */
export function commandsOf({ operands, choice }, wish) {
  const taken = operands.map(({ source }) => (source.kind === 'file' ? source.name : ''));
  const made = operands.map((operand, position) => operandLines(operand, letterOf(position).toLowerCase().replace('#', 'part-'), taken));
  const files = inOrder(choice, made).map(({ file }) => file);
  const last = ['npx mortise', choices[choice].operation, ...files, '-o', freeName('result', taken), ...remeshOptions(wish)].join(' ');
  return [...made.flatMap(({ lines }) => lines), last];
}
