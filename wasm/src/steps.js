// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The steps of transform(): which exist, what they take.
// @ts-check

import { describe } from './arguments.js';
import { invalidArgument } from './errors.js';

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** @param {unknown} value */
function isVector(value) {
  return Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === 'number');
}

/** @param {any} value */
function isMatrix(value) {
  const isArray = Array.isArray(value) || value instanceof Float64Array || value instanceof Float32Array;
  return isArray && value.length === 16 && Array.prototype.every.call(value, (x) => typeof x === 'number');
}

/** @param {unknown} value */
const angle = (value) => (typeof value === 'number' ? [value, 0, 0] : undefined);

/** Three numbers per step, sixteen of a matrix, or undefined when the value makes no sense. @type {Record<string, (value: any) => number[] | undefined>} */
const numbersOf = {
  scale: (value) => (isVector(value) ? value : typeof value === 'number' ? [value, value, value] : undefined),
  rotateX: angle,
  rotateY: angle,
  rotateZ: angle,
  translate: (value) => (isVector(value) ? value : undefined),
  matrix: (value) => (isMatrix(value) ? Array.from(value) : undefined),
  mirror: (value) => (typeof value === 'string' ? axes[/** @type {'x'} */ (value)] : undefined),
};

const wanted = '{scale: s}, {scale: [x, y, z]}, {rotateX|rotateY|rotateZ: degrees}, {translate: [x, y, z]}, {matrix: 16 numbers} or {mirror: "x"|"y"|"z"}';

/**
 * Each step as [name, numbers...].
 * @param {any} steps
 * @returns {import('./glue_types.js').FlatStep[]}
 */
export function checkSteps(steps) {
  if (!Array.isArray(steps)) throw invalidArgument(`transform takes an array of steps, not ${describe(steps)}`);
  return steps.map((step, i) => {
    const names = typeof step === 'object' && step !== null ? Object.keys(step) : [];
    const numbers = names.length === 1 && Object.hasOwn(numbersOf, names[0]) ? numbersOf[names[0]](step[names[0]]) : undefined;
    if (numbers === undefined) throw invalidArgument(`steps[${i}] must be ${wanted}`);
    return [names[0], ...numbers];
  });
}
