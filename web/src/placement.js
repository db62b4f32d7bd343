// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How an operand is moved, as the steps `transform` takes. The command does the same steps, so it gives the same doubles.
// @ts-check

/** @typedef {import('./protocol.js').Placement} Placement */
/** @typedef {import('./protocol.js').Vector} Vector */
/** @typedef {import('mortise').TransformStep} TransformStep */

/** @returns {Placement} */
export const unmoved = () => ({ move: [0, 0, 0], turn: [0, 0, 0], scale: [1, 1, 1] });

/** Without the last digit, which adding doubles leaves behind: 0.1 + 0.2 is 0.3. @param {number} x */
const tidy = (x) => Number(x.toPrecision(15)) + 0;

/** @param {(x: number, axis: number) => number} entry @returns {Vector} */
const vector = (entry) => [entry(0, 0), entry(0, 1), entry(0, 2)];

/**
 * Scaling and turning are about the operand's own origin; turns are about x, then y, then z (an Euler order of ZYX).
 * @param {Placement} placement
 * @param {Vector} origin
 * @returns {TransformStep[]}
 */
export function stepsOf({ move, turn, scale }, origin) {
  const shapes = [...scaleSteps(scale), ...turnSteps(turn)];
  if (shapes.length === 0) return translateSteps(move);
  const there = vector((_, axis) => 0 - origin[axis]);
  const back = vector((_, axis) => tidy(origin[axis] + move[axis]));
  return [...translateSteps(there), ...shapes, ...translateSteps(back)];
}

/** @param {Vector} by @returns {TransformStep[]} */
function translateSteps(by) {
  return by.some((x) => x !== 0) ? [{ translate: by }] : [];
}

/** @param {Vector} scale @returns {TransformStep[]} */
function scaleSteps([x, y, z]) {
  if (x === y && y === z) return x === 1 ? [] : [{ scale: x }];
  return [{ scale: [x, y, z] }];
}

/** @param {Vector} turn @returns {TransformStep[]} */
function turnSteps([x, y, z]) {
  const steps = [{ rotateX: x }, { rotateY: y }, { rotateZ: z }];
  return /** @type {TransformStep[]} */ (steps.filter((step) => Object.values(step)[0] !== 0));
}

/** Digits after the point that matter for lengths in an object of this size. @param {number} size */
export function digitsFor(size) {
  return size > 0 ? Math.min(100, Math.max(0, 4 - Math.floor(Math.log10(size)))) : 4;
}

/** @param {number} x @param {number} digits after the point */
export function roundTo(x, digits) {
  return Number(x.toFixed(digits)) + 0;
}
