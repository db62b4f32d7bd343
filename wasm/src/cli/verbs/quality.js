// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise quality IN --size H
// @ts-check

import { invalidArgument } from '../../errors.js';
import { readOperand, readingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { sizeNumbers, sizeOptionsOf, sizesHelp, sizesOf } from '../size_options.js';

/** @type {import('../common.js').Verb} */
export const qualityVerb = {
  help: `mortise quality IN --size H

How good the triangles of a mesh are for the size wanted, of all of them and of the free ones, which no small feature of the model spoils;
- is the standard input.

  --reference FILE       how far the mesh and its model edges are from this one, both ways: say the mesh it was remeshed from
${sizesHelp}  --format FORMAT        stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh: of the standard input
  --json                 print the report as JSON
`,
  options: { ...readingOptions, ...sizeOptionsOf(sizeNumbers), reference: { type: 'string' } },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('quality needs one mesh file');
    const sizes = sizesOf(args, sizeNumbers, 'quality');
    const given = readOperand(mortise, args.positionals[0], args, streams);
    const { reference } = args.values;
    const about = reference === undefined ? {} : { reference: readOperand(mortise, reference, args, streams) };
    const { table, ...report } = mortise.quality(given, { ...sizes, ...about });
    streams.out(args.values.json ? `${JSON.stringify(report, null, 2)}\n` : table);
    return exitCode.ok;
  },
};
