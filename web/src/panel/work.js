// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What takes long: how far it is, and the way to stop it.
// @ts-check

import { byId } from '../dom.js';

/** Work shorter than this is not shown. */
const patience = 300;

/** @param {import('../model.js').Model} model */
export function startWork(model) {
  const box = byId('work');
  const title = byId('work-title');
  const bar = byId('progress', HTMLProgressElement);
  const cancel = byId('cancel', HTMLButtonElement);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  function show() {
    const { fraction } = model.work;
    title.textContent = model.work.title;
    if (fraction === undefined) bar.removeAttribute('value');
    else bar.value = fraction;
    box.hidden = false;
  }
  function hide() {
    const hadFocus = box.contains(document.activeElement);
    box.hidden = true;
    if (hadFocus) byId('canvas').focus();
  }
  /** Once shown it stays until all is done: in a row of long runs it does not flicker. */
  function update() {
    clearTimeout(timer);
    cancel.disabled = model.busy === 0;
    if (model.busy === 0) hide();
    else if (!box.hidden) show();
    else timer = setTimeout(show, model.work.since + patience - performance.now());
  }
  model.on('busy', update);
  cancel.addEventListener('click', () => model.cancel());
}
