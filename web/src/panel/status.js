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

/** @param {Model} model */
function sentence({ result, remeshedInView, operands }) {
  if (result === undefined) return 'Starting …';
  const { choice, report } = result;
  if (remeshedInView !== undefined) {
    const { after, milliseconds } = remeshedInView;
    const angles = `angles ${measure(after.minAngleDeg, 3)}° to ${measure(after.maxAngleDeg, 3)}°`;
    return `${titleOf(choice, operands.length)}, remeshed: ${count(after.triangles)} triangles, ${angles}, ${duration(milliseconds)}`;
  }
  const volume = report.volume === null ? 'no volume' : `volume ${measure(report.volume, 5)}`;
  return `${titleOf(choice, operands.length)}: ${count(report.triangles)} triangles, ${volume}, ${duration(report.milliseconds)}`;
}

/** @param {Model} model */
function stateOf({ busy, cancelled, trouble }) {
  if (busy > 0) return 'busy';
  if (cancelled) return 'cancelled';
  return trouble === undefined ? 'done' : 'trouble';
}

/** @param {Model} model */
export function startStatus(model) {
  const status = byId('status');
  const again = byId('again', HTMLButtonElement);
  const announcement = byId('announcement');
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  function announce() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!model.dragging && ['done', 'cancelled'].includes(stateOf(model))) announcement.textContent = status.textContent;
    }, announceAfter);
  }
  function update() {
    const state = stateOf(model);
    if (state !== 'trouble') status.textContent = state === 'cancelled' ? 'Cancelled' : sentence(model);
    status.dataset.state = state;
    status.dataset.choice = model.result?.choice ?? '';
    byId('old').hidden = !model.isOld;
    again.hidden = state !== 'cancelled' || !model.isOld;
    announce();
  }
  model.on(['busy', 'result', 'remeshed', 'trouble', 'operands', 'dragging'], update);
  again.addEventListener('click', () => model.tell('again'));
}
