// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise repair IN -o OUT --STEP ...
// @ts-check

import { invalidArgument } from '../../errors.js';
import { repairSteps } from '../../mesh_operations.js';
import { kebab, readOperand, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

const stepOptions = Object.fromEntries([...repairSteps, 'splitPinches'].map((name) => [kebab(name), { type: /** @type {'boolean'} */ ('boolean') }]));

/** @type {Record<string, string>} */
const reasons = {
  notOrientable: 'left: one-sided',
  notPlanar: 'left open: not in a plane',
  notSimple: 'left open: not simple, or in one another',
  wouldOverlap: 'left open: the filling would lie on the triangles round it',
};

/** @param {number} count @param {string} one */
const plural = (count, one) => `${count} ${one}${count === 1 ? '' : 's'}`;

/** @param {import('../../index.js').RepairNote} note */
function noteText({ step, outcome, count }) {
  const thing = step === 'fillPlanarHoles' ? 'hole' : outcome === 'done' ? 'triangle' : 'surface';
  return `--${kebab(step)}: ${plural(count, thing)}${outcome === 'done' ? '' : ` ${reasons[outcome]}`}`;
}

/** @type {import('../common.js').Verb} */
export const repairVerb = {
  help: `mortise repair IN -o OUT --STEP [--STEP ...]

Mends what is asked for and nothing else, in this order, and says what it did.

  --drop-degenerate     triangles without area; what was closed stays closed
  --drop-duplicates     triangles that repeat another
  --cancel-opposites    pairs of triangles that lie back to back
  --orient              triangles that run against most of their surface
  --flip-inside-out     closed shells that are inside out, with what lies in them; cavities stay
  --fill-planar-holes   simple holes whose corners lie in one plane exactly
  --split-pinches       copies vertices where bodies touch in an edge or a corner: manifold shells (formats with shared
                        vertices keep them; reading a file welds equal positions again)
  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                        of the output, and of a mesh from - (the standard input)
  --json                print the report as JSON
  -q, --quiet           print no report
`,
  options: { ...writingOptions, ...stepOptions },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('repair needs one mesh file');
    if (!Object.keys(stepOptions).some((name) => args.values[name])) throw invalidArgument('repair needs at least one step');
    const steps = Object.fromEntries(repairSteps.map((name) => [name, args.values[kebab(name)] ?? false]));
    const { mesh, done } = mortise.repair(readOperand(mortise, args.positionals[0], args, streams), steps);
    const split = args.values['split-pinches'] ? mortise.splitPinches(mesh) : undefined;
    const notes = done.map(noteText);
    if (split !== undefined) notes.push(`--split-pinches: ${plural((split.positions.length - mesh.positions.length) / 3, 'copied corner')}`);
    writePlain(mortise, split ?? mesh, { verb: 'repair', args, streams, notes });
    return exitCode.ok;
  },
};
