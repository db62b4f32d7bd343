// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Colours of the scene: the custom properties of the style sheet, so that page and scene agree in light and dark.
// @ts-check

import { Color } from 'three';

const parts = 'abcdefgh';

const dark = matchMedia('(prefers-color-scheme: dark)');

/** @param {string} name */
export function colourOf(name) {
  return new Color(getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
}

/** @param {number} position of an operand */
export const partColour = (position) => colourOf(`part-${parts[position % parts.length]}`);

/** @param {() => void} listener */
export function onThemeChange(listener) {
  dark.addEventListener('change', listener);
}
