// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Taking the result away: as a file, or as the command lines that make it.
// @ts-check

import { commandsOf } from '../commands.js';
import { byId } from '../dom.js';
import { saveAs } from '../download.js';
import { isForCommand } from '../remesh_wish.js';
import { troubleOf } from '../trouble.js';

/** @typedef {import('../model.js').Model} Model */
/** @typedef {import('mortise').Format} Format */

/** @type {Record<import('../protocol.js').Choice, string>} */
const fileNames = { union: 'union', intersect: 'intersection', first: 'a-minus-b', second: 'b-minus-a' };

/** @param {Model} model @param {import('../engine.js').Engine} engine */
function startDownload(model, engine) {
  const button = byId('download', HTMLButtonElement);
  const select = byId('format', HTMLSelectElement);
  button.addEventListener('click', async () => {
    const { result, remeshedInView, meshInView } = model;
    if (result === undefined || meshInView === undefined) return;
    const format = /** @type {Format} */ (select.value);
    const name = `${fileNames[result.choice]}${remeshedInView === undefined ? '' : '-remeshed'}.${format.replace('-ascii', '')}`;
    try {
      saveAs(await engine.call('write', { mesh: meshInView.mesh, format }), name);
    } catch (error) {
      model.fail(troubleOf(error, name));
    }
  });
  select.addEventListener('change', () => {
    byId('format-note').hidden = select.value !== 'stl';
  });
  model.on(['result', 'remeshed'], () => {
    button.disabled = model.result === undefined;
    button.textContent = model.remeshedInView === undefined ? 'Download' : 'Download remeshed';
  });
}

/** @param {Model} model */
function startCommands(model) {
  const text = byId('commands');
  const copy = byId('copy', HTMLButtonElement);
  model.on(['operands', 'placement', 'choice', 'remeshed'], () => {
    const { wish } = model.remeshedInView ?? {};
    text.textContent = commandsOf(model, wish).join('\n');
    byId('command-note').hidden = wish === undefined || isForCommand(wish);
    copy.textContent = 'Copy as command';
  });
  copy.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(text.textContent ?? '');
      copy.textContent = 'Copied';
    } catch {
      getSelection()?.selectAllChildren(text);
      copy.textContent = 'Selected: press Ctrl+C';
    }
  });
}

/** @param {Model} model @param {import('../engine.js').Engine} engine */
export function startTakeAway(model, engine) {
  startDownload(model, engine);
  startCommands(model);
}
