// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Turns the ids of an error into places in space, so that a program can point at them.
// @ts-check

/**
 * The vertices each id of an error stands for.
 * @param {any} mesh
 * @param {import('./index.js').MeshErrorDetails} details
 * @returns {number[][]}
 */
function verticesOf(mesh, { kind, ids = [] }) {
  if (kind === 'vertices') return ids.map((vertex) => [vertex]);
  if (kind === 'vertexPairs') return ids.flatMap((vertex, i) => (i % 2 === 0 ? [[vertex, ids[i + 1]]] : []));
  if (kind !== 'faces') return [];
  return ids.map((face) => [0, 1, 2].map((corner) => (mesh.triangles === undefined ? 3 * face + corner : mesh.triangles[3 * face + corner])));
}

/**
 * The middle of some vertices.
 * @param {any} mesh
 * @param {number[]} vertices
 * @returns {[number, number, number]}
 */
function middle(mesh, vertices) {
  const coordinate = (/** @type {number} */ axis) => vertices.reduce((sum, vertex) => sum + mesh.positions[3 * vertex + axis] / vertices.length, 0);
  return [coordinate(0), coordinate(1), coordinate(2)];
}

/**
 * One place per vertex, face or pair an error names; undefined when it names none, or one that does not exist.
 * @param {any} mesh
 * @param {import('./index.js').MeshErrorDetails} details
 * @returns {[number, number, number][] | undefined}
 */
export function placesOf(mesh, details) {
  if (mesh?.positions === undefined) return undefined;
  const groups = verticesOf(mesh, details);
  const exist = groups.length > 0 && groups.flat().every((vertex) => 3 * vertex < mesh.positions.length);
  return exist ? groups.map((vertices) => middle(mesh, vertices)) : undefined;
}
