// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshes the result when asked, and says beforehand how many triangles that takes. What is remeshed belongs to one result: when a part
// moves or the operation changes it goes, and so does the computation of it.
// @ts-check

import { newestOnly } from './newest_only.js';
import { count } from './numbers.js';
import { diagonalOf, firstSize } from './remesh_wish.js';
import { isCancelled, troubleOf } from './trouble.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./protocol.js').Result} Result */

const title = 'Remeshing';

/** What the worker needs of a result. @param {Result} result @returns {import('./protocol.js').Made} */
const madeOf = ({ mesh, provenance, curves }) => ({ mesh, provenance, curves });

/** @param {unknown} error */
function troubleWith(error) {
  const trouble = troubleOf(error, title);
  trouble.message = trouble.message.replace(/\d{4,}/g, (digits) => count(Number(digits)));
  return trouble;
}

/** Keeps the predicted count up to date. @param {Model} model @param {Engine} engine */
function startPrediction(model, engine) {
  const newest = newestOnly(async () => {
    const { result, wish } = model;
    model.predicted = undefined;
    if (result !== undefined && wish.size > 0) {
      const args = { made: madeOf(result), operands: result.operands, wish };
      model.predicted = await engine.call('predict', args).catch(() => undefined);
    }
    model.tell('predicted');
  });
  model.on(['result', 'wish', 'dragging'], () => {
    if (!model.dragging) void newest.ask();
  });
}

/** A new result of new parts gets the size that suits it. @param {Model} model */
function startFirstSize(model) {
  let areNew = true;
  model.on('operands', () => {
    areNew = true;
  });
  model.on('result', () => {
    if (!areNew || model.result === undefined) return;
    areNew = false;
    model.wish = { ...model.wish, size: firstSize(diagonalOf(model.result.report.bbox)) };
    model.tell('wish');
  });
}

/** Edges of triangles are shown as long as there is a remeshed mesh, unless the person does not want them. @param {Model} model */
function startEdges(model) {
  let before = model.shown.edges;
  let wasRemeshed = false;
  model.on('remeshed', () => {
    const isRemeshed = model.remeshed !== undefined;
    if (isRemeshed === wasRemeshed) return;
    wasRemeshed = isRemeshed;
    if (isRemeshed) before = model.shown.edges;
    model.shown.edges = isRemeshed || before;
    model.tell('shown');
  });
}

/** @param {Model} model @param {import('./protocol.js').Remeshed | undefined} remeshed */
function setRemeshed(model, remeshed) {
  if (remeshed === undefined && model.remeshed === undefined) return;
  model.remeshed = remeshed;
  model.looksBack = false;
  model.bin = undefined;
  model.tell('remeshed');
}

/** @param {Model} model @param {Engine} engine */
export function startRemeshing(model, engine) {
  let isWanted = false;
  let isRunning = false;

  async function run() {
    const { result, wish } = model;
    if (result === undefined || model.isOld) return;
    const begin = performance.now();
    isRunning = true;
    model.countBusy(1);
    model.begin(title);
    try {
      const onProgress = (/** @type {import('./protocol.js').Progress} */ { fraction }) => model.advance(title, fraction);
      const args = { made: madeOf(result), operands: result.operands, wish, origin: result.display.origin };
      const remeshing = await engine.call('remesh', args, { onProgress });
      model.fail(undefined);
      setRemeshed(model, { ...remeshing, wish, milliseconds: performance.now() - begin });
    } catch (error) {
      model.fail(isCancelled(error) ? undefined : troubleWith(error));
    }
    isRunning = false;
    model.countBusy(-1);
  }

  /** A result that is still being computed is waited for. */
  function goOn() {
    if (!isWanted || model.busy > 0) return;
    isWanted = false;
    void run();
  }
  function drop() {
    if (isRunning) engine.cancel(['remesh']);
    setRemeshed(model, undefined);
  }
  model.on('remesh', () => {
    isWanted = true;
    goOn();
  });
  model.on('busy', goOn);
  model.on('cancel', () => {
    isWanted = false;
  });
  model.on('unremesh', () => setRemeshed(model, undefined));
  model.on(['operands', 'placement', 'choice', 'again', 'result'], drop);
  startFirstSize(model);
  startEdges(model);
  startPrediction(model, engine);
}
