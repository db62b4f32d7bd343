// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Keys that work wherever no text is being typed; Escape everywhere.
// @ts-check

import { buttonsWith, byId } from '../dom.js';

/** @param {EventTarget | null} target */
function takesText(target) {
  if (target instanceof HTMLInputElement) return !['radio', 'checkbox', 'file'].includes(target.type);
  return target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

/** A key presses the button that names it in aria-keyshortcuts. */
export function startShortcuts() {
  const buttons = [...buttonsWith('choice'), ...buttonsWith('mode')].map(([, button]) => button);
  buttons.push(byId('frame', HTMLButtonElement), byId('cancel', HTMLButtonElement));
  const byKey = new Map(buttons.map((button) => [button.getAttribute('aria-keyshortcuts')?.toLowerCase(), button]));
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || (takesText(event.target) && event.key !== 'Escape')) return;
    const button = byKey.get(event.key.toLowerCase());
    if (button === undefined || button.disabled) return;
    event.preventDefault();
    button.click();
  });
}
