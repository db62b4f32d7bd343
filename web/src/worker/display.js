// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes as a graphics card takes them. Doubles become floats relative to the middle, so that far away parts keep their shape.
// @ts-check

import { cornerNormals } from './shading.js';

/** @typedef {import('../protocol.js').Vector} Vector */
/** @typedef {import('mortise').Mesh} Mesh */

/** Least and greatest coordinates; zeros for no vertices. @param {Float64Array} positions */
function extent(positions) {
  const low = /** @type {Vector} */ ([0, 1, 2].map((axis) => positions[axis] ?? 0));
  const high = /** @type {Vector} */ ([...low]);
  for (let i = 0; i < positions.length; ++i) {
    if (positions[i] < low[i % 3]) low[i % 3] = positions[i];
    if (positions[i] > high[i % 3]) high[i % 3] = positions[i];
  }
  return { low, high };
}

/** @param {Float64Array} positions @returns {Vector} */
export function sizeOf(positions) {
  const { low, high } = extent(positions);
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
}

/**
 * A point near the middle with few digits: it appears in command lines.
 * @param {Float64Array} positions
 * @returns {Vector}
 */
function originOf(positions) {
  const { low, high } = extent(positions);
  const size = Math.max(...low.map((x, axis) => high[axis] - x));
  const digits = size > 0 ? 3 - Math.floor(Math.log10(size)) : 0;
  return /** @type {Vector} */ (low.map((x, axis) => rounded(x / 2 + high[axis] / 2, digits)));
}

/** @param {number} x @param {number} digits after the point; negative: before it */
function rounded(x, digits) {
  if (digits > 0) return Number(x.toFixed(Math.min(digits, 100))) + 0;
  return Math.round(x / 10 ** -digits) * 10 ** -digits + 0;
}

/**
 * Triangles sorted by operand, in their order within each.
 * @param {number} count
 * @param {Uint32Array | undefined} sourceOperand
 */
export function sortByOperand(count, sourceOperand) {
  /** @type {number[][]} */
  const lists = [];
  for (let f = 0; f < count; ++f) (lists[sourceOperand?.[f] ?? 0] ??= []).push(f);
  let start = 0;
  const groups = lists.map((faces, operand) => {
    const group = { operand, start, count: faces.length };
    start += faces.length;
    return group;
  });
  return { faces: lists.flat(), groups: groups.filter(Boolean) };
}

/**
 * @param {Mesh} mesh
 * @param {Float32Array} normals of its faces
 * @param {Uint32Array} [sourceOperand] of its faces
 * @param {Vector} [origin]
 * @returns {import('../protocol.js').Display}
 */
export function displayOf(mesh, normals, sourceOperand, origin = originOf(mesh.positions)) {
  const { faces, groups } = sortByOperand(mesh.triangles.length / 3, sourceOperand);
  const smooth = cornerNormals(mesh, normals, sourceOperand);
  const display = { origin, positions: new Float32Array(9 * faces.length), normals: new Float32Array(9 * faces.length), groups };
  faces.forEach((face, i) => {
    for (let k = 0; k < 9; ++k) {
      display.normals[9 * i + k] = smooth[9 * face + k];
      const vertex = mesh.triangles[3 * face + Math.floor(k / 3)];
      display.positions[9 * i + k] = mesh.positions[3 * vertex + (k % 3)] - origin[k % 3];
    }
  });
  return display;
}

/**
 * Two points per edge of the graph.
 * @param {import('mortise').IntersectionGraph} graph
 * @param {Vector} origin
 */
export function relativeSegments({ points, edges }, origin) {
  const segments = new Float32Array(3 * edges.length);
  edges.forEach((vertex, i) => {
    for (let axis = 0; axis < 3; ++axis) segments[3 * i + axis] = points[3 * vertex + axis] - origin[axis];
  });
  return segments;
}
