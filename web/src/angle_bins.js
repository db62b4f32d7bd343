// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Smallest angles of triangles in bins: none is above 60 degrees.
// @ts-check

/** In degrees. */
export const binWidth = 2;

export const angleBins = 60 / binWidth;

/** The last bin takes its upper end too: equilateral triangles. @param {number} degrees */
export const binOf = (degrees) => Math.min(angleBins - 1, Math.floor(degrees / binWidth));

/** How much of all triangles lies below an angle. @param {number[]} counts per bin @param {number} degrees a multiple of the width */
export function shareBelow(counts, degrees) {
  const sum = (/** @type {number[]} */ list) => list.reduce((total, n) => total + n, 0);
  return sum(counts.slice(0, degrees / binWidth)) / Math.max(1, sum(counts));
}
