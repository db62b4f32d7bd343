// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the chosen operand is, in numbers.
// @ts-check

import { byId } from '../dom.js';
import { letterOf } from '../model.js';
import { digitsFor, unmoved } from '../placement.js';

/** @typedef {import('../model.js').Model} Model */

const fields = /** @type {const} */ (['move', 'turn', 'scale']);
const axes = ['x', 'y', 'z'];

/** @param {HTMLInputElement} input @param {number} value */
function show(input, value) {
  if (input !== document.activeElement || Number(input.value) !== value) input.value = String(value);
}

/** @param {Model} model @param {typeof fields[number]} field @param {number} axis */
function startField(model, field, axis) {
  const input = byId(`${field}-${axes[axis]}`, HTMLInputElement);
  input.addEventListener('input', () => {
    const value = input.valueAsNumber;
    if (!Number.isFinite(value) || (field === 'scale' && value <= 0) || model.chosenOperand === undefined) return;
    model.chosenOperand.placement[field][axis] = value;
    model.tell('placement');
  });
  model.on(['operands', 'chosen', 'placement'], () => show(input, model.chosenOperand?.placement[field][axis] ?? 0));
  input.addEventListener('blur', () => show(input, model.chosenOperand?.placement[field][axis] ?? 0));
  return input;
}

/** @param {Model} model */
export function startPlacementFields(model) {
  const inputs = fields.map((field) => axes.map((_, axis) => startField(model, field, axis)));
  model.on(['operands', 'chosen'], () => {
    byId('placement-part').textContent = letterOf(model.chosen);
    const digits = digitsFor(Math.max(...(model.chosenOperand?.size ?? [1])));
    for (const input of inputs[0]) input.step = String(Number(`1e${3 - digits}`));
  });
  byId('reset').addEventListener('click', () => {
    if (model.chosenOperand === undefined) return;
    model.chosenOperand.placement = unmoved();
    model.tell('placement');
  });
}
