// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The functions over a running core. Arrays cross the border by copying; what comes back belongs to JavaScript.
// @ts-check

import {
  checkCertify,
  checkContact,
  checkContactMemory,
  checkCoordinates,
  checkInspect,
  checkKind,
  checkMesh,
  checkOperand,
  checkOperands,
  checkOptions,
  checkSimplify,
  checkTolerance,
  describe,
  splitOperands,
} from './arguments.js';
import { MeshError, invalidArgument } from './errors.js';
import { fileFunctions } from './mesh_files.js';
import { meshOperations } from './mesh_operations.js';
import { modelFunctions } from './model_functions.js';
import { placesOf } from './places.js';
import { PreparedOperand, checkPrepared } from './prepared.js';
import { listenedTo } from './progress.js';
import { qualityFunctions } from './quality.js';
import { remeshFunctions } from './remesh.js';
import { checkShape } from './shapes.js';
import { makeSizing } from './sizing.js';
import { checkSteps } from './steps.js';

/** @typedef {import('./glue_types.js').Core} Core */
/** @typedef {import('./glue_types.js').CheckedMesh} CheckedMesh */
/** @typedef {import('./glue_types.js').CheckedOperand} CheckedOperand */

/**
 * @template Value
 * @typedef {import('./glue_types.js').Answer<Value>} Answer
 */

/** @typedef {import('./mesh_files.js').Host} Host */

/**
 * The value of a core's answer, or its error with the places it names.
 * @template Value
 * @param {Answer<Value>} answer
 * @param {CheckedOperand[]} meshes the operands its ids are about
 * @param {CheckedOperand} [whole] what they are about when the error names no operand; default: the first
 * @returns {Value}
 */
function valueOf({ value, error }, meshes, whole = meshes[0]) {
  if (error === undefined) return /** @type {Value} */ (value);
  const { code, message, details } = error;
  const places = placesOf(details.operand === undefined ? whole : meshes[details.operand], details);
  throw new MeshError(code, message, places === undefined ? details : { ...details, places });
}

/**
 * A core with what belongs to it.
 * @typedef {object} Session
 * @property {Core} core
 * @property {() => void} onStop called when the core stops for good
 * @property {boolean} stopped
 */

/**
 * Calls the core. What is no answer is a failure of the machine: memory of JavaScript, or a trap, which ends the core.
 * @template Value
 * @param {Session} session
 * @param {(core: Core) => Answer<Value>} call
 * @param {CheckedOperand[]} [meshes]
 * @param {CheckedOperand} [whole]
 * @returns {Value}
 */
function ask(session, call, meshes = [], whole) {
  if (session.stopped) throw new MeshError('INTERNAL_ERROR', 'the core stopped in an earlier call: load() gives a new one');
  let answer;
  try {
    answer = call(session.core);
  } catch (cause) {
    session.stopped = cause instanceof WebAssembly.RuntimeError;
    if (session.stopped) session.onStop();
    const outOfMemory = cause instanceof RangeError && /allocation|array length/i.test(cause.message);
    const text = /** @type {Error} */ (cause)?.message ?? String(cause);
    throw new MeshError(outOfMemory ? 'OUT_OF_MEMORY' : 'INTERNAL_ERROR', `the core stopped: ${text}`, {}, { cause });
  }
  return valueOf(answer, meshes, whole);
}

/** What every boolean takes. */
const booleanOptions = ['onProgress', 'signal', 'inspect', 'kind', 'simplify', 'certify', 'coordinates', 'tolerance', 'contactMemory'];

/**
 * @template {import('./index.js').BooleanResult} Result
 * @typedef {(core: Core, operands: CheckedOperand[], settings: import('./glue_types.js').BooleanSettings) => Answer<Result>} BooleanCall
 */

/**
 * @template {import('./index.js').BooleanResult} Result
 * @param {Session} session
 * @param {BooleanCall<Result>} call
 * @param {{ operands: any, options: any }} args
 * @returns {Result}
 */
function evaluateWith(session, call, { operands, options }) {
  const check = (/** @type {unknown} */ operand, /** @type {string} */ name) => checkPrepared(session, operand, name) ?? checkOperand(operand, name);
  const meshes = operands.map((/** @type {unknown} */ operand, /** @type {number} */ i) => check(operand, `operand ${i}`));
  const checked = checkOptions(options, booleanOptions);
  return listenedTo(checked, (listener) => {
    const settings = {
      listener,
      inspect: checkInspect(checked),
      requireSolids: checkKind(checked),
      simplify: checkSimplify(checked),
      certify: checkCertify(checked),
      coordinates: checkCoordinates(checked),
      tolerance: checkTolerance(checked),
      contactMemory: checkContactMemory(checked),
    };
    const begin = performance.now();
    const result = ask(session, (core) => call(core, meshes, settings), meshes);
    result.report.milliseconds = performance.now() - begin;
    return result;
  });
}

/**
 * @param {Session} session
 * @param {string} operation
 * @param {any[]} args
 */
function evaluate(session, operation, args) {
  return evaluateWith(session, (core, ...rest) => core.evaluateBoolean(operation, ...rest), splitOperands(args, operation));
}

/**
 * combine(expression, operands, options?)
 * @param {Session} session
 * @param {any[]} args
 */
function combine(session, [expression, operands, options]) {
  if (typeof expression !== 'string') throw invalidArgument(`combine takes an expression like '(a | b) & !c' first, not ${describe(expression)}`);
  return evaluateWith(session, (core, ...rest) => core.evaluateExpression(expression, ...rest), { operands: checkOperands(operands, 'combine'), options });
}

/**
 * keep(tags, operands, options?)
 * @param {Session} session
 * @param {any[]} args
 */
function keep(session, [tags, operands, options]) {
  if (!Array.isArray(tags) || tags.some((tag) => typeof tag !== 'string')) throw invalidArgument(`keep takes an array of tags first, not ${describe(tags)}`);
  return evaluateWith(session, (core, ...rest) => core.keepFaces(tags, ...rest), { operands: checkOperands(operands, 'keep'), options });
}

/**
 * implant(host, component, ..., options?)
 * @param {Session} session
 * @param {any[]} args
 */
function implant(session, args) {
  const { operands, options } = splitOperands(args, 'implant');
  const { contact, ...others } = checkOptions(options, ['contact', ...booleanOptions]);
  const checked = checkContact(contact);
  return evaluateWith(session, (core, ...rest) => core.implant(checked, ...rest), { operands, options: others });
}

/**
 * @param {Session} session
 * @param {import('./index.js').MeshInput} mesh
 * @returns {import('./index.js').PreparedOperand}
 */
function prepare(session, mesh) {
  const checked = checkMesh(mesh, 'mesh');
  const number = ask(session, (core) => core.prepare(checked), [checked]);
  return /** @type {any} */ (new PreparedOperand(session, number, checked));
}

/**
 * @param {Session} session
 * @param {import('./index.js').MeshInput} mesh
 * @returns {import('./index.js').Report}
 */
function inspectMesh(session, mesh) {
  const checked = checkMesh(mesh, 'mesh');
  const begin = performance.now();
  const report = ask(session, (core) => core.inspectMesh(checked), [checked]);
  report.milliseconds = performance.now() - begin;
  return report;
}

/**
 * @param {Core} core
 * @param {Host} host
 * @param {() => void} onStop called when the core stops for good
 * @returns {import('./index.js').Mortise}
 */
export function createSyncApi(core, host, onStop) {
  /** @type {Session} */
  const session = { core, onStop, stopped: false };
  /** @type {import('./mesh_operations.js').Ask} */
  const askCore = (call, ...meshes) => ask(session, call, ...meshes);
  const files = { host, formatOf: (/** @type {string} */ path) => askCore((running) => running.formatOfPath(path)) };
  const models = modelFunctions(askCore, files);
  return {
    union: (/** @type {any[]} */ ...args) => evaluate(session, 'union', args),
    intersect: (/** @type {any[]} */ ...args) => evaluate(session, 'intersect', args),
    subtract: (/** @type {any[]} */ ...args) => evaluate(session, 'subtract', args),
    symmetricDifference: (/** @type {any[]} */ ...args) => evaluate(session, 'symmetric_difference', args),
    partition: (/** @type {any[]} */ ...args) => evaluate(session, 'partition', args),
    combine: (/** @type {any[]} */ ...args) => combine(session, args),
    keep: (/** @type {any[]} */ ...args) => keep(session, args),
    imprint: (/** @type {any[]} */ ...args) => evaluateWith(session, (core, ...rest) => core.imprint(...rest), splitOperands(args, 'imprint')),
    implant: (/** @type {any[]} */ ...args) => implant(session, args),
    resolve: (mesh, options) => evaluateWith(session, (core, [only], ...rest) => core.resolve(only, ...rest), { operands: [mesh], options }),
    prepare: (mesh) => prepare(session, mesh),
    inspect: (mesh) => inspectMesh(session, mesh),
    transform: (mesh, steps) => {
      const checked = checkMesh(mesh, 'mesh');
      const flat = checkSteps(steps);
      return ask(session, () => core.transformMesh(checked, flat), [checked]);
    },
    roundToFloat32: (mesh) => {
      const checked = checkMesh(mesh, 'mesh');
      return ask(session, () => core.roundToFloat32(checked), [checked]);
    },
    make: (shape, parameters) => {
      const [name, numbers] = checkShape(shape, parameters);
      return ask(session, () => core.makeShape(name, numbers));
    },
    ...meshOperations(askCore),
    ...models,
    ...fileFunctions(askCore, files),
    sizing: (options) => /** @type {any} */ (makeSizing(session, askCore, options)),
    ...remeshFunctions(session, askCore, models.resultModel),
    ...qualityFunctions(session, askCore),
  };
}
