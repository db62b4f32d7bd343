// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshes a result, and says in numbers what became of its triangles.
// @ts-check

import { angleBins, binOf } from '../angle_bins.js';
import { mostTriangles } from '../remesh_wish.js';
import { displayOf, sortByOperand } from './display.js';
import { cornerAngles, normalsFromSources } from './shading.js';

/** @typedef {import('mortise').Mesh} Mesh */
/** @typedef {import('mortise').Mortise} Mortise */
/** @typedef {import('../protocol.js').Made} Made */
/** @typedef {import('../protocol.js').RemeshWish} RemeshWish */

/** @param {Made} made @param {RemeshWish} wish @returns {{ size: number, growth: number, sources: import('mortise').SizeSource[] }} */
function sizesOf({ curves }, { size, growth, finer }) {
  return { size, growth, sources: finer ? [{ graph: curves }] : [] };
}

/**
 * @param {Mortise} mortise
 * @param {{ made: Made, placed: import('./operand_store.js').Shaped[], wish: RemeshWish }} args
 */
export function predictMade(mortise, { made, placed, wish }) {
  const { featureAngle } = wish;
  return mortise.predictTriangles(made, { operands: placed.map(({ mesh }) => mesh), ...sizesOf(made, wish), featureAngle });
}

/** The bin of the smallest angle of each of these faces. @param {Mesh} mesh @param {number[]} faces */
function binsOf(mesh, faces) {
  const angles = cornerAngles(mesh);
  return Uint8Array.from(faces, (face) => binOf((Math.min(...angles.subarray(3 * face, 3 * face + 3)) * 180) / Math.PI));
}

/** @param {Uint8Array} bins */
function countsOf(bins) {
  const counts = new Array(angleBins).fill(0);
  for (const bin of bins) ++counts[bin];
  return counts;
}

/**
 * @param {Mesh} mesh
 * @param {Uint32Array} sourceOperand of its faces
 * @param {import('mortise').QualityReport} quality
 * @returns {import('../protocol.js').TriangleNumbers}
 */
function numbersOf(mesh, sourceOperand, { all, edges }) {
  const { count: triangles, minAngleDeg, maxAngleDeg, meanRadiusRatio } = all;
  const bins = binsOf(mesh, sortByOperand(triangles, sourceOperand).faces);
  return { triangles, minAngleDeg, maxAngleDeg, meanRadiusRatio, inBand: edges.inBand, angleCounts: countsOf(bins), bins };
}

/**
 * New triangles are shaded like those they lie on.
 * @param {import('mortise').RemeshResult} remeshed
 * @param {{ made: Made, placed: import('./operand_store.js').Shaped[], origin: import('../protocol.js').Vector }} from
 */
function shade({ mesh, sources }, { made: { provenance }, placed, origin }) {
  const normals = normalsFromSources(provenance, placed.map((operand) => operand.normals));
  const own = Float32Array.from(mesh.triangles, (_, i) => normals[3 * sources[Math.floor(i / 3)] + (i % 3)]);
  const sourceOperand = sources.map((face) => provenance.sourceOperand[face]);
  return { sourceOperand, display: displayOf(mesh, own, sourceOperand, origin) };
}

/**
 * @param {Mortise} mortise
 * @param {{ made: Made, placed: import('./operand_store.js').Shaped[], wish: RemeshWish, origin: import('../protocol.js').Vector }} args
 * @param {(progress: import('../protocol.js').Progress) => void} tell
 * @returns {import('../protocol.js').Remeshing}
 */
export function remeshMade(mortise, { made, placed, wish, origin }, tell) {
  const operands = placed.map(({ mesh }) => mesh);
  const { featureAngle, layers } = wish;
  const zone = layers > 0 ? { layers } : {};
  const wanted = { ...sizesOf(made, wish), featureAngle };
  const remeshed = mortise.remesh(made, { operands, ...wanted, ...zone, mostTriangles, onProgress: tell });
  const { sourceOperand, display } = shade(remeshed, { made, placed, origin });
  return {
    mesh: remeshed.mesh,
    display,
    before: numbersOf(made.mesh, made.provenance.sourceOperand, mortise.quality(made.mesh, wanted)),
    after: numbersOf(remeshed.mesh, sourceOperand, mortise.quality(remeshed, wanted)),
    kept: remeshed.kept.length,
    newCrossings: remeshed.newCrossings,
  };
}
