// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a result becomes in the file it is written to, and what its certificate says there.
// @ts-check

/**
 * @typedef {import('../index.js').Mortise} Mortise
 * @typedef {import('../index.js').BooleanResult} BooleanResult
 * @typedef {import('../index.js').Format} Format
 * @typedef {import('../index.js').Mesh} Mesh
 * @typedef {import('../index.js').Report} Report
 */

/** @param {Float64Array} positions */
function isFloat32(positions) {
  return positions.every((x) => Object.is(Math.fround(x), x));
}

/**
 * The mesh a file of this format holds, and the report about it. A format of float32 rounds every coordinate once more; what it then
 * holds is searched for crossings and triangles without area, and is certified only if there are none.
 * @param {Mortise} mortise
 * @param {BooleanResult} result
 * @param {Format} format
 * @returns {{ mesh: Mesh, report: Report }}
 */
export function storedResult(mortise, { mesh, report, provenance }, format) {
  if (format !== 'stl' || isFloat32(mesh.positions)) return { mesh, report };
  const stored = mortise.roundToFloat32(mesh);
  const found = mortise.inspect(stored);
  const isPartition = provenance.coveringFront !== undefined;
  const isSame = found.triangles === report.triangles && found.vertices === report.vertices;
  const certified = found.certified && (isPartition ? isSame : found.closed === report.closed);
  const note = certified ? 'certified is about the float32 coordinates the file stores' : lostNote(report, found);
  const { certificate, operands, milliseconds, regions, graph, contact } = report;
  const stages = [...report.stages, { stage: 'round_to_float32', milliseconds: found.milliseconds }];
  return { mesh: stored, report: { ...found, certified, certificate, operands, stages, milliseconds, regions, graph, contact, notes: [...report.notes, ...found.notes, note] } };
}

/** @param {Report} report @param {Report} found */
function lostNote(report, found) {
  const doubles = report.certified ? 'the doubles are certified: .ply, .obj, .off and stl-ascii keep them' : 'the doubles are not certified either';
  return `the float32 coordinates the file stores are not free of crossings (${found.selfIntersections} pairs); ${doubles}`;
}
