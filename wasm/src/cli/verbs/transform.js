// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise transform IN -o OUT [steps in the order typed]
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseNumber, parseNumbers } from '../arguments.js';
import { readOperand, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @typedef {import('../../index.js').TransformStep} TransformStep */

/** @param {string} text @param {string} option */
function parseVector(text, option) {
  return /** @type {[number, number, number]} */ (parseNumbers(text, option, 3));
}

/** @param {string} text */
function parseAxis(text) {
  if (text === 'x' || text === 'y' || text === 'z') return text;
  throw invalidArgument(`--mirror needs x, y or z, not '${text}'`);
}

/** @type {Record<string, (text: string) => TransformStep>} */
const stepOf = {
  scale: (text) => ({ scale: text.includes(',') ? parseVector(text, 'scale') : parseNumber(text, 'scale') }),
  'rotate-x': (text) => ({ rotateX: parseNumber(text, 'rotate-x') }),
  'rotate-y': (text) => ({ rotateY: parseNumber(text, 'rotate-y') }),
  'rotate-z': (text) => ({ rotateZ: parseNumber(text, 'rotate-z') }),
  translate: (text) => ({ translate: parseVector(text, 'translate') }),
  mirror: (text) => ({ mirror: parseAxis(text) }),
};

const stepOptions = Object.fromEntries(Object.keys(stepOf).map((name) => [name, { type: /** @type {'string'} */ ('string'), multiple: true }]));

/** @type {import('../common.js').Verb} */
export const transformVerb = {
  help: `mortise transform IN -o OUT [steps]

Steps are done in the order typed and may be repeated. Rotations are in degrees about an axis through the origin.

  --scale s | sx,sy,sz
  --rotate-x DEG  --rotate-y DEG  --rotate-z DEG
  --translate x,y,z     also -1,2,3
  --mirror x|y|z        what is outside stays outside
  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf
  --json                print the report as JSON
  -q, --quiet           print no report
`,
  options: { ...writingOptions, ...stepOptions },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument('transform needs one mesh file');
    const steps = args.typed.flatMap(({ name, value }) => (Object.hasOwn(stepOf, name) ? [stepOf[name](value)] : []));
    const mesh = mortise.transform(readOperand(mortise, args.positionals[0], args, streams), steps);
    writePlain(mortise, mesh, { verb: 'transform', args, streams });
    return exitCode.ok;
  },
};
