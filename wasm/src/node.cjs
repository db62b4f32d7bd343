// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The package for require(): the same functions; the module is imported at the first call.
// @ts-check
'use strict';

/** @param {string} name */
function forward(name) {
  return async (/** @type {any[]} */ ...args) => /** @type {any} */ (await import('./node.js'))[name](...args);
}

const brand = Symbol.for('mortise.MeshError');

/** Recognises every error of the package: `error instanceof MeshError`. */
class MeshError extends Error {
  /**
   * @param {string} code
   * @param {string} message
   * @param {object} [details]
   * @param {{ cause?: unknown }} [options]
   */
  constructor(code, message, details = {}, options = undefined) {
    super(message, options);
    this.name = 'MeshError';
    this.code = code;
    this.details = details;
    Object.defineProperty(this, brand, { value: true });
  }

  /** @param {unknown} value */
  static [Symbol.hasInstance](value) {
    return typeof value === 'object' && value !== null && brand in value;
  }
}

exports.union = forward('union');
exports.intersect = forward('intersect');
exports.subtract = forward('subtract');
exports.symmetricDifference = forward('symmetricDifference');
exports.partition = forward('partition');
exports.combine = forward('combine');
exports.keep = forward('keep');
exports.imprint = forward('imprint');
exports.implant = forward('implant');
exports.resolve = forward('resolve');
exports.prepare = forward('prepare');
exports.inspect = forward('inspect');
exports.transform = forward('transform');
exports.roundToFloat32 = forward('roundToFloat32');
exports.make = forward('make');
exports.split = forward('split');
exports.splitPinches = forward('splitPinches');
exports.repair = forward('repair');
exports.extrudeTo = forward('extrudeTo');
exports.model = forward('model');
exports.resultModel = forward('resultModel');
exports.readModel = forward('readModel');
exports.writeModel = forward('writeModel');
exports.gmshProject = forward('gmshProject');
exports.sizing = forward('sizing');
exports.remesh = forward('remesh');
exports.predictTriangles = forward('predictTriangles');
exports.quality = forward('quality');
exports.slice = forward('slice');
exports.cornersToVertices = forward('cornersToVertices');
exports.groupByLabel = forward('groupByLabel');
exports.readMesh = forward('readMesh');
exports.writeMesh = forward('writeMesh');
exports.load = forward('load');
exports.MeshError = MeshError;
