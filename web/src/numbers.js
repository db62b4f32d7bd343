// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers as people read them.
// @ts-check

/** @param {number} n */
export const count = (n) => n.toLocaleString('en-US');

/** @param {number} x @param {number} [digits] */
export const measure = (x, digits = 7) => String(Number(x.toPrecision(digits))).replace('-', '−');

/** @param {number} n @param {string} one */
export const plural = (n, one) => `${count(n)} ${one}${n === 1 ? '' : 's'}`;

/** @param {number} ms */
export const duration = (ms) => (ms < 10 ? `${ms.toFixed(1)} ms` : ms < 10000 ? `${Math.round(ms)} ms` : `${(ms / 1000).toFixed(1)} s`);
