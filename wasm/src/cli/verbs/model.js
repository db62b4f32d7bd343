// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise model FILE [-o OUT]
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseOptional } from '../arguments.js';
import { asLists, displayName, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { keepsModels, modelTargetOf, nameRegions, readModelFile, sendModel, shortName } from '../model_files.js';

/** @param {import('../../index.js').Model} model */
function modelAsJson(model) {
  const { counts, attributes } = model;
  const rows = (/** @type {number} */ count, /** @type {(i: number) => object} */ row) => Array.from({ length: count }, (_, i) => row(i));
  return {
    counts,
    vertices: rows(counts.modelVertices, (i) => model.vertex(i)),
    edges: rows(counts.modelEdges, (i) => model.edge(i)),
    faces: rows(counts.modelFaces, (i) => model.face(i)),
    regions: rows(counts.regions + counts.voids + 1, (i) => model.region(i)),
    attributes,
  };
}

/** @param {import('../../index.js').AttributeMeasure} measure */
function measureText({ name, vertices, length, area, volume }) {
  const number = (/** @type {number} */ x) => String(Number(x.toPrecision(12)));
  /** @type {[string, number][]} */
  const parts = [['vertices', vertices], ['length', length], ['area', area], ['volume', volume]];
  return [name, ...parts.filter(([, much]) => much > 0).map(([what, much]) => `${what} ${number(much)}`)].join('  ');
}

/** @param {string} name @param {import('../../index.js').Model} model */
function modelAsText(name, model) {
  const { counts } = model;
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
  const names = model.measures().map(measureText).map((text, i) => `${(i === 0 ? 'names' : '').padEnd(14)}${text}`);
  return [`model         ${name}`, ...lines.map(([what, count]) => `${what.padEnd(14)}${count}`), ...names, ''].join('\n');
}

/** @type {import('../common.js').Verb} */
export const modelVerb = {
  help: `mortise model FILE [-o OUT]

The faces, edges, vertices and regions of a mesh, and the names on them; - is the standard input.

  --face-angle DEGREES   triangles at a larger angle are of different faces (default 40)
  --weak-angle DEGREES   edges above this one part faces too where they continue one
  --edge-angle DEGREES   edges that turn by more have a vertex there (default 45)
  --least-dangling N     creases that end inside a face after fewer edges do not count (default 0)
  --seams MODE           none, annulus, disc: edges that open faces (default annulus)
  --join-labels          triangles of different labels may lie on one face
  --name-regions         every region has the name of the file
  -o, --output FILE      write the model: .msh .vtk .vtu .mesh .inp .bdf, or .geo, which Gmsh fills with tetrahedra, with a .msh;
                         - is the standard output
  --format FORMAT        msh, msh22, vtk, vtu, mesh, inp, bdf, geo: of the output, and of a mesh from - (the standard input);
                         without an output also stl, stl-ascii, obj, ply, ply-ascii, off
  --json                 counts, entities and attributes as JSON
  -q, --quiet            print nothing
`,
  options: {
    ...writingOptions,
    'name-regions': { type: 'boolean' },
    'face-angle': { type: 'string' },
    'weak-angle': { type: 'string' },
    'edge-angle': { type: 'string' },
    'least-dangling': { type: 'string' },
    seams: { type: 'string' },
    'join-labels': { type: 'boolean' },
  },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('model needs one mesh file');
    const number = (/** @type {string} */ name) => parseOptional(args, name);
    const options = {
      faceAngle: number('face-angle'),
      weakAngle: number('weak-angle'),
      edgeAngle: number('edge-angle'),
      leastDangling: number('least-dangling'),
      seams: /** @type {any} */ (args.values.seams),
      splitAtLabels: !args.values['join-labels'],
    };
    const [file] = args.positionals;
    const target = args.values.output === undefined ? undefined : modelTargetOf(args);
    if (target !== undefined && !keepsModels(target)) throw invalidArgument(`a model is written as .msh, .vtk, .vtu, .mesh, .inp, .bdf or .geo, not as ${target.format}`);
    const model = readModelFile(mortise, file, args, streams, options);
    if (args.values['name-regions']) nameRegions(model, shortName(file));
    if (target !== undefined) sendModel(mortise, model, target, streams);
    if (args.values.quiet) return exitCode.ok;
    const text = args.values.json ? `${JSON.stringify(modelAsJson(model), asLists)}\n` : modelAsText(displayName(file), model);
    if (args.values.output === '-') streams.err(text);
    else streams.out(text);
    return exitCode.ok;
  },
};
