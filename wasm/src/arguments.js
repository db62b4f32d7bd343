// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Checks what a caller hands in before it crosses into the core, and says what to do instead.
// @ts-check

import { checkData } from './data_channels.js';
import { MeshError, invalidArgument } from './errors.js';
import { describe, isNumberArray } from './values.js';

export { describe };

const mostImpliedLabels = 65536;
const mostIndex = 0xffffffff;

/**
 * Coordinates as a typed array of 32 or 64 bit floats, three per vertex.
 * @param {any} positions
 * @param {string} name
 */
function checkPositions(positions, name) {
  if (positions instanceof Float64Array || positions instanceof Float32Array) {
    checkTriples(positions.length, `${name}.positions`);
    return positions;
  }
  if (!Array.isArray(positions) && !isNumberArray(positions)) {
    throw invalidArgument(`${name}.positions must be a Float64Array, a Float32Array or an array of numbers, not ${describe(positions)}`);
  }
  checkTriples(positions.length, `${name}.positions`);
  const wrong = Array.prototype.findIndex.call(positions, (/** @type {unknown} */ x) => typeof x !== 'number');
  if (wrong >= 0) throw invalidArgument(`${name}.positions[${wrong}] must be a number, not ${describe(positions[wrong])}`);
  return Float64Array.from(positions);
}

/**
 * @param {number} length
 * @param {string} name
 */
function checkTriples(length, name) {
  if (length % 3 !== 0) throw invalidArgument(`${name} holds ${length} numbers, which is not a multiple of 3`);
}

/**
 * Indices as a Uint32Array; an index no Uint32Array holds is an error, not a wrapped number.
 * @param {any} indices
 * @param {string} name
 * @param {number} perFace how many of them belong to one face
 */
function checkIndices(indices, name, perFace) {
  if (indices instanceof Uint32Array) return indices;
  if (!Array.isArray(indices) && !isNumberArray(indices)) {
    throw invalidArgument(`${name} must be a Uint32Array or an array of integers, not ${describe(indices)}`);
  }
  const wrong = Array.prototype.findIndex.call(indices, (/** @type {unknown} */ i) => !isIndex(i));
  if (wrong >= 0) {
    const face = Math.floor(wrong / perFace);
    throw new MeshError('BAD_INDEX', `${name}[${wrong}] is ${describe(indices[wrong])}, which is not an index`, { kind: 'faces', ids: [face] });
  }
  return Uint32Array.from(indices);
}

/** @param {unknown} value */
function isIndex(value) {
  return typeof value === 'number' && Number.isInteger(value) && value >= 0 && value <= mostIndex;
}

/**
 * @param {any} mesh
 * @param {number} faceCount
 * @param {string} name
 */
function checkLabels(mesh, faceCount, name) {
  if (mesh.faceLabels === undefined) {
    if (mesh.labelNames !== undefined) throw invalidArgument(`${name}.labelNames is given without ${name}.faceLabels`);
    return {};
  }
  const faceLabels = checkIndices(mesh.faceLabels, `${name}.faceLabels`, 1);
  if (faceLabels.length !== faceCount) {
    throw invalidArgument(`${name}.faceLabels has ${faceLabels.length} entries for ${faceCount} triangles`);
  }
  const most = faceLabels.reduce((a, b) => Math.max(a, b), -1);
  const labelNames = mesh.labelNames === undefined ? impliedNames(most, name) : checkNames(mesh.labelNames, name);
  if (most >= labelNames.length) {
    throw invalidArgument(`${name}.faceLabels uses label ${most}, but ${name}.labelNames has ${labelNames.length} names`);
  }
  return { faceLabels, labelNames };
}

/**
 * A byte per triangle.
 * @param {any} mesh
 * @param {'walls' | 'diagonals'} key
 * @param {number} faceCount
 * @param {string} name
 */
function checkBytes(mesh, key, faceCount, name) {
  const bytes = mesh[key];
  if (bytes === undefined) return {};
  if (!(bytes instanceof Uint8Array)) throw invalidArgument(`${name}.${key} must be a Uint8Array, not ${describe(bytes)}`);
  if (bytes.length !== faceCount) throw invalidArgument(`${name}.${key} has ${bytes.length} entries for ${faceCount} triangles`);
  return { [key]: bytes };
}

/**
 * @param {number} most
 * @param {string} name
 */
function impliedNames(most, name) {
  if (most >= mostImpliedLabels) throw invalidArgument(`${name}.faceLabels goes up to ${most}: give ${name}.labelNames as well`);
  return Array.from({ length: most + 1 }, (_, i) => String(i));
}

/**
 * @param {any} names
 * @param {string} name
 * @returns {string[]}
 */
function checkNames(names, name) {
  if (!Array.isArray(names) || names.some((text) => typeof text !== 'string')) {
    throw invalidArgument(`${name}.labelNames must be an array of strings`);
  }
  return names;
}

/**
 * What a mesh knows of each face beside its corners.
 * @param {any} mesh
 * @param {number} faceCount
 * @param {string} name
 */
function checkMarks(mesh, faceCount, name) {
  const bytes = { ...checkBytes(mesh, 'walls', faceCount, name), ...checkBytes(mesh, 'diagonals', faceCount, name) };
  return { ...checkLabels(mesh, faceCount, name), ...bytes };
}

/**
 * A mesh ready to cross into the core. Nothing of the caller is changed.
 * @param {any} mesh
 * @param {string} name how the caller knows it: "operand 0", "mesh"
 * @returns {import('./glue_types.js').CheckedMesh}
 */
export function checkMesh(mesh, name) {
  if (typeof mesh !== 'object' || mesh === null) throw invalidArgument(`${name} must be a mesh {positions, triangles}, not ${describe(mesh)}`);
  if (mesh instanceof Promise) throw invalidArgument(`${name} is a promise: await it first`);
  if (mesh.positions === undefined && mesh.mesh?.positions !== undefined) throw invalidArgument(`${name} is a result: pass its .mesh`);
  if (mesh.positions === undefined && mesh.isBufferGeometry) {
    throw invalidArgument(`${name} is a BufferGeometry: pass {positions: geometry.attributes.position.array, triangles: geometry.index?.array}`);
  }
  if (mesh.positions === undefined) throw invalidArgument(`${name} has no positions`);
  const positions = checkPositions(mesh.positions, name);
  if (mesh.triangles === undefined || mesh.triangles === null) {
    checkTriples(positions.length / 3, `${name} has no triangles, so its vertices count in threes; it`);
    const vertices = positions.length / 3;
    return { positions, ...checkMarks(mesh, vertices / 3, name), ...checkData(mesh, { vertices, corners: vertices }, name) };
  }
  const triangles = checkIndices(mesh.triangles, `${name}.triangles`, 3);
  checkTriples(triangles.length, `${name}.triangles`);
  const places = { vertices: positions.length / 3, corners: triangles.length };
  return { positions, triangles, ...checkMarks(mesh, triangles.length / 3, name), ...checkData(mesh, places, name) };
}

/** @param {unknown} value @param {string} name */
export function checkNumber(value, name) {
  if (typeof value !== 'number' || !Number.isFinite(value)) throw invalidArgument(`${name} must be a finite number, not ${describe(value)}`);
  return value;
}

/**
 * Normal and offset of a plane.
 * @param {any} plane
 */
export function checkPlane(plane) {
  if (plane === null || typeof plane !== 'object' || plane.length !== 4) {
    throw invalidArgument(`plane must be four numbers [nx, ny, nz, d], the points with n . p = d, not ${describe(plane)}`);
  }
  return Float64Array.from(plane, (x, i) => checkNumber(x, `plane[${i}]`));
}

/**
 * An operand: a mesh, or {plane} for all that lies behind a plane.
 * @param {any} operand
 * @param {string} name
 * @returns {import('./glue_types.js').CheckedOperand}
 */
export function checkOperand(operand, name) {
  return operand?.plane === undefined ? checkMesh(operand, name) : { plane: checkPlane(operand.plane) };
}

/**
 * Options with no unknown names; a misspelt option is an error rather than a surprise.
 * @param {any} options
 * @param {readonly string[]} known
 * @returns {any}
 */
export function checkOptions(options, known) {
  if (options === undefined) return {};
  if (typeof options !== 'object' || options === null || Array.isArray(options)) {
    throw invalidArgument(`options must be an object, not ${describe(options)}`);
  }
  const unknown = Object.keys(options).find((name) => !known.includes(name));
  if (unknown !== undefined) throw invalidArgument(`unknown option '${unknown}'; known: ${known.join(', ')}`);
  return options;
}

/**
 * One function for the core that reports progress and answers whether to go on; undefined when nobody listens.
 * @param {{ onProgress?: unknown, signal?: any }} options
 */
export function checkProgress({ onProgress, signal }) {
  if (onProgress !== undefined && typeof onProgress !== 'function') throw invalidArgument(`onProgress must be a function, not ${describe(onProgress)}`);
  if (signal !== undefined && typeof signal?.aborted !== 'boolean') throw invalidArgument(`signal must be an AbortSignal, not ${describe(signal)}`);
  if (signal?.aborted) throw new MeshError('CANCELLED', 'cancelled by the signal before the call began', {}, { cause: signal.reason });
  if (onProgress === undefined && signal === undefined) return undefined;
  return (/** @type {string} */ stage, /** @type {number} */ fraction) => {
    const answer = onProgress?.({ stage, fraction });
    return answer !== false && !signal?.aborted;
  };
}

/**
 * Is the result to be searched for self-intersections?
 * @param {{ inspect?: unknown }} options
 */
export function checkInspect({ inspect = true }) {
  if (typeof inspect !== 'boolean') throw invalidArgument(`inspect must be true or false, not ${describe(inspect)}`);
  return inspect;
}

/**
 * What becomes of the faces between host and component.
 * @param {unknown} contact
 * @returns {'keep' | 'drop'}
 */
export function checkContact(contact = 'keep') {
  if (contact !== 'keep' && contact !== 'drop') throw invalidArgument(`contact must be 'keep' or 'drop', not ${describe(contact)}`);
  return contact;
}

/**
 * Must every operand be a solid?
 * @param {{ kind?: unknown }} options
 */
export function checkKind({ kind }) {
  if (kind !== undefined && kind !== 'solid') throw invalidArgument(`kind must be 'solid' or left out, not ${describe(kind)}`);
  return kind === 'solid';
}

/**
 * What of the cut is taken out of the result again?
 * @param {{ simplify?: unknown }} options
 * @returns {'off' | 'cut' | 'coplanar'}
 */
export function checkSimplify({ simplify = 'off' }) {
  if (simplify !== 'off' && simplify !== 'cut' && simplify !== 'coplanar')
    throw invalidArgument(`simplify must be 'off', 'cut' or 'coplanar', not ${describe(simplify)}`);
  return simplify;
}

/**
 * What is the result to be proven of?
 * @param {{ certify?: unknown }} options
 * @returns {'relative' | 'absolute'}
 */
export function checkCertify({ certify = 'relative' }) {
  if (certify !== 'relative' && certify !== 'absolute') throw invalidArgument(`certify must be 'relative' or 'absolute', not ${describe(certify)}`);
  return certify;
}

/**
 * What coordinates does the result have?
 * @param {{ coordinates?: unknown }} options
 * @returns {'float64' | 'float32'}
 */
export function checkCoordinates({ coordinates = 'float64' }) {
  if (coordinates !== 'float64' && coordinates !== 'float32')
    throw invalidArgument(`coordinates must be 'float64' or 'float32', not ${describe(coordinates)}`);
  return coordinates;
}

/**
 * A length.
 * @param {{ tolerance?: unknown }} options
 */
export function checkTolerance({ tolerance = 0 }) {
  if (typeof tolerance !== 'number' || !(tolerance >= 0 && tolerance < Infinity)) throw invalidArgument(`tolerance must be a length, 0 or more, not ${describe(tolerance)}`);
  return tolerance;
}

/** Twice as much has no room in 4 GB while a list grows. */
const mostContactMemory = 2 ** 30;

/**
 * Bytes.
 * @param {{ contactMemory?: unknown }} options
 */
export function checkContactMemory({ contactMemory = mostContactMemory }) {
  if (typeof contactMemory !== 'number' || !(contactMemory >= 0 && contactMemory <= mostContactMemory))
    throw invalidArgument(`contactMemory must be a number of bytes up to 2 ** 30, not ${describe(contactMemory)}`);
  return Math.floor(contactMemory);
}

/**
 * Splits (a, b, ..., options?) or ([a, b, ...], options?) into operands and options.
 * @param {any[]} args
 * @param {string} operation
 */
export function splitOperands(args, operation) {
  const inArray = Array.isArray(args[0]);
  if (inArray && args.length > 2) throw invalidArgument(`${operation}([a, b, ...], options) takes two arguments, not ${args.length}`);
  const last = args[args.length - 1];
  const hasOptions = args.length > 1 && (inArray || isOptions(last));
  const operands = inArray ? args[0] : hasOptions ? args.slice(0, -1) : args;
  if (operands.length === 0) throw invalidArgument(`${operation} needs at least one mesh`);
  return { operands, options: hasOptions ? last : undefined };
}

/**
 * Operands as an array, where something else comes first in a call.
 * @param {any} operands
 * @param {string} name of the function
 * @returns {any[]}
 */
export function checkOperands(operands, name) {
  if (!Array.isArray(operands)) throw invalidArgument(`${name} takes an array of meshes second, not ${describe(operands)}`);
  if (operands.length === 0) throw invalidArgument(`${name} needs at least one mesh`);
  return operands;
}

/** @param {any} value */
function isOptions(value) {
  if (value === undefined) return true;
  return typeof value === 'object' && value !== null && ['positions', 'mesh', 'triangles', 'then', 'isBufferGeometry', 'plane', 'prepared'].every((name) => !(name in value));
}
