// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise union|intersect|subtract A B [C...] -o OUT
// @ts-check

import { invalidArgument } from '../../errors.js';
import { displayName, namingFiles, printReport, readOperand, send, targetOf, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { storedResult } from '../stored.js';

const meaning = {
  union: 'All that is inside any of the meshes.',
  intersect: 'All that is inside every mesh.',
  subtract: 'The first mesh without all others.',
};

/** @param {'union' | 'intersect' | 'subtract'} operation */
function helpText(operation) {
  return `mortise ${operation} A B [C...] -o OUT

${meaning[operation]} Meshes are closed; they may touch, coincide, contain one another and cross themselves.

  -o, --output FILE     .stl .obj .ply .off; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off: of the output, and of a mesh from - (the standard input)
  --json                print the report as JSON
  --allow-uncertified   write the result even when it is not proven free of new crossings
  -q, --quiet           print no report
`;
}

/**
 * @param {'union' | 'intersect' | 'subtract'} operation
 * @returns {import('../common.js').Verb}
 */
export function booleanVerb(operation) {
  return {
    help: helpText(operation),
    options: { ...writingOptions, 'allow-uncertified': { type: 'boolean' } },
    run(mortise, args, streams) {
      const target = targetOf(args);
      if (args.positionals.length === 0) throw invalidArgument(`${operation} needs mesh files`);
      const begin = performance.now();
      const operands = args.positionals.map((file) => readOperand(mortise, file, args, streams));
      const result = namingFiles(args.positionals, () => mortise[operation](operands));
      const { mesh, report } = storedResult(mortise, result, target.format);
      const refused = !report.certified && !args.values['allow-uncertified'];
      if (!refused) send(target, mortise.writeMesh(mesh, { format: target.format }), streams);
      report.operands = report.operands.map((operand, i) => ({ name: displayName(args.positionals[i]), ...operand }));
      report.milliseconds = performance.now() - begin;
      printReport(report, [operation, refused ? 'not written' : `${displayName(target.file)} (${target.format})`], args, streams);
      if (refused) streams.err('mortise: the result is not certified and was not written; --allow-uncertified writes it\n');
      return refused ? exitCode.refused : exitCode.ok;
    },
  };
}
