// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One line about what is going on, drawn over the scene; results are also announced, but not while a part is dragged.
// @ts-check

import { titleOf } from '../choices.js';
import { byId } from '../dom.js';
import { count, duration, measure } from '../numbers.js';

/** @typedef {import('../model.js').Model} Model */

const announceAfter = 500;

/** @param {Model} model */
function sentence({ trouble, result, operands }) {
  if (trouble !== undefined) return `${trouble.code}: ${trouble.message}`;
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

  function announce() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!model.dragging && model.busy === 0) announcement.textContent = sentence(model);
    }, announceAfter);
  }
  function update() {
    const state = stateOf(model);
    if (state !== 'busy') status.textContent = sentence(model);
    status.dataset.state = state;
    status.dataset.choice = model.result?.choice ?? '';
    bar.value = model.progress;
    bar.hidden = model.progress === 0;
    byId('old').hidden = !model.isOld;
    announce();
  }
  model.on(['busy', 'result', 'trouble', 'operands', 'dragging'], update);
}
