// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes of the sizes wanted on the same model, and how many triangles they take.
// @ts-check

import { checkMesh, checkOperand, checkOptions, describe } from './arguments.js';
import { invalidArgument } from './errors.js';
import { mergeFeatures } from './merge_features.js';
import { Model, checkModelOptions, checkProvenance } from './model.js';
import { listenedTo } from './progress.js';
import { ResultModel } from './result_model.js';
import { Sizing, makeSizing } from './sizing.js';

/** @typedef {import('./glue_types.js').CheckedMesh} CheckedMesh */
/** @typedef {import('./glue_types.js').CheckedOperand} CheckedOperand */
/** @typedef {import('./index.js').Provenance} Provenance */
/** @typedef {import('./kept.js').Session} Session */
/** @typedef {import('./mesh_operations.js').Ask} Ask */

const ownSizes = ['size', 'smallest', 'growth', 'sources'];
export const sizeOptions = [...ownSizes, 'sizing'];
const modelledOptions = [...sizeOptions, 'operands', 'featureAngle', 'curveAngle', 'features', 'minFeature'];
const remeshOptions = [...modelledOptions, 'mostTriangles', 'maxDeviation', 'zone', 'layers', 'preset', 'mesher', 'rounds', 'lastRounds', 'audits', 'onProgress', 'signal'];
/** What a model says itself. */
const modelWords = ['operands', 'featureAngle', 'curveAngle'];
const mostRounds = 1000;
const coarsest = 64;
const mostMeshTriangles = 2 ** 32 - 1;

const presets = ['default', 'paper'];
const meshers = ['local', 'frontal'];
const featureModes = ['keep', 'merge', 'refine'];

/**
 * One of some words.
 * @param {any} value
 * @param {string} name
 * @param {string[]} words
 */
function checkWord(value, name, words) {
  if (!words.includes(value)) throw invalidArgument(`${name} must be ${words.map((word) => `'${word}'`).join(' or ')}, not ${describe(value)}`);
}

/** What is to become of features that are too small: those that are left when small ones are merged become sources. @param {any} options */
function checkFeatures({ features = 'refine', minFeature, growth = 1.2 }) {
  checkWord(features, 'features', featureModes);
  if (minFeature === undefined) return features === 'keep' ? undefined : { growth };
  if (features === 'keep') throw invalidArgument("minFeature does not go with features: 'keep'");
  const isLength = Number.isFinite(minFeature) && (features === 'merge' ? minFeature > 0 : minFeature >= 0);
  if (!isLength) throw invalidArgument(`minFeature must be a ${features === 'merge' ? 'positive ' : ''}length, not ${describe(minFeature)}`);
  return { growth, least: minFeature };
}

/** @param {unknown} value @param {string} name */
function checkTimes(value, name) {
  if (!Number.isInteger(value) || Number(value) < 0 || Number(value) > mostRounds) throw invalidArgument(`${name} must be a whole number, 0 to ${mostRounds}, not ${describe(value)}`);
  return Number(value);
}

/** @param {unknown} value */
function checkRounds(value) {
  if (value === undefined) return undefined;
  const isFine = Array.isArray(value) && value.length <= mostRounds && value.every((times) => typeof times === 'number' && times >= 1 && times <= coarsest);
  if (!isFine) throw invalidArgument(`rounds must be an array of at most ${mostRounds} numbers, 1 to ${coarsest}, not ${describe(value)}`);
  return Float64Array.from(value);
}

/** @param {unknown} value */
function checkMostTriangles(value) {
  if (typeof value !== 'number' || !(value >= 1 && value <= mostMeshTriangles)) throw invalidArgument(`mostTriangles must be a number, 1 to ${mostMeshTriangles}, not ${describe(value)}`);
  return value;
}

/** @param {unknown} value */
function checkMaxDeviation(value) {
  if (value === undefined) return Infinity;
  if (typeof value !== 'number' || !(value > 0 && value < Infinity)) throw invalidArgument(`maxDeviation must be a positive length, not ${describe(value)}`);
  return value;
}

/**
 * Marks of triangles.
 * @param {any} zone
 * @param {number} triangles
 */
function checkZone(zone, triangles) {
  if (zone === undefined) return undefined;
  const isList = Array.isArray(zone) || (ArrayBuffer.isView(zone) && !(zone instanceof DataView));
  const marks = isList ? Array.from(/** @type {ArrayLike<unknown>} */ (zone)) : [];
  if (!isList || !marks.every((mark) => mark === 0 || mark === 1)) throw invalidArgument(`zone must be an array of 0 and 1, not ${describe(zone)}`);
  if (marks.length !== triangles) throw invalidArgument(`zone has ${marks.length} marks, not one for each of ${triangles} triangles`);
  return Uint8Array.from(/** @type {number[]} */ (marks));
}

/**
 * @param {any} layers
 * @param {boolean} isResult
 * @param {any} zone
 */
function checkLayers(layers, isResult, zone) {
  if (layers === undefined) return undefined;
  if (!isResult) throw invalidArgument('layers are those round the graph of a result: pass it with operands: [a, b], or what resultModel made of it');
  if (zone !== undefined) throw invalidArgument('zone and layers say the same: leave out one');
  return checkTimes(layers, 'layers');
}

/** @param {unknown} value @param {string} name */
export function checkAngle(value, name) {
  if (typeof value !== 'number' || !(value >= 0 && value <= 180)) throw invalidArgument(`${name} must be an angle in degrees, 0 to 180, not ${describe(value)}`);
  return value;
}

/**
 * The mesh, and where it comes from when it is that of a result.
 * @param {any} given
 * @param {any} operands
 * @returns {{ mesh: CheckedMesh, sources?: { provenance: Provenance, operands: CheckedOperand[] } }}
 */
export function checkGiven(given, operands) {
  const isResult = given?.mesh !== undefined && given.provenance !== undefined;
  if (operands === undefined) {
    if (isResult) throw invalidArgument('mesh is a result: say what it was made from with operands: [a, b], or pass its .mesh');
    return { mesh: checkMesh(given, 'mesh') };
  }
  if (!isResult) throw invalidArgument(`operands are those of a result, which comes first, not ${describe(given)}`);
  if (!Array.isArray(operands) || operands.length === 0) throw invalidArgument(`operands must be an array of the meshes the result was made from, not ${describe(operands)}`);
  const mesh = checkMesh(given.mesh, 'result.mesh');
  const triangles = (mesh.triangles?.length ?? mesh.positions.length / 3) / 3;
  const provenance = checkProvenance(given.provenance, triangles, 'result.provenance');
  return { mesh, sources: { provenance, operands: operands.map((operand, k) => checkOperand(operand, `operands[${k}]`)) } };
}

/**
 * A model as what is remeshed, or compared with.
 * @param {Model<any>} model
 * @param {string} name
 */
export function checkGivenModel(model, name) {
  const { mesh, settings } = model.checked(name);
  return { mesh, settings, isModel: true };
}

/**
 * What is to be remeshed: a model, with the provenance it may have, or a mesh with what its model is made by.
 * @param {any} given
 * @param {any} options
 * @returns {{ about: import('./glue_types.js').GivenModel, provenance: Provenance | undefined, model?: Model<any> }}
 */
function checkModelled(given, options) {
  if (!(given instanceof Model)) {
    const { operands, featureAngle = 40, curveAngle = 45 } = options;
    const { mesh, sources } = checkGiven(given, operands);
    const angles = { faceAngle: checkAngle(featureAngle, 'featureAngle'), edgeAngle: checkAngle(curveAngle, 'curveAngle') };
    return { about: { mesh, settings: { ...checkModelOptions({ ...angles, seams: 'none' }), sources }, isModel: false }, provenance: sources?.provenance };
  }
  const other = modelWords.find((name) => options[name] !== undefined);
  if (other !== undefined) throw invalidArgument(`a model says itself what its faces and edges are: leave out ${other}`);
  return { about: checkGivenModel(given, 'model'), provenance: given instanceof ResultModel ? given.provenance : undefined, model: given };
}

/**
 * What came of it, with the model on the new mesh where one was given.
 * @param {import('./glue_types.js').RemeshedMesh} answer
 * @param {Model<any> | undefined} model
 * @returns {any}
 */
function remeshedOf({ tables, ...result }, model) {
  return model === undefined || tables === undefined ? result : { ...result, model: model.on(result.mesh, tables) };
}

/**
 * The triangles of the mesh given, by those of the one that was remeshed.
 * @param {import('./index.js').RemeshResult} result
 * @param {Uint32Array} sources
 */
function inGiven(result, sources) {
  return { sources: result.sources.map((t) => sources[t]), kept: Uint32Array.from(new Set(result.kept.map((t) => sources[t]))).sort() };
}

/**
 * Calls with the number of a sizing: that of the caller, or one for this call.
 * @template Result
 * @param {{ session: Session, ask: Ask }} core
 * @param {{ mesh: CheckedMesh, options: any, model?: Model<any> }} about what sources are about that do not say it
 * @param {(sizing: number) => Result} call
 * @returns {Result}
 */
export function withSizing({ session, ask }, { mesh: { positions, triangles }, options, model }, call) {
  const { size, smallest, growth, sources, sizing } = options;
  if (sizing === undefined) {
    const made = makeSizing(session, ask, { size, smallest, growth, sources, model, mesh: { positions, triangles } });
    try {
      return call(made.numberIn(session, 'sizing'));
    } finally {
      made.dispose();
    }
  }
  const other = ownSizes.find((name) => options[name] !== undefined);
  if (other !== undefined) throw invalidArgument(`a sizing says all about sizes: leave out ${other}`);
  if (sizing instanceof Promise) throw invalidArgument('sizing is a promise: await it first');
  if (!(sizing instanceof Sizing)) throw invalidArgument(`sizing must be what sizing() gives, not ${describe(sizing)}`);
  return call(sizing.numberIn(session, 'sizing'));
}

/**
 * @param {Session} session
 * @param {Ask} ask
 * @param {import('./index.js').Mortise['resultModel']} resultModel
 * @returns {Pick<import('./index.js').Mortise, 'remesh' | 'predictTriangles'>}
 */
export function remeshFunctions(session, ask, resultModel) {
  /**
   * What is remeshed: without small features where these are to be merged; then `sources` are the triangles of the mesh given.
   * @param {ReturnType<typeof checkModelled>} asked
   * @param {any} checked
   * @param {{ least?: number } | undefined} features
   * @returns {ReturnType<typeof checkModelled> & { sources?: Uint32Array, merged?: import('./index.js').MergedFeatures }}
   */
  function subjectOf(asked, checked, features) {
    if (checked.features !== 'merge') return asked;
    const { given, ...after } = mergeFeatures({ ask, resultModel }, asked, { least: features?.least, listening: checked });
    return { ...checkModelled(given, checked), ...after };
  }

  return {
    remesh: (/** @type {any} */ given, /** @type {any} */ options) => {
      const checked = checkOptions(options, remeshOptions);
      const { mostTriangles = 2e7, preset = 'default', mesher = 'local', rounds, lastRounds = 10, audits = 6 } = checked;
      checkWord(preset, 'preset', presets);
      checkWord(mesher, 'mesher', meshers);
      const asked = checkModelled(given, checked);
      const features = checkFeatures(checked);
      const limits = { mostTriangles: checkMostTriangles(mostTriangles), maxDeviation: checkMaxDeviation(checked.maxDeviation), isPaper: preset === 'paper', isFrontal: mesher === 'frontal', rounds: checkRounds(rounds), lastRounds: checkTimes(lastRounds, 'lastRounds'), audits: checkTimes(audits, 'audits') };
      const { positions, triangles } = asked.about.mesh;
      const zone = checkZone(checked.zone, (triangles?.length ?? positions.length / 3) / 3);
      const layers = checkLayers(checked.layers, asked.provenance !== undefined, checked.zone);
      const { about, provenance, model, sources, merged } = subjectOf(asked, checked, features);
      const settings = { features, ...limits, zone: zone && sources ? Uint8Array.from(sources, (t) => zone[t]) : zone, layers, provenance };
      const remeshWith = (/** @type {number} */ sizing) => listenedTo(checked, (listener) => ask((core) => core.remesh(about, { ...settings, listener }, sizing), [about.mesh]));
      const answer = withSizing({ session, ask }, { mesh: asked.about.mesh, options: checked, model: asked.model }, remeshWith);
      const result = remeshedOf(answer, model);
      return sources === undefined ? result : { ...result, ...inGiven(result, sources), merged };
    },
    predictTriangles: (/** @type {any} */ given, /** @type {any} */ options) => {
      const checked = checkOptions(options, modelledOptions);
      const asked = checkModelled(given, checked);
      const features = checkFeatures(checked);
      const { about } = subjectOf(asked, checked, features);
      return withSizing({ session, ask }, { mesh: asked.about.mesh, options: checked, model: asked.model }, (sizing) => ask((core) => core.predictTriangles(about, features, sizing), [about.mesh]));
    },
  };
}
