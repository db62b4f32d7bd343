// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are: the numbers of the core by their names.
// @ts-check

import { checkMesh, checkOptions, describe } from './arguments.js';
import { invalidArgument } from './errors.js';
import { Model, checkModelOptions } from './model.js';
import { checkAngle, checkGiven, checkGivenModel, sizeOptions, withSizing } from './remesh.js';

/** @typedef {import('./glue_types.js').ModelSettings} ModelSettings */
/** @typedef {import('./index.js').OneWayDistance} OneWayDistance */

const qualityOptions = [...sizeOptions, 'featureAngle', 'curveAngle', 'reference', 'operands'];
const triangleMarks = ['count', 'minAngleDeg', 'maxAngleDeg', 'permilleAngleDeg', 'percentAngleDeg', 'medianAngleDeg', 'below30', 'above115', 'minRadiusRatio', 'meanRadiusRatio', 'maxEdgeRatio', 'meanEdgeRatio', 'maxGrowth'];
const lengthMarks = ['count', 'min', 'max', 'mean', 'inBand', 'maxGrowth'];
const obstacles = ['shortEdges', 'sharpCorners', 'closeFeatures'];
const binCount = 9;

/** Takes numbers in their order. */
class Reader {
  /** @param {Float64Array} numbers */
  constructor(numbers) {
    this.numbers = numbers;
    this.next = 0;
  }

  /** @param {number} count */
  list(count) {
    this.next += count;
    return [...this.numbers.subarray(this.next - count, this.next)];
  }

  /** @param {string[]} names @returns {any} */
  named(names) {
    const list = this.list(names.length);
    return Object.fromEntries(names.map((name, i) => [name, list[i]]));
  }

  lengths() {
    return { ...this.named(lengthMarks), bins: this.list(binCount) };
  }

  /** @returns {OneWayDistance} */
  distance() {
    const [max, inSizes, ...at] = this.list(5);
    return { max, inSizes, at: /** @type {[number, number, number]} */ (at) };
  }

  rest() {
    return this.list(this.numbers.length - this.next);
  }
}

/** @param {Float64Array | undefined} numbers @param {boolean} isByFace */
function deviationOf(numbers, isByFace) {
  if (numbers === undefined) return null;
  const reader = new Reader(numbers);
  const ways = { toReference: reader.distance(), fromReference: reader.distance(), curvesToReference: reader.distance(), curvesFromReference: reader.distance() };
  const flat = reader.rest();
  const pairs = flat.filter((_, i) => i % 2 === 0).map((to, f) => ({ to, from: flat[2 * f + 1] }));
  return { ...ways, byFace: isByFace ? pairs : null };
}

/**
 * A mesh, or what remesh answered: its model is known then.
 * @param {any} given
 * @param {ModelSettings} settings
 */
function checkJudged(given, settings) {
  const { mesh, modelFaces, modelEdges, refinement } = given ?? {};
  if (modelFaces === undefined && modelEdges === undefined) return { mesh: checkMesh(given, 'mesh'), settings };
  const checked = checkMesh(mesh, 'mesh');
  const triangles = (checked.triangles?.length ?? checked.positions.length / 3) / 3;
  if (!(modelFaces instanceof Uint32Array) || modelFaces.length !== triangles) throw invalidArgument(`modelFaces must be those of a remeshed mesh of ${triangles} triangles, not ${describe(modelFaces)}`);
  if (refinement !== undefined && !(refinement instanceof Float64Array)) throw invalidArgument(`refinement must be that of a remeshed mesh, not ${describe(refinement)}`);
  const { userEdges } = checkModelOptions({ userEdges: modelEdges });
  return { mesh: checked, settings: { ...settings, faceAngle: 180, splitAtLabels: false, groups: modelFaces, userEdges, refinement } };
}

/**
 * What the mesh is compared with.
 * @param {any} reference
 * @param {any} operands
 * @param {ModelSettings} settings
 * @returns {import('./glue_types.js').GivenModel | undefined}
 */
function checkReference(reference, operands, settings) {
  if (operands !== undefined && (reference === undefined || reference instanceof Model)) throw invalidArgument('operands are those of a reference that is a result: pass that too');
  if (reference === undefined) return undefined;
  if (reference instanceof Model) return checkGivenModel(reference, 'reference');
  const { mesh, sources } = checkGiven(reference, operands);
  return { mesh, settings: { ...settings, sources }, isModel: false };
}

/**
 * @param {import('./kept.js').Session} session
 * @param {import('./mesh_operations.js').Ask} ask
 * @returns {Pick<import('./index.js').Mortise, 'quality'>}
 */
export function qualityFunctions(session, ask) {
  return {
    quality: (/** @type {any} */ given, /** @type {any} */ options) => {
      const checked = checkOptions(options, qualityOptions);
      const { reference, operands, featureAngle = 40, curveAngle = 45 } = checked;
      const angles = { faceAngle: checkAngle(featureAngle, 'featureAngle'), edgeAngle: checkAngle(curveAngle, 'curveAngle') };
      const settings = checkModelOptions({ ...angles, seams: 'none' });
      const judged = checkJudged(given, settings);
      const about = checkReference(reference, operands, settings);
      const measure = (/** @type {number} */ sizing) => ask((core) => core.measureMesh(judged.mesh, { ...judged.settings, reference: about }, sizing), about === undefined ? [judged.mesh] : [judged.mesh, about.mesh], judged.mesh);
      const { numbers, deviation, table } = withSizing({ session, ask }, { mesh: judged.mesh, options: checked }, measure);
      const reader = new Reader(numbers);
      const report = { all: reader.named(triangleMarks), free: reader.named(triangleMarks), edges: reader.lengths(), freeEdges: reader.lengths(), obstacles: reader.named(obstacles), ...reader.named(['folds']), valences: reader.rest() };
      return { ...report, deviation: deviationOf(deviation, judged.settings.groups !== undefined), table };
    },
  };
}
