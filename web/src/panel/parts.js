// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The list of operands: one is chosen.
// @ts-check

import { byId, make } from '../dom.js';
import { letterOf } from '../model.js';
import { plural } from '../numbers.js';

/** @typedef {import('../model.js').Model} Model */

/** @param {Model} model @param {number} position */
function row(model, position) {
  const { name, triangles } = model.operands[position];
  const radio = make('input', { type: 'radio', name: 'part', value: String(position) });
  radio.checked = position === model.chosen;
  radio.addEventListener('change', () => model.choose(position));
  const swatch = make('span', { class: `swatch swatch-${position % 8}` }, letterOf(position));
  const text = make('span', { class: 'part-name' }, name);
  text.title = name;
  return make('label', { class: 'part' }, radio, swatch, text, make('span', { class: 'part-size' }, plural(triangles, 'triangle')));
}

/** @param {Model} model @param {import('../operands.js').Operands} operands */
export function startParts(model, operands) {
  const list = byId('parts');
  const remove = byId('remove', HTMLButtonElement);
  model.on('operands', () => {
    const hadFocus = list.contains(document.activeElement);
    list.replaceChildren(...model.operands.map((_, position) => row(model, position)));
    if (hadFocus) list.querySelectorAll('input')[model.chosen]?.focus();
    remove.disabled = model.operands.length < 2;
  });
  model.on('chosen', () => {
    list.querySelectorAll('input').forEach((radio, position) => (radio.checked = position === model.chosen));
  });
  model.on(['operands', 'chosen'], () => {
    byId('drop-target').textContent = letterOf(model.chosen);
    remove.textContent = `Remove ${letterOf(model.chosen)}`;
  });
  remove.addEventListener('click', () => operands.remove());
  byId('samples').addEventListener('click', () => void operands.openSamples());
}
