// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which triangles can be wished for: limits, what is wished for at first, sizes on a slider.
// @ts-check

/** @typedef {import('./protocol.js').RemeshWish} RemeshWish */

/** More would take minutes, and gigabytes to draw. */
export const mostTriangles = 2_000_000;

/** Of the slider for sizes. */
export const lastPosition = 100;

/** The slider goes from one part in so many of the diagonal of the result to one part in so few; at first it is between. */
const finest = 400;
const first = 50;
const coarsest = 4;

const commandFeatureAngle = 40;

/** @returns {RemeshWish} */
export const firstWish = () => ({ size: 1, finer: false, growth: 1.2, featureAngle: commandFeatureAngle, layers: 0 });

/** Does the command line have words for it? @param {RemeshWish} wish */
export const isForCommand = ({ finer, featureAngle }) => !finer && featureAngle === commandFeatureAngle;

/** @param {import('mortise').Box | null} box of a result */
export function diagonalOf(box) {
  if (box === null) return 1;
  return Math.hypot(...box.max.map((x, axis) => x - box.min[axis])) || 1;
}

/** @param {number} diagonal */
export const firstSize = (diagonal) => Number((diagonal / first).toPrecision(2));

/** The size at a position of the slider: from one position to the next it grows by the same factor. @param {number} position @param {number} diagonal */
export function sizeAt(position, diagonal) {
  return Number(((diagonal / finest) * (finest / coarsest) ** (position / lastPosition)).toPrecision(3));
}

/** Where the slider is for a size. @param {number} size @param {number} diagonal */
export function positionOf(size, diagonal) {
  const position = (lastPosition * Math.log((size * finest) / diagonal)) / Math.log(finest / coarsest);
  return Math.round(Math.min(lastPosition, Math.max(0, position || 0)));
}
