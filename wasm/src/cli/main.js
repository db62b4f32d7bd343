#!/usr/bin/env node
// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The command `mortise`: finds the verb, runs it, turns errors into one line and an exit code.
// @ts-check

import { readFileSync } from 'node:fs';
import process from 'node:process';

import { MeshError, invalidArgument } from '../errors.js';
import { load } from '../node.js';
import { writeBytes } from '../node_files.js';
import { parseArguments } from './arguments.js';
import { errorText } from './error_text.js';
import { exitCode, exitCodeOf } from './exit_codes.js';
import { booleanVerb } from './verbs/boolean.js';
import { extrudeVerb } from './verbs/extrude.js';
import { imprintVerb } from './verbs/imprint.js';
import { inspectVerb } from './verbs/inspect.js';
import { makeVerb } from './verbs/make.js';
import { modelVerb } from './verbs/model.js';
import { qualityVerb } from './verbs/quality.js';
import { remeshVerb } from './verbs/remesh.js';
import { repairVerb } from './verbs/repair.js';
import { sliceVerb } from './verbs/slice.js';
import { splitVerb } from './verbs/split.js';
import { transformVerb } from './verbs/transform.js';

/** @type {Record<string, import('./common.js').Verb>} */
const verbs = {
  union: booleanVerb('union'),
  intersect: booleanVerb('intersect'),
  subtract: booleanVerb('subtract'),
  xor: booleanVerb('xor'),
  partition: booleanVerb('partition'),
  nru: booleanVerb('partition'),
  combine: booleanVerb('combine'),
  keep: booleanVerb('keep'),
  imprint: imprintVerb,
  implant: booleanVerb('implant'),
  resolve: booleanVerb('resolve'),
  split: splitVerb,
  repair: repairVerb,
  remesh: remeshVerb,
  quality: qualityVerb,
  extrude: extrudeVerb,
  slice: sliceVerb,
  transform: transformVerb,
  make: makeVerb,
  inspect: inspectVerb,
  model: modelVerb,
};

const help = `mortise VERB ...

Exact booleans of triangle meshes.

  mortise union A B [C...] -o OUT         all that is inside any
  mortise intersect A B [C...] -o OUT     all that is inside every one
  mortise subtract A B [C...] -o OUT      the first without the others
  mortise xor A B [C...] -o OUT           all that is inside an odd number
  mortise partition A B [C...] -o OUT     the union, its regions kept apart
  mortise combine "(a|b)&!c" A B C -o OUT what an expression says
  mortise keep 10,21,same A B -o OUT      faces by tags, the result may be open
  mortise imprint A B [C...] -o OUT-%d.ply  every one, split along their contacts
  mortise implant HOST PART -o OUT        a part set into a host, as a gun into a deck
  mortise resolve IN -o OUT               a mesh that overlaps itself, as what it covers
  mortise split IN -o OUT-%d.stl          its parts or its solids, one file each
  mortise repair IN -o OUT --STEP ...     mends what is asked for, says what it did
  mortise remesh IN -o OUT --size H       triangles of the size wanted on the same model
  mortise quality IN --size H             how good triangles are for that size
  mortise extrude IN -o OUT --to-z Z      the solid under or over a terrain
  mortise slice IN -o OUT --plane ...     the polygons of a plane cut
  mortise transform IN -o OUT [steps]     scale, rotate, translate, mirror
  mortise make SHAPE -o OUT [sizes]       box, sphere, cylinder, ...
  mortise inspect FILE                    counts, measures, self-intersections
  mortise model FILE [-o OUT.msh]         faces, edges, vertices and regions of a mesh, named

  mortise VERB --help, mortise --version

Files: .stl .obj .ply .off .msh .vtk .vtu .mesh, to write .glb .inp .bdf .geo too; - is the standard input or output.
Exit codes: 0 ok, 1 check failed, 2 usage, 3 bad input, 4 refused, 130 cancelled.
`;

function version() {
  return JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8')).version;
}

/** @returns {Promise<Uint8Array>} */
async function readStandardInput() {
  /** @type {Buffer[]} */
  const chunks = [];
  for await (const chunk of process.stdin) chunks.push(chunk);
  return Buffer.concat(chunks);
}

/** @param {string[]} positionals @returns {Promise<Uint8Array>} */
async function inputOf(positionals) {
  const count = positionals.filter((file) => file === '-').length;
  if (count > 1) throw invalidArgument('the standard input can be one mesh only');
  return count === 0 ? new Uint8Array() : readStandardInput();
}

/** @param {string} text */
function say(text) {
  process.stdout.write(text);
  return exitCode.ok;
}

/**
 * @param {string | undefined} name
 * @param {string[]} words after the verb
 * @returns {Promise<number>}
 */
async function runVerb(name, words) {
  if (name === '--version') return say(`${version()}\n`);
  if (name === '--help' || name === '-h' || name === 'help') return say(help);
  if (name === undefined || !Object.hasOwn(verbs, name)) {
    throw invalidArgument(`${name === undefined ? 'no verb' : `no verb '${name}'`}; the verbs are ${Object.keys(verbs).join(', ')}`);
  }
  const verb = verbs[name];
  if (words.includes('--help') || words.includes('-h')) return say(verb.help);
  const args = parseArguments(words, verb.options);
  const input = await inputOf(args.positionals);
  return verb.run(await load(), args, {
    stdin: () => input,
    out: (content) => process.stdout.write(content),
    err: (text) => process.stderr.write(text),
    writeFile: writeBytes,
  });
}

/** @param {string[]} argv @returns {Promise<number>} */
async function main(argv) {
  const [name, ...words] = argv;
  try {
    return await runVerb(name, words);
  } catch (error) {
    if (!(error instanceof MeshError)) throw error;
    process.stderr.write(errorText(error, name));
    return exitCodeOf(error.code);
  }
}

process.stdout.on('error', (error) => {
  // The reader of a pipe may have heard enough.
  if (/** @type {any} */ (error).code !== 'EPIPE') throw error;
});
process.exitCode = await main(process.argv.slice(2));
