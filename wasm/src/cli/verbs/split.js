// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise split IN -o OUT-%d.stl [--by components|regions]
// @ts-check

import { invalidArgument } from '../../errors.js';
import { namingFiles, readOperand, send, targetOf, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/**
 * @typedef {object} WrittenPart
 * @property {string} name
 * @property {number} triangles
 * @property {number | null} volume
 * @property {number} area
 */

/** @param {WrittenPart} part */
function line({ name, triangles, volume, area }) {
  const inside = volume === null ? 'open' : `volume ${Number(volume.toPrecision(12))}`;
  return `${name}  ${triangles.toLocaleString('en-US')} triangle${triangles === 1 ? '' : 's'}, ${inside}, area ${Number(area.toPrecision(12))}\n`;
}

/** @type {import('../common.js').Verb} */
export const splitVerb = {
  help: `mortise split IN -o OUT-%d.stl

Writes every part of a mesh to a file of its own; %d in the name becomes 1, 2, 3, ...

  --by components       parts connected through edges (the default)
  --by regions          solids, each with its cavities; solids that touch in an edge or a corner are two
  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf, with %d in its name
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                        of the output, and of a mesh from - (the standard input)
  --json                print the list of parts as JSON
  -q, --quiet           print no list
`,
  options: { ...writingOptions, by: { type: 'string' } },
  run(mortise, args, streams) {
    const target = targetOf(args);
    if (!target.file.includes('%d')) throw invalidArgument(`-o needs a file name with %d in it for the number of the part, not '${target.file}'`);
    if (args.positionals.length !== 1) throw invalidArgument('split needs one mesh file');
    const mesh = readOperand(mortise, args.positionals[0], args, streams);
    const parts = namingFiles(args.positionals, () => mortise.split(mesh, { by: args.values.by ?? 'components' }));
    const written = parts.map((part, i) => {
      const name = target.file.replaceAll('%d', String(i + 1));
      send({ ...target, file: name }, mortise.writeMesh(part, { format: target.format }), streams);
      const { triangles, volume, area } = mortise.inspect(part);
      return { name, triangles, volume, area };
    });
    if (!args.values.quiet) streams.out(args.values.json ? `${JSON.stringify({ parts: written }, null, 2)}\n` : written.map(line).join(''));
    return exitCode.ok;
  },
};
