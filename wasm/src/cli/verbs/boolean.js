// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise union|intersect|subtract|xor|partition A B [C...] -o OUT, mortise combine EXPRESSION A B ..., mortise keep TAGS A B ...,
// mortise implant HOST COMPONENT ..., mortise resolve IN
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseNumbers, parseOptional } from '../arguments.js';
import { arrangingHelp, arrangingOptions, arrangingOptionsOf, displayName, namingFiles, printReport, readOperand, send } from '../common.js';
import { exitCode } from '../exit_codes.js';
import { remeshNotes } from './remesh.js';
import { anglesOf, checkNaming, keepsModels, modelOfResult, modelTargetOf, nameRegions, namingHelp, namingOptions, readNamed, sendModel, shortName, targetName } from '../model_files.js';

/**
 * What the verbs differ in. `word` is what stands before the files.
 * @typedef {object} Kind
 * @property {string} meaning
 * @property {string} [word] its name
 * @property {string} [files] what the files are; default A B [C...]
 * @property {Record<string, import('../arguments.js').Option>} [options]
 * @property {string} [optionHelp]
 * @property {(mortise: import('../../index.js').Mortise, operands: import('../../index.js').Operand[], options: import('../../index.js').BooleanOptions, word: string, values: Record<string, any>) =>
 *   import('../../index.js').BooleanResult} evaluate
 */

/** @type {Record<string, Kind>} */
const kinds = {
  union: { meaning: 'All that is inside any of the meshes.', evaluate: (mortise, operands, options) => mortise.union(operands, options) },
  intersect: { meaning: 'All that is inside every mesh.', evaluate: (mortise, operands, options) => mortise.intersect(operands, options) },
  subtract: { meaning: 'The first mesh without all others.', evaluate: (mortise, operands, options) => mortise.subtract(operands, options) },
  xor: { meaning: 'All that is inside an odd number of meshes.', evaluate: (mortise, operands, options) => mortise.symmetricDifference(operands, options) },
  partition: {
    meaning: 'The union with the faces that separate regions of different meshes, each once (the non-regularized union; also: nru).',
    evaluate: (mortise, operands, options) => mortise.partition(operands, options),
  },
  combine: {
    word: 'EXPRESSION',
    meaning: `What an expression says, for example "(a|b)&!c". The meshes are a, b, c ... in their order, or #0, #1, #2 ...
From tight to loose: ! outside, - without, & and, ^ an odd number, | or; parentheses.`,
    evaluate: (mortise, operands, options, word) => mortise.combine(word, operands, options),
  },
  keep: {
    word: 'TAGS',
    meaning: `Faces by tags with commas between them, after cutting all meshes along their contacts; the result may be open:
10 and 11 of the first mesh outside and inside others, 20 and 21 of the others, same and opposite where faces coincide.`,
    evaluate: (mortise, operands, options, word) => mortise.keep(/** @type {any} */ (word.split(',')), operands, options),
  },
  implant: {
    files: 'HOST COMPONENT [COMPONENT...]',
    meaning: `The host with components set into it, as a gun into a deck: host faces inside a component go, where faces coincide there is one.
A component stays entire; what lies inside both is the component's, the last one's where components overlap.`,
    options: { contact: { type: 'string' } },
    optionHelp: '  --contact keep|drop   the faces between host and component: keep them (the default), or drop them to make one body\n',
    evaluate: (mortise, operands, options, _, { contact }) => mortise.implant(/** @type {any} */ (operands), { ...options, contact }),
  },
  resolve: {
    files: 'IN',
    meaning: 'The boundary of what a mesh that overlaps or crosses itself covers.',
    evaluate: (mortise, operands, options) => resolveOne(mortise, operands, options),
  },
};

/**
 * @param {import('../../index.js').Mortise} mortise
 * @param {import('../../index.js').Operand[]} operands
 * @param {import('../../index.js').BooleanOptions} options
 */
function resolveOne(mortise, operands, options) {
  if (operands.length !== 1) throw invalidArgument('resolve needs one mesh file');
  return mortise.resolve(/** @type {any} */ (operands[0]), options);
}

/** @param {string} name */
function helpText(name) {
  const { meaning, word, files = 'A B [C...]', optionHelp = '' } = kinds[name];
  return `mortise ${name} ${word === undefined ? '' : `${word} `}${files} -o OUT

${meaning} Meshes may touch, coincide, contain one another and cross themselves; open ones are sheets.

${optionHelp}  -o, --output FILE     .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; .geo: for Gmsh, with a .msh; - is the standard output
  --format FORMAT       stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                        of the output, and of a mesh from - (the standard input)
  --json                print the report as JSON
  --plane NX,NY,NZ,D    one more operand, after the files: all that lies behind a plane
${arrangingHelp}  --simplify LEVEL      cut: without what the cut left inside triangles and on edges; coplanar: also across triangles of one plane
${namingHelp}  --remesh H            write the result with triangles of this size; --layers K: only in so many layers round the intersection graph
  --allow-uncertified   write the result even when it is not proven free of new crossings
  -q, --quiet           print no report
`;
}

/**
 * One operand per --plane, in the order typed.
 * @param {import('../arguments.js').Arguments} args
 */
function planesOf({ typed }) {
  const numbersOf = (/** @type {string} */ text) => /** @type {[number, number, number, number]} */ (parseNumbers(text, 'plane', 4));
  return typed.filter(({ name }) => name === 'plane').map(({ value }) => ({ plane: numbersOf(value) }));
}

/**
 * What is to be written, and how.
 * @typedef {object} Outcome
 * @property {import('../../index.js').BooleanResult} result
 * @property {string[]} files the operands that are files
 * @property {import('../model_files.js').Named[]} operands of these, then of planes
 * @property {import('../model_files.js').ModelTarget} target
 */

/**
 * The model of a result with all names asked for; a note about those it has not comes into the report.
 * @param {import('../../index.js').Mortise} mortise
 * @param {Outcome} outcome
 * @param {import('../arguments.js').Arguments} args
 * @param {Pick<import('../../index.js').ModelOptions, 'seams'>} [options]
 */
function namedModelOf(mortise, { result, files, operands }, args, options) {
  if (args.values['name-regions']) files.forEach((file, k) => nameRegions(operands[k].model, shortName(file)));
  const names = operands.map((_, k) => (k < files.length ? shortName(files[k]) : 'plane'));
  const sources = operands.map(({ mesh, model }) => model ?? mesh);
  const { model, interfaces, note } = modelOfResult(mortise, result, sources, { ...anglesOf(args), ...options, names });
  if (args.values.interfaces) model.attributes.push(...interfaces);
  if (note !== undefined) result.report.notes.push(note);
  return { model, hasAllNames: note === undefined };
}

/**
 * Writes a mesh, or its model where the format keeps one.
 * @param {import('../../index.js').Mortise} mortise
 * @param {{ mesh: import('../../index.js').Mesh, modelOf: () => import('../model_files.js').Model }} what
 * @param {import('../model_files.js').ModelTarget} target
 * @param {import('../common.js').Streams} streams
 */
function sendResult(mortise, { mesh, modelOf }, target, streams) {
  if (keepsModels(target)) sendModel(mortise, modelOf(), target, streams);
  else send(target, mortise.writeMesh(mesh, { format: /** @type {any} */ (target.format) }), streams);
}

/**
 * The result with triangles of the size wanted, and its model where the format keeps one; what became of it comes into the report.
 * @param {import('../../index.js').Mortise} mortise
 * @param {Outcome} outcome
 * @param {{ size: number, layers: number | undefined }} options
 * @param {import('../arguments.js').Arguments} args
 * @returns {import('../../index.js').RemeshResult & { model?: import('../model_files.js').Model }}
 */
function remeshResult(mortise, outcome, options, args) {
  const { result, operands, target } = outcome;
  const named = keepsModels(target) ? namedModelOf(mortise, outcome, args, { seams: 'none' }) : undefined;
  const remeshed = named?.hasAllNames ? mortise.remesh(/** @type {any} */ (named.model), options) : mortise.remesh(result, { ...options, operands: operands.map(({ mesh }) => mesh) });
  result.report.notes.push(...remeshNotes(remeshed));
  return remeshed;
}

/**
 * Writes a result; what there is to say of it comes into its report.
 * @param {import('../../index.js').Mortise} mortise
 * @param {Outcome} outcome
 * @param {import('../arguments.js').Arguments} args
 * @param {import('../common.js').Streams} streams
 */
function writeResult(mortise, outcome, args, streams) {
  const size = parseOptional(args, 'remesh');
  if (size === undefined) return sendResult(mortise, { mesh: outcome.result.mesh, modelOf: () => namedModelOf(mortise, outcome, args).model }, outcome.target, streams);
  const { mesh, model } = remeshResult(mortise, outcome, { size, layers: parseOptional(args, 'layers') }, args);
  return sendResult(mortise, { mesh, modelOf: () => model ?? mortise.model(mesh, anglesOf(args)) }, outcome.target, streams);
}

/**
 * @param {string} name
 * @returns {import('../common.js').Verb}
 */
export function booleanVerb(name) {
  const { word, evaluate, options } = kinds[name];
  return {
    help: helpText(name),
    options: {
      ...arrangingOptions,
      ...namingOptions,
      ...options,
      plane: { type: 'string' },
      simplify: { type: 'string' },
      remesh: { type: 'string' },
      layers: { type: 'string' },
    },
    run(mortise, args, streams) {
      const target = modelTargetOf(args);
      checkNaming(args, target);
      const files = word === undefined ? args.positionals : args.positionals.slice(1);
      if (args.values.remesh === undefined && args.values.layers !== undefined) throw invalidArgument('--layers needs --remesh');
      if (files.length === 0) throw invalidArgument(`${name} needs ${word === undefined ? '' : `${word} and `}mesh files`);
      const begin = performance.now();
      const read = (/** @type {string} */ file) => (keepsModels(target) ? readNamed(mortise, file, args, streams) : { mesh: readOperand(mortise, file, args, streams) });
      const operands = [...files.map(read), ...planesOf(args).map((plane) => ({ mesh: plane }))];
      const settings = { ...arrangingOptionsOf(args, target), simplify: args.values.simplify };
      const meshes = operands.map(({ mesh }) => mesh);
      const result = namingFiles(files, () => evaluate(mortise, meshes, settings, args.positionals[0], args.values));
      const { report } = result;
      const refused = !report.certified && !args.values['allow-uncertified'];
      if (!refused) writeResult(mortise, { result, files, operands, target }, args, streams);
      report.operands = report.operands.map((operand, i) => ({ name: i < files.length ? displayName(files[i]) : '--plane', ...operand }));
      report.milliseconds = performance.now() - begin;
      printReport(report, [name, refused ? 'not written' : targetName(target)], args, streams);
      if (refused) streams.err('mortise: the result is not certified and was not written; --allow-uncertified writes it\n');
      return refused ? exitCode.refused : exitCode.ok;
    },
  };
}
