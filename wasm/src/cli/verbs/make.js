// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise make SHAPE -o OUT [parameters]
// @ts-check

import { invalidArgument } from '../../errors.js';
import { shapes } from '../../shapes.js';
import { parseNumber } from '../arguments.js';
import { kebab, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** Names of all parameters of all shapes. */
const parameterNames = [...new Set(Object.values(shapes).flatMap(({ parameters }) => Object.keys(parameters)))];

const parameterOptions = Object.fromEntries(parameterNames.map((name) => [kebab(name), { type: /** @type {'string'} */ ('string') }]));

/** Every second and third number joined: "0,0,1,0,1,1" is three pairs. @param {number[]} numbers */
function pairs(numbers) {
  if (numbers.length % 2 !== 0) throw invalidArgument('a polygon needs an even number of numbers');
  return numbers.flatMap((x, i) => (i % 2 === 0 ? [[x, numbers[i + 1]]] : []));
}

/**
 * The value of a parameter as make() takes it.
 * @param {string} name
 * @param {string} text
 */
function parseValue(name, text) {
  const numbers = text.split(',').map((part) => parseNumber(part, kebab(name)));
  if (name === 'outline' || name === 'profile') return pairs(numbers);
  return numbers.length === 1 ? numbers[0] : numbers;
}

/** @param {string} typed */
function shapeNamed(typed) {
  const shape = Object.keys(shapes).find((name) => kebab(name) === typed);
  if (shape === undefined) throw invalidArgument(`the shapes are ${Object.keys(shapes).map(kebab).join(', ')}, not '${typed}'`);
  return shape;
}

/** @param {any} fallback */
const defaultText = (fallback) => (fallback === undefined ? ' (needed)' : ` ${fallback}`);

const shapeLines = Object.entries(shapes).map(([name, { parameters }]) => {
  const options = Object.entries(parameters).map(([parameter, { fallback }]) => `--${kebab(parameter)}${defaultText(fallback)}`);
  return `  ${kebab(name).padEnd(12)}${options.join('  ')}`;
});

/** @type {import('../common.js').Verb} */
export const makeVerb = {
  help: `mortise make SHAPE -o OUT [parameters]

Shapes with their parameters and defaults; points and polygons are numbers with commas between them.

${shapeLines.join('\n')}

  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf
  --json                print the report as JSON
  -q, --quiet           print no report
`,
  options: { ...writingOptions, ...parameterOptions },
  run(mortise, args, streams) {
    if (args.positionals.length !== 1) throw invalidArgument(`make needs one shape: ${Object.keys(shapes).map(kebab).join(', ')}`);
    const shape = shapeNamed(args.positionals[0]);
    const given = parameterNames.filter((name) => args.values[kebab(name)] !== undefined);
    const parameters = Object.fromEntries(given.map((name) => [name, parseValue(name, args.values[kebab(name)])]));
    writePlain(mortise, mortise.make(/** @type {any} */ (shape), parameters), { verb: 'make', args, streams });
    return exitCode.ok;
  },
};
