// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise extrude IN -o OUT --to-z Z
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseNumber } from '../arguments.js';
import { namingFiles, readOperand, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @type {import('../common.js').Verb} */
export const extrudeVerb = {
  help: `mortise extrude IN -o OUT --to-z Z

The solid between an open sheet that is a heightfield (a terrain) and the plane at height Z below or above it.

  --to-z Z              height of the plane
  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                        of the output, and of a mesh from - (the standard input)
  --json                print the report as JSON
  -q, --quiet           print no report
`,
  options: { ...writingOptions, 'to-z': { type: 'string' } },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('extrude needs one mesh file');
    if (args.values['to-z'] === undefined) throw invalidArgument('extrude needs --to-z');
    const z = parseNumber(args.values['to-z'], 'to-z');
    const sheet = readOperand(mortise, args.positionals[0], args, streams);
    const solid = namingFiles(args.positionals, () => mortise.extrudeTo(sheet, { z }));
    writePlain(mortise, solid, { verb: 'extrude', args, streams });
    return exitCode.ok;
  },
};
