// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One line about what is going on, drawn over the scene. Results are also announced, but not while a part is dragged; troubles
// announce themselves.
// @ts-check

import { titleOf } from '../choices.js';
import { byId } from '../dom.js';
import { count, duration, measure } from '../numbers.js';

/** @typedef {import('../model.js').Model} Model */

const announceAfter = 500;

/** A computation shorter than this shows no progress. */
const patience = 300;

/** @param {Model} model */
function sentence({ result, operands }) {
  if (result === undefined) return 'Starting …';
  const { choice, report } = result;
  const volume = report.volume === null ? 'no volume' : `volume ${measure(report.volume, 5)}`;
  return `${titleOf(choice, operands.length)}: ${count(report.triangles)} triangles, ${volume}, ${duration(report.milliseconds)}`;
}

/** @param {Model} model */
const stateOf = ({ busy, trouble }) => (busy > 0 ? 'busy' : trouble === undefined ? 'done' : 'trouble');

/** @param {Model} model */
export function startStatus(model) {
  const status = byId('status');
  const bar = byId('progress', HTMLProgressElement);
  const announcement = byId('announcement');
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let idleSince = 0;

  function announce() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!model.dragging && stateOf(model) === 'done') announcement.textContent = sentence(model);
    }, announceAfter);
  }
  function update() {
    const state = stateOf(model);
    if (state === 'done') status.textContent = sentence(model);
    status.dataset.state = state;
    status.dataset.choice = model.result?.choice ?? '';
    bar.value = model.progress;
    if (model.progress === 0) idleSince = performance.now();
    bar.hidden = performance.now() - idleSince < patience;
    byId('old').hidden = !model.isOld;
    announce();
  }
  model.on(['busy', 'result', 'trouble', 'operands', 'dragging'], update);
}
