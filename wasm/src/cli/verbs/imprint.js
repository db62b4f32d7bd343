// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise imprint A B [C...] -o OUT-%d.ply
// @ts-check

import { invalidArgument } from '../../errors.js';
import { arrangingHelp, arrangingOptions, arrangingOptionsOf, displayName, namingFiles, printReport, readOperand, send } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { anglesOf, checkNaming, keepsModels, modelAngleHelp, modelAngleOptions, modelOfResult, modelTargetOf, readNamed, sendModel } from '../model_files.js';

/** @type {import('../common.js').Verb} */
export const imprintVerb = {
  help: `mortise imprint A B [C...] -o OUT-%d.ply

Every mesh as it is, split along its contacts with the others: nothing is removed, and both sides have the same vertices,
edges and coinciding triangles. %d in the name becomes 1, 2, 3, ... in the order of the meshes. The report is about all of them
as one mesh, triangles that coincide counted once. Meshes are closed; they may touch, coincide, contain one another and cross.

  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf .geo, with %d in its name
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                        of the output, and of a mesh from - (the standard input)
  --json                print the report as JSON
${arrangingHelp}${modelAngleHelp}  --allow-uncertified   write the meshes even when they are not proven free of new crossings
  -q, --quiet           print no report
`,
  options: { ...arrangingOptions, ...modelAngleOptions },
  run(mortise, args, streams) {
    const target = modelTargetOf(args);
    checkNaming(args, target);
    const files = args.positionals;
    if (!target.file.includes('%d')) throw invalidArgument(`-o needs a file name with %d in it for the number of the mesh, not '${target.file}'`);
    if (files.length === 0) throw invalidArgument('imprint needs mesh files');
    const begin = performance.now();
    const read = (/** @type {string} */ file) => (keepsModels(target) ? readNamed(mortise, file, args, streams) : { mesh: readOperand(mortise, file, args, streams) });
    const operands = files.map(read);
    const meshes = operands.map(({ mesh }) => /** @type {import('../../index.js').MeshInput} */ (mesh));
    const { report, operands: imprinted } = namingFiles(files, () => mortise.imprint(meshes, arrangingOptionsOf(args, target)));
    const refused = !report.certified && !args.values['allow-uncertified'];
    const written = refused ? [] : imprinted;
    written.forEach((operand, i) => {
      const own = { ...target, file: target.file.replaceAll('%d', String(i + 1)) };
      if (!keepsModels(own)) return send(own, mortise.writeMesh(operand, { format: /** @type {any} */ (own.format) }), streams);
      const { model, note } = modelOfResult(mortise, operand, [operands[i].model ?? operands[i].mesh], anglesOf(args));
      if (note !== undefined) report.notes.push(`mesh ${i + 1}: ${note}`);
      return sendModel(mortise, model, own, streams);
    });
    report.operands = report.operands.map((operand, i) => ({ name: displayName(files[i]), ...operand }));
    report.milliseconds = performance.now() - begin;
    printReport(report, ['imprint', refused ? 'not written' : `${target.file} (${target.format})`], args, streams);
    if (refused) streams.err('mortise: the result is not certified and was not written; --allow-uncertified writes it\n');
    return refused ? exitCode.refused : exitCode.ok;
  },
};
