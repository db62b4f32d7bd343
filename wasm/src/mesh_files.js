// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files and bytes of meshes and models: what is read, and where and how something is written.
// @ts-check

import { checkMesh, checkOptions, describe } from './arguments.js';
import { MeshError, invalidArgument } from './errors.js';
import { formats, readableFormats } from './formats.js';

/**
 * What differs between Node and browsers.
 * @typedef {object} Host
 * @property {(path: string | URL) => Uint8Array} readFile
 * @property {(path: string | URL, bytes: Uint8Array) => void} writeFile
 */

/**
 * @typedef {object} Files
 * @property {Host} host
 * @property {(path: string) => string} formatOf what a file of this name is written in
 */

/** Is this a Blob or a File? @param {unknown} source @returns {source is Blob} */
export function isBlob(source) {
  return typeof Blob !== 'undefined' && source instanceof Blob;
}

/** @param {unknown} value @returns {value is string | URL} */
function isPath(value) {
  return typeof value === 'string' || value instanceof URL;
}

/** @param {string | URL} path */
function nameOf(path) {
  return path instanceof URL ? decodeURIComponent(path.pathname) : path;
}

/**
 * @param {any} format
 * @param {readonly string[]} known
 */
function checkFormat(format, known) {
  if (format !== undefined && !known.includes(format)) throw new MeshError('UNKNOWN_FORMAT', `the formats are ${known.join(', ')}, not ${describe(format)}`);
  return format;
}

/** @param {unknown} source @param {string} call */
function checkBytes(source, call) {
  if (source instanceof Uint8Array) return source;
  if (source instanceof ArrayBuffer) return new Uint8Array(source);
  if (ArrayBuffer.isView(source)) return new Uint8Array(source.buffer, source.byteOffset, source.byteLength);
  if (isBlob(source)) throw invalidArgument(`a Blob is read by the asynchronous ${call} only`);
  throw invalidArgument(`${call} takes a file name, a Uint8Array, an ArrayBuffer or a Blob, not ${describe(source)}`);
}

/**
 * The bytes to be read, and a name that tells their format, or is empty.
 * @param {Files} files
 * @param {unknown} source
 * @param {any} options {format, name}
 * @param {string} call the function that reads
 */
export function readRequest({ host }, source, options, call) {
  const { format, name } = checkOptions(options, ['format', 'name']);
  checkFormat(format, readableFormats);
  const bytes = isPath(source) ? host.readFile(source) : checkBytes(source, call);
  const known = format === undefined ? (name ?? (isPath(source) ? nameOf(source) : '')) : `mesh.${format}`;
  return { bytes, name: String(known) };
}

/**
 * call(path, thing, options?) writes a file, call(thing, options) answers with bytes.
 * @param {Files} files
 * @param {any[]} args
 * @param {{ name: string, known: readonly string[] }} call its name, and the formats it can write
 * @param {(thing: any, format: string) => Uint8Array} bytesOf
 * @returns {any} bytes, or nothing
 */
export function writeBytes({ host, formatOf }, args, { name, known }, bytesOf) {
  const toFile = isPath(args[0]);
  const [thing, options] = toFile ? args.slice(1) : args;
  const { format } = checkOptions(options, ['format']);
  if (checkFormat(format, known) === undefined && !toFile) throw invalidArgument(`${name} needs the format of bytes: {format}`);
  const bytes = bytesOf(thing, format ?? checkFormat(formatOf(nameOf(args[0])), known));
  return toFile ? host.writeFile(args[0], bytes) : bytes;
}

/**
 * @param {import('./mesh_operations.js').Ask} ask
 * @param {Files} files
 * @returns {Pick<import('./index.js').Mortise, 'readMesh' | 'writeMesh'>}
 */
export function fileFunctions(ask, files) {
  return {
    readMesh: (source, options) => {
      const { bytes, name } = readRequest(files, source, options, 'readMesh');
      return ask((core) => core.readMesh(bytes, name));
    },
    writeMesh: (/** @type {any[]} */ ...args) =>
      writeBytes(files, args, { name: 'writeMesh', known: formats }, (mesh, format) => {
        const checked = checkMesh(mesh, 'mesh');
        return ask((core) => core.writeMesh(checked, format), [checked]);
      }),
  };
}
