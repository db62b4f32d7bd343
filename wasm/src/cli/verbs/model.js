// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise model FILE
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseNumber } from '../arguments.js';
import { asLists, displayName, namingFiles, readOperand, readingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @param {import('../../index.js').Model} model */
function modelAsJson(model) {
  const { counts } = model;
  const rows = (/** @type {number} */ count, /** @type {(i: number) => object} */ row) => Array.from({ length: count }, (_, i) => row(i));
  return {
    counts,
    vertices: rows(counts.modelVertices, (i) => model.vertex(i)),
    edges: rows(counts.modelEdges, (i) => model.edge(i)),
    faces: rows(counts.modelFaces, (i) => model.face(i)),
    regions: rows(counts.regions + counts.voids + 1, (i) => model.region(i)),
  };
}

/** @param {string} name @param {import('../../index.js').ModelCounts} counts */
function countsAsText(name, counts) {
  /** @type {[string, number][]} */
  const lines = [
    ['triangles', counts.triangles],
    ['faces', counts.modelFaces],
    ['edges', counts.modelEdges],
    ['vertices', counts.modelVertices],
    ['regions', counts.regions],
    ['voids', counts.voids],
    ['mesh edges', counts.meshEdgesOnModelEdges],
  ];
  return [`model         ${name}`, ...lines.map(([what, count]) => `${what.padEnd(14)}${count}`), ''].join('\n');
}

/** @type {import('../common.js').Verb} */
export const modelVerb = {
  help: `mortise model FILE

The faces, edges, vertices and regions of a mesh; - is the standard input.

  --face-angle DEGREES   triangles at a larger angle are of different faces (default 40)
  --weak-angle DEGREES   edges above this one part faces too where they continue one
  --edge-angle DEGREES   edges that turn by more have a vertex there (default 45)
  --least-dangling N     creases that end inside a face after fewer edges do not count (default 0)
  --seams MODE           none, annulus, disc: edges that open faces (default annulus)
  --join-labels          triangles of different labels may lie on one face
  --json                 counts and entities as JSON
  --format FORMAT        stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh: of the standard input
`,
  options: {
    ...readingOptions,
    'face-angle': { type: 'string' },
    'weak-angle': { type: 'string' },
    'edge-angle': { type: 'string' },
    'least-dangling': { type: 'string' },
    seams: { type: 'string' },
    'join-labels': { type: 'boolean' },
  },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('model needs one mesh file');
    const number = (/** @type {string} */ name) => (args.values[name] === undefined ? undefined : parseNumber(args.values[name], name));
    const options = {
      faceAngle: number('face-angle'),
      weakAngle: number('weak-angle'),
      edgeAngle: number('edge-angle'),
      leastDangling: number('least-dangling'),
      seams: /** @type {any} */ (args.values.seams),
      splitAtLabels: !args.values['join-labels'],
    };
    const mesh = readOperand(mortise, args.positionals[0], args, streams);
    const model = namingFiles(args.positionals, () => mortise.model(mesh, options));
    if (args.values.json) streams.out(`${JSON.stringify(modelAsJson(model), asLists)}\n`);
    else streams.out(countsAsText(displayName(args.positionals[0]), model.counts));
    return exitCode.ok;
  },
};
