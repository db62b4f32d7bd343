// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise remesh IN -o OUT --size H
// @ts-check

import { invalidArgument } from '../../errors.js';
import { printPlain, readOperand, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { keepsModels, modelTargetOf, readModelFile, sendModel } from '../model_files.js';
import { sizeNumbers, sizeOptionsOf, sizesHelp, sizesOf } from '../size_options.js';

/** @typedef {import('../../index.js').TriangleShapes} TriangleShapes */

/** Options that are one of some words. */
const words = ['features', 'preset', 'mesher'];
const numbers = { ...sizeNumbers, 'most-triangles': 'mostTriangles', 'max-deviation': 'maxDeviation', 'min-feature': 'minFeature' };

/** @param {string} when @param {TriangleShapes} shapes */
function shapesText(when, { triangles, minAngleDeg, maxAngleDeg }) {
  const short = (/** @type {number} */ n) => String(Number(n.toPrecision(4)));
  const angles = minAngleDeg === null || maxAngleDeg === null ? '' : `, angles ${short(minAngleDeg)} to ${short(maxAngleDeg)} degrees`;
  return `${when}: ${triangles.toLocaleString('en-US')} triangles${angles}`;
}

/** @param {number} kept @param {number} newCrossings */
function auditNotes(kept, newCrossings) {
  return [
    ...(kept > 0 ? [`${kept} triangles stay: faces would have come to cross there, or to be too far away`] : []),
    ...(newCrossings > 0 ? [`${newCrossings} pairs of triangles cross that did not before`] : []),
  ];
}

/** @param {import('../../index.js').MergedFeatures | undefined} merged */
function mergeNotes(merged) {
  if (merged === undefined) return [];
  const { gone, unresolved } = merged;
  return [
    `${gone.length} triangles had features below the least one and are gone`,
    ...(unresolved.length > 0 ? [`${unresolved.length} triangles cross others now, or could not share all that is near`] : []),
  ];
}

/** What became of a mesh. @param {import('../../index.js').RemeshResult} result */
export function remeshNotes({ before, after, predicted, kept, newCrossings, merged }) {
  return [...mergeNotes(merged), shapesText('before', before), shapesText('after', after), `${Math.round(predicted).toLocaleString('en-US')} triangles predicted`, ...auditNotes(kept.length, newCrossings)];
}

/** @param {import('../../index.js').RemeshResult} result @returns {Pick<import('../common.js').PlainCall, 'notes' | 'more'>} */
function reportOf(result) {
  const { predicted, before, after, kept, newCrossings, merged } = result;
  const counts = merged && { gone: merged.gone.length, unresolved: merged.unresolved.length, movedVertices: merged.movedVertices, largestMove: merged.largestMove };
  return { notes: remeshNotes(result), more: { predicted, before, after, kept: kept.length, newCrossings, merged: counts } };
}

/** Remeshes a file, as a model with its names where the output keeps them. @type {import('../common.js').Verb['run']} */
function remeshFile(mortise, args, streams) {
  const target = modelTargetOf(args);
  if (args.positionals.length !== 1) throw invalidArgument('remesh needs one mesh file');
  const [file] = args.positionals;
  const said = words.filter((word) => args.values[word] !== undefined).map((word) => [word, args.values[word]]);
  const { featureAngle, curveAngle, ...sizes } = sizesOf(args, numbers, 'remesh');
  const options = { ...sizes, ...Object.fromEntries(said) };
  const call = { verb: 'remesh', args, streams };
  if (!keepsModels(target)) {
    const result = mortise.remesh(readOperand(mortise, file, args, streams), { ...options, featureAngle, curveAngle });
    writePlain(mortise, result.mesh, { ...call, ...reportOf(result) });
    return exitCode.ok;
  }
  const given = readModelFile(mortise, file, args, streams, { faceAngle: featureAngle, edgeAngle: curveAngle, seams: 'none' });
  const result = mortise.remesh(given, options);
  sendModel(mortise, result.model, target, streams);
  printPlain(mortise, result.mesh, target, { ...call, ...reportOf(result) });
  return exitCode.ok;
}

/** @type {import('../common.js').Verb} */
export const remeshVerb = {
  help: `mortise remesh IN -o OUT --size H

The same model (faces, edges and corners by angles and labels) with triangles of the size wanted. Corners stay, edges stay edges, and names on
faces, edges, vertices and regions stay on them where both files keep them (.msh .vtk .vtu .mesh, to write .inp .bdf .geo too).

${sizesHelp}  --max-deviation D      no point of either surface is farther from the other than this: triangles become smaller, or stay, where it takes that
  --most-triangles N     sizes that ask for more are refused (default 20 million)
  --features NAME        refine (default): triangles as small as features below the size take to be good ones;
                         merge: what is nearer to each other than --min-feature becomes one before; keep
  --min-feature H        features below this go with merge, else stay as they are (default 1e-6 of the box round the mesh)
  --preset NAME          default; paper: edges are collapsed below H and split above 2 H
  --mesher NAME          local; frontal: faces in planes get new triangles from their edges inwards
  -o, --output FILE      .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; .geo: for Gmsh, with a .msh; - is the standard output
  --format FORMAT        stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                         of the output, and of a mesh from - (the standard input)
  --json                 print the report as JSON, with before, after and the count predicted
  -q, --quiet            print no report
`,
  options: { ...writingOptions, ...sizeOptionsOf(numbers), ...Object.fromEntries(words.map((word) => [word, { type: /** @type {'string'} */ ('string') }])) },
  run: remeshFile,
};
