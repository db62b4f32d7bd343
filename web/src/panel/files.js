// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files come by dropping them anywhere or by the choosers.
// @ts-check

import { byId } from '../dom.js';

/** @param {HTMLInputElement} chooser @param {(files: File[]) => void} use */
function watchChooser(chooser, use) {
  chooser.addEventListener('change', () => {
    const files = [...(chooser.files ?? [])];
    chooser.value = '';
    use(files);
  });
}

/** @param {DragEvent} event */
const hasFiles = (event) => event.dataTransfer?.types.includes('Files') ?? false;

/** @param {import('../operands.js').Operands} operands */
export function startFiles(operands) {
  const curtain = byId('curtain');
  watchChooser(byId('choose-files', HTMLInputElement), (files) => void operands.open(files));
  watchChooser(byId('add-files', HTMLInputElement), (files) => void operands.add(files));
  addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    curtain.hidden = false;
  });
  addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) curtain.hidden = true;
  });
  addEventListener('drop', (event) => {
    curtain.hidden = true;
    if (!hasFiles(event)) return;
    event.preventDefault();
    void operands.open([...(event.dataTransfer?.files ?? [])]);
  });
}
