// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the verbs of the command share: options, files or pipes in and out, and printed reports.
// @ts-check

import { MeshError, invalidArgument } from '../errors.js';
import { formats, readableFormats, writtenOnly } from '../formats.js';
import { parseOptional } from './arguments.js';
import { reportText } from './report_text.js';

/**
 * @typedef {import('./arguments.js').Option} Option
 * @typedef {import('./arguments.js').Arguments} Arguments
 * @typedef {import('../index.js').Mortise} Mortise
 * @typedef {import('../index.js').Format} Format
 * @typedef {import('../index.js').Report} Report
 */

/**
 * Where a verb reads and prints.
 * @typedef {object} Streams
 * @property {() => Uint8Array} stdin all of the standard input
 * @property {(content: string | Uint8Array) => void} out
 * @property {(text: string) => void} err
 * @property {(path: string, bytes: Uint8Array) => void} writeFile
 */

/**
 * `run` answers with the exit code.
 * @typedef {object} Verb
 * @property {string} help
 * @property {Record<string, Option>} options
 * @property {(mortise: Mortise, args: Arguments, streams: Streams) => number} run
 */

/** @type {Record<string, Option>} */
export const readingOptions = {
  help: { type: 'boolean', short: 'h' },
  json: { type: 'boolean' },
  format: { type: 'string' },
};

/** @type {Record<string, Option>} */
export const writingOptions = { ...readingOptions, output: { type: 'string', short: 'o' }, quiet: { type: 'boolean', short: 'q' } };

/**
 * What every verb that arranges meshes takes.
 * @type {Record<string, Option>}
 */
export const arrangingOptions = {
  ...writingOptions,
  'allow-uncertified': { type: 'boolean' },
  kind: { type: 'string' },
  certify: { type: 'string' },
  tolerance: { type: 'string' },
};

export const arrangingHelp = `  --kind solid          refuse open meshes, naming their open edges
  --tolerance LENGTH    meshes this near are made to share vertices, edges and faces, which moves no vertex farther
  --certify absolute    certified only if no triangles cross, those of the operands included
`;

/**
 * What binary STL and GLB files store is float32, so this is what gets certified.
 * @param {Arguments} args
 * @param {{ format: string }} target
 * @returns {import('../index.js').BooleanOptions}
 */
export function arrangingOptionsOf(args, { format }) {
  const { kind, certify } = args.values;
  return /** @type {any} */ ({ kind, certify, tolerance: parseOptional(args, 'tolerance'), coordinates: format === 'stl' || format === 'glb' ? 'float32' : 'float64' });
}

/** How a report names a file. @param {string} file */
export function displayName(file) {
  return file === '-' ? 'standard stream' : file;
}

/**
 * Does some work on files; an error about one of them begins with its name.
 * @template Result
 * @param {string[]} files the operands in their order
 * @param {() => Result} work
 * @returns {Result}
 */
export function namingFiles(files, work) {
  try {
    return work();
  } catch (error) {
    const file = error instanceof MeshError && error.code !== 'FILE_FAILED' ? files[error.details.operand ?? (files.length === 1 ? 0 : -1)] : undefined;
    if (file !== undefined) /** @type {Error} */ (error).message = `${displayName(file)}: ${/** @type {Error} */ (error).message}`;
    throw error;
  }
}

/**
 * What --format says of the standard input: nothing, where it is of a format that is only written.
 * @param {Arguments} args
 */
export function readingFormat({ values: { format } }) {
  return format === undefined || format === 'geo' || writtenOnly.includes(format) ? {} : { format };
}

/**
 * The mesh in a file, or in the standard input for `-`. The format of a pipe is told by its content, or else by --format.
 * @param {Mortise} mortise
 * @param {string} file
 * @param {Arguments} args
 * @param {Streams} streams
 */
export function readOperand(mortise, file, args, { stdin }) {
  return namingFiles([file], () => (file === '-' ? mortise.readMesh(stdin(), readingFormat(args)) : mortise.readMesh(file)));
}

/**
 * @typedef {object} Target
 * @property {string} file
 * @property {Format} format
 */

/**
 * Where the mesh goes, and in which format: --format, or what the name ends in.
 * @param {Arguments} args
 * @returns {Target}
 */
export function targetOf({ values }) {
  const file = values.output;
  if (file === undefined) throw invalidArgument('-o FILE is missing (-o - writes to the standard output)');
  if (values.format === undefined && file === '-') throw invalidArgument('-o - needs --format');
  if (values.format !== undefined && !formats.includes(values.format)) throw invalidArgument(`--format is one of ${formats.join(', ')}, not '${values.format}'`);
  return { file, format: values.format ?? formatOfName(file) };
}

/** @param {string} file @returns {Format} */
function formatOfName(file) {
  const extension = /\.(stl|obj|ply|off|glb|msh|vtk|vtu|mesh|inp|bdf|nas)$/i.exec(file)?.[1].toLowerCase();
  if (extension === undefined) throw invalidArgument(`'${file}' does not end in .stl, .obj, .ply, .off, .glb, .msh, .vtk, .vtu, .mesh, .inp, .bdf or .nas: name the format with --format`);
  return extension === 'nas' ? 'bdf' : /** @type {Format} */ (extension);
}

/**
 * @param {{ file: string }} target
 * @param {Uint8Array} bytes
 * @param {Streams} streams
 */
export function send({ file }, bytes, streams) {
  if (file === '-') streams.out(bytes);
  else streams.writeFile(file, bytes);
}

/**
 * Typed arrays are lists in JSON.
 * @param {string} _
 * @param {unknown} value
 */
export function asLists(_, value) {
  return value instanceof Uint32Array || value instanceof Float64Array ? [...value] : value;
}

/**
 * Prints a report: on the standard output, or on the standard error when the mesh goes to the standard output.
 * @param {Report} report
 * @param {[string, string]} title
 * @param {Arguments} args
 * @param {Streams} streams
 */
export function printReport(report, title, { values }, streams) {
  if (values.quiet) return;
  const text = values.json ? `${JSON.stringify(report, asLists, 2)}\n` : reportText(report, title);
  if (values.output === '-') streams.err(text);
  else streams.out(text);
}

/**
 * The mesh that a file holds, when its format can be read.
 * @param {Mortise} mortise
 * @param {Uint8Array} bytes
 * @param {Format} format
 */
function heldBy(mortise, bytes, format) {
  const readable = readableFormats.find((known) => known === format);
  return readable === undefined ? undefined : mortise.readMesh(bytes, { format: readable });
}

/**
 * Of a verb that makes a mesh without a boolean; `notes` come first in its report, `more` is for JSON.
 * @typedef {{ verb: string, args: Arguments, streams: Streams, notes?: string[], more?: object }} PlainCall
 */

/**
 * Reports what a file holds.
 * @param {Mortise} mortise
 * @param {import('../index.js').Mesh} mesh
 * @param {{ file: string, format: string }} target
 * @param {PlainCall} call
 */
export function printPlain(mortise, mesh, { file, format }, { verb, args, streams, notes = [], more = {} }) {
  const report = mortise.inspect(mesh);
  report.notes.unshift(...notes);
  printReport({ ...report, ...more }, [verb, `${displayName(file)} (${format})`], args, streams);
}

/**
 * Writes a mesh that no boolean made, and reports what the file then holds, or the mesh where its format is not read.
 * @param {Mortise} mortise
 * @param {import('../index.js').Mesh} mesh
 * @param {PlainCall} call
 */
export function writePlain(mortise, mesh, call) {
  const target = targetOf(call.args);
  const bytes = mortise.writeMesh(mesh, { format: target.format });
  send(target, bytes, call.streams);
  printPlain(mortise, heldBy(mortise, bytes, target.format) ?? mesh, target, call);
}

/** `segmentCount` as an option: `segment-count`. @param {string} name */
export function kebab(name) {
  return name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}
