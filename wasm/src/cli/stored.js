// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the certificate of a result says about the file it is written to.
// @ts-check

/**
 * @typedef {import('../index.js').Mortise} Mortise
 * @typedef {import('../index.js').BooleanResult} BooleanResult
 * @typedef {import('../index.js').Format} Format
 * @typedef {import('../index.js').Report} Report
 */

/** @param {Float64Array} positions */
function isFloat32(positions) {
  return positions.every((x) => Object.is(Math.fround(x), x));
}

/**
 * The report about what the file holds. A format of float32 rounds every coordinate once more; then the rounded mesh, equal positions
 * welded, is searched for crossings: it is certified only if there are none.
 * @param {Mortise} mortise
 * @param {BooleanResult} result
 * @param {Uint8Array} bytes
 * @param {Format} format
 * @returns {Report}
 */
export function judgeStored(mortise, { mesh, report }, bytes, format) {
  if (format !== 'stl' || isFloat32(mesh.positions)) return report;
  const stored = mortise.inspect(mortise.readMesh(bytes, { format }));
  const { selfIntersections, closed } = stored;
  const sound = selfIntersections === 0 && closed === report.closed;
  const notes = [...report.notes, sound ? certifiedNote : uncertifiedNote(report, stored)];
  return { ...report, selfIntersections, certified: sound, notes };
}

const certifiedNote = 'certified and selfIntersections are about the float32 coordinates the file stores';

/** @param {Report} report @param {Report} stored */
function uncertifiedNote(report, stored) {
  const found = `${stored.selfIntersections} pairs of triangles cross${stored.closed ? '' : ` and ${stored.boundaryEdges} edges are open`}`;
  const doubles = report.certified ? 'the doubles are certified: write .ply, .obj, .off or stl-ascii to keep them' : 'the doubles are not certified either';
  return `rounded to the float32 coordinates the file stores, ${found}; ${doubles}`;
}
