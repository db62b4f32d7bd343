// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Computes whenever operands, their places or the operation change. The last good result stays until there is a newer one.
// While a part is dragged the result is not searched for self-intersections; when it is let go it is computed once more in full.
// @ts-check

import { choices, inOrder, titleOf } from './choices.js';
import { letterOf } from './model.js';
import { newestOnly } from './newest_only.js';
import { stepsOf } from './placement.js';
import { isCancelled, troubleOf } from './trouble.js';

/** @typedef {import('./protocol.js').Operand} Operand */

/** @param {Operand} operand */
const placed = ({ key, source, placement, display }) => ({ key, source, steps: stepsOf(placement, display.origin) });

/** The arguments of the call for the state of the moment. @param {import('./model.js').Model} model */
function wish({ choice, operands }) {
  const { operation } = choices[choice];
  const args = { operation, operands: inOrder(choice, operands).map(placed) };
  return { args, asked: JSON.stringify([operation, args.operands.map(({ key, steps }) => [key, steps])]) };
}

/**
 * @param {import('./model.js').Model} model
 * @param {import('./engine.js').Engine} engine
 */
export function startCalculation(model, engine) {
  /** Was the last computation one for a part under the hand? */
  let brief = false;

  /** @param {unknown} error @param {Operand[]} operands of the call */
  function troubleWith(error, operands) {
    const letter = (/** @type {number} */ i) => letterOf(model.positionOf(operands[i].key));
    const trouble = troubleOf(error, '');
    const i = trouble.details.operand ?? (operands.length === 1 ? 0 : -1);
    if (operands[i] !== undefined) trouble.about = `${letter(i)} (${operands[i].name})`;
    trouble.message = trouble.message.replace(/\boperand (\d+)\b/g, (text, n) => (operands[n] === undefined ? text : letter(n)));
    return trouble;
  }

  /** @param {unknown} error @param {Operand[]} operands of the call */
  function fail(error, operands) {
    model.isOld = model.result !== undefined && model.result.asked !== wish(model).asked;
    model.fail(isCancelled(error) ? undefined : troubleWith(error, operands));
  }

  async function run() {
    const { choice } = model;
    const operands = inOrder(choice, model.operands);
    const { args, asked } = wish(model);
    const title = titleOf(choice, operands.length);
    const begin = performance.now();
    brief = model.dragging;
    model.begin(title);
    try {
      const onProgress = (/** @type {import('./protocol.js').Progress} */ { fraction }) => model.advance(title, fraction);
      const evaluation = await engine.call('evaluate', { ...args, inspect: !brief }, { onProgress });
      model.result = { ...evaluation, choice, asked, operands: args.operands, milliseconds: performance.now() - begin };
      model.isOld = false;
      model.trouble = undefined;
      model.tell('result');
    } catch (error) {
      fail(error, operands);
    }
  }

  const newest = newestOnly(run, (step) => model.countBusy(step));
  model.on(['operands', 'placement', 'choice', 'again'], () => {
    if (model.operands.length > 0) void newest.ask();
  });
  model.on('dragging', () => {
    if (!model.dragging && brief) void newest.ask();
  });
  model.on('cancel', () => {
    newest.drop();
    brief = false;
  });
}
