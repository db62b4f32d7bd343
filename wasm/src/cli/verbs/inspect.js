// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise inspect FILE
// @ts-check

import { invalidArgument } from '../../errors.js';
import { displayName, printReport, readingOptions, readOperand } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @type {import('../common.js').Verb} */
export const inspectVerb = {
  help: `mortise inspect FILE

Counts, closedness, measures and self-intersections of a mesh; - is the standard input.

  --json                print the report as JSON
  --check               exit with 1 unless the mesh is closed, oriented and free of self-intersections
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh: of the standard input
`,
  options: { ...readingOptions, check: { type: 'boolean' } },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('inspect needs one mesh file');
    const report = mortise.inspect(readOperand(mortise, args.positionals[0], args, streams));
    printReport(report, ['file', displayName(args.positionals[0])], args, streams);
    const sound = report.closed && report.oriented && report.selfIntersections === 0;
    return args.values.check && !sound ? exitCode.checkFailed : exitCode.ok;
  },
};
