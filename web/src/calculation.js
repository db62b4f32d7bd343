// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Computes whenever operands, their places or the operation change. The last good result stays until there is a newer one.
// @ts-check

import { choices, inOrder } from './choices.js';
import { letterOf } from './model.js';
import { newestOnly } from './newest_only.js';
import { stepsOf } from './placement.js';
import { troubleOf } from './trouble.js';

/** @typedef {import('./protocol.js').Operand} Operand */

/** @param {Operand} operand */
const placed = ({ key, placement, display }) => ({ key, steps: stepsOf(placement, display.origin) });

/**
 * @param {import('./model.js').Model} model
 * @param {import('./engine.js').Engine} engine
 */
export function startCalculation(model, engine) {
  /** @param {unknown} error @param {Operand[]} operands of the call */
  function fail(error, operands) {
    const letter = (/** @type {number} */ i) => letterOf(model.positionOf(operands[i].key));
    const trouble = troubleOf(error, '');
    const i = trouble.details.operand ?? (operands.length === 1 ? 0 : -1);
    if (operands[i] !== undefined) trouble.about = `${letter(i)} (${operands[i].name})`;
    trouble.message = trouble.message.replace(/\boperand (\d+)\b/g, (text, n) => (operands[n] === undefined ? text : letter(n)));
    model.isOld = model.result !== undefined;
    model.fail(trouble);
  }

  async function run() {
    const { choice } = model;
    const operands = inOrder(choice, model.operands);
    const begin = performance.now();
    model.countBusy(1);
    try {
      const onProgress = (/** @type {import('./protocol.js').Progress} */ { fraction }) => showProgress(fraction);
      const evaluation = await engine.call('evaluate', { operation: choices[choice].operation, operands: operands.map(placed) }, { onProgress });
      model.result = { ...evaluation, choice, keys: operands.map(({ key }) => key), milliseconds: performance.now() - begin };
      model.isOld = false;
      model.trouble = undefined;
      model.tell('result');
    } catch (error) {
      fail(error, operands);
    }
    model.progress = 0;
    model.countBusy(-1);
  }

  /** @param {number} fraction */
  function showProgress(fraction) {
    model.progress = fraction;
    model.tell('busy');
  }

  const ask = newestOnly(run);
  model.on(['operands', 'placement', 'choice'], () => {
    if (model.operands.length > 0) ask();
  });
}
