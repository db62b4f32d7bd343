// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Buttons of the operation, of the handle, and what is shown.
// @ts-check

import { titleOf } from '../choices.js';
import { buttonsWith, byId } from '../dom.js';

/** @typedef {import('../model.js').Model} Model */

/** @param {Model} model @param {string} choice */
export function setChoice(model, choice) {
  model.choice = /** @type {import('../protocol.js').Choice} */ (choice);
  model.tell('choice');
}

/** @param {Model} model @param {string} mode */
export function setMode(model, mode) {
  model.mode = /** @type {import('../protocol.js').GizmoMode} */ (mode);
  model.tell('mode');
}

/** @param {[string, HTMLButtonElement][]} buttons @param {string} pressed */
function press(buttons, pressed) {
  for (const [value, button] of buttons) button.setAttribute('aria-pressed', String(value === pressed));
}

/** @param {Model} model */
export function startToolbar(model) {
  const choiceButtons = buttonsWith('choice');
  const modeButtons = buttonsWith('mode');
  for (const [choice, button] of choiceButtons) button.addEventListener('click', () => setChoice(model, choice));
  for (const [mode, button] of modeButtons) button.addEventListener('click', () => setMode(model, mode));
  byId('frame').addEventListener('click', () => model.tell('frame'));
  model.on('choice', () => press(choiceButtons, model.choice));
  model.on('mode', () => press(modeButtons, model.mode));
  model.on('operands', () => {
    for (const choice of /** @type {const} */ (['first', 'second'])) byId(`title-${choice}`).textContent = titleOf(choice, model.operands.length);
    for (const [choice, button] of choiceButtons) button.disabled = choice === 'second' && model.operands.length < 2;
  });
  for (const name of /** @type {const} */ (['edges', 'graph', 'ghosts'])) {
    const box = byId(`show-${name}`, HTMLInputElement);
    const show = () => (box.checked = model.shown[name]);
    show();
    model.on('shown', show);
    box.addEventListener('change', () => {
      model.shown[name] = box.checked;
      model.tell('shown');
    });
  }
}
