// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Before and after remeshing: which of them is looked at, and their numbers side by side.
// @ts-check

import { buttonsWith, byId, make } from '../dom.js';
import { count, measure, plural } from '../numbers.js';
import { startHistogram } from './histogram.js';
import { number } from './report.js';

/** @typedef {import('../model.js').Model} Model */
/** @typedef {import('../protocol.js').TriangleNumbers} TriangleNumbers */

/** @param {number} share */
const percent = (share) => `${measure(100 * share, 3)} %`;

/** Their names, values, words, and what they mean. @type {[string, (numbers: TriangleNumbers) => number, (value: number) => string, string][]} */
const rows = [
  ['Triangles', ({ triangles }) => triangles, count, ''],
  ['Smallest angle', ({ minAngleDeg }) => minAngleDeg, (value) => `${measure(value, 3)}°`, ''],
  ['Largest angle', ({ maxAngleDeg }) => maxAngleDeg, (value) => `${measure(value, 4)}°`, ''],
  ['Mean 2 r / R', ({ meanRadiusRatio }) => meanRadiusRatio, (value) => measure(value, 3), 'Of the circles in and round a triangle: 1 for an equilateral one'],
  ['Edges in the band', ({ inBand }) => inBand, percent, 'From 0.71 to 1.41 times as long as wanted'],
];

/** @param {Model} model */
function showComparison({ remeshed }) {
  byId('remeshed').hidden = byId('unremesh').hidden = remeshed === undefined;
  if (remeshed === undefined) return;
  const { before, after, kept, newCrossings } = remeshed;
  const lines = rows.map(([name, valueOf, textOf, title]) => {
    const cells = [before, after].map((numbers) => make('td', {}, number(valueOf(numbers), textOf(valueOf(numbers)))));
    return make('tr', {}, make('th', title === '' ? { scope: 'row' } : { scope: 'row', title }, name), ...cells);
  });
  byId('comparison').replaceChildren(...lines);
  const crossings = newCrossings === 0 ? 'No new crossings' : plural(newCrossings, 'new crossing');
  const stay = kept === 0 ? 'no triangle had to stay' : `${plural(kept, 'triangle')} had to stay`;
  byId('remesh-notes').textContent = `${crossings}, ${stay}.`;
}

/** @param {Model} model */
function startSides(model) {
  const sides = buttonsWith('side');
  for (const [side, button] of sides) {
    button.addEventListener('click', () => {
      model.looksBack = side === 'before';
      model.tell('remeshed');
    });
  }
  model.on('remeshed', () => {
    for (const [side, button] of sides) button.setAttribute('aria-pressed', String(model.looksBack === (side === 'before')));
  });
}

/** @param {Model} model */
export function startRemeshComparison(model) {
  model.on('remeshed', () => showComparison(model));
  byId('unremesh').addEventListener('click', () => {
    model.tell('unremesh');
    byId('remesh').focus();
  });
  startSides(model);
  startHistogram(model);
}
