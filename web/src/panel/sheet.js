// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// On a narrow screen the panel is a sheet at the bottom that can be folded.
// @ts-check

import { byId } from '../dom.js';

export function startSheet() {
  const button = byId('fold', HTMLButtonElement);
  button.addEventListener('click', () => {
    const open = button.getAttribute('aria-expanded') !== 'true';
    button.setAttribute('aria-expanded', String(open));
    byId('panel').classList.toggle('folded', !open);
  });
}
