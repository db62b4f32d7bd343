// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The functions that make models of meshes, results and files, and write them.
// @ts-check

import { checkMesh, checkOptions, checkPlane, describe } from './arguments.js';
import { entityCounts, labelAttributes, wholeAttributes } from './attributes.js';
import { MeshError, invalidArgument } from './errors.js';
import { modelFormats } from './formats.js';
import { readRequest, writeBytes } from './mesh_files.js';
import { Model, checkModelOptions, checkProvenance, modelOptions } from './model.js';
import { PlacedOperand, PreparedOperand } from './prepared.js';
import { ResultModel } from './result_model.js';

/** @typedef {import('./glue_types.js').CheckedMesh} CheckedMesh */
/** @typedef {import('./glue_types.js').ModelSettings} ModelSettings */
/** @typedef {import('./mesh_files.js').Files} Files */

/** What `model` takes, but `sources`. */
const plainOptions = modelOptions.slice(0, -1);
const resultOptions = ['attributesOf', 'splitAtAttributes', 'graphEdges', 'names'];

/** @param {CheckedMesh} mesh */
function triangleCount({ positions, triangles }) {
  return triangles === undefined ? positions.length / 9 : triangles.length / 3;
}

/**
 * The properties of an object with these names, and the others.
 * @param {any} options
 * @param {readonly string[]} names
 */
function parted(options, names) {
  const entries = Object.entries(options);
  return [true, false].map((isNamed) => Object.fromEntries(entries.filter(([name]) => names.includes(name) === isNamed)));
}

/**
 * The mesh of a result and where it comes from; of an operand of an imprint also what parts its faces, how they lie to the others.
 * @param {any} result
 */
function checkResult(result) {
  if (result?.mesh !== undefined && result.provenance !== undefined) {
    const mesh = checkMesh(result.mesh, 'result.mesh');
    return { given: result.mesh, mesh, provenance: checkProvenance(result.provenance, triangleCount(mesh), 'result.provenance') };
  }
  if (!(result?.facetIds instanceof Uint32Array && result.category instanceof Uint8Array)) throw invalidArgument(`resultModel takes what an operation answered, or an operand of an imprint, not ${describe(result)}`);
  const mesh = checkMesh(result, 'result');
  const triangles = triangleCount(mesh);
  const provenance = { sourceOperand: new Uint32Array(triangles), sourceFace: result.sourceFace, flipped: new Uint8Array(triangles) };
  return { given: result, mesh, provenance: checkProvenance(provenance, triangles, 'result'), groups: Uint32Array.from(result.category) };
}

/** @param {any} names @param {number} count */
function checkNames(names, count) {
  if (names === undefined) return Array.from({ length: count }, (_, k) => (k < 26 ? String.fromCharCode(97 + k) : `#${k}`));
  if (!Array.isArray(names) || names.length !== count || names.some((name) => typeof name !== 'string')) {
    throw invalidArgument(`names must be ${count} strings, one for each operand, not ${describe(names)}`);
  }
  return names;
}

/** @param {any} attributesOf @param {number} count @returns {number[] | undefined} */
function checkAttributesOf(attributesOf, count) {
  if (attributesOf === undefined) return undefined;
  const isOperand = (/** @type {unknown} */ k) => Number.isInteger(k) && Number(k) >= 0 && Number(k) < count;
  if (!Array.isArray(attributesOf) || !attributesOf.every(isOperand)) throw invalidArgument(`attributesOf must be an array of operands 0 to ${count - 1}, not ${describe(attributesOf)}`);
  return attributesOf;
}

/** @param {any} model @param {string} call @returns {Model<any>} */
function checkModel(model, call) {
  if (model instanceof Promise) throw invalidArgument(`${call}: the model is a promise: await it first`);
  if (!(model instanceof Model)) throw invalidArgument(`${call} takes what model, resultModel or readModel gives, not ${describe(model)}`);
  return model;
}

/**
 * @param {import('./mesh_operations.js').Ask} ask
 * @param {Files} files
 * @returns {Pick<import('./index.js').Mortise, 'model' | 'resultModel' | 'readModel' | 'writeModel' | 'gmshProject'>}
 */
export function modelFunctions(ask, files) {
  /**
   * @template {import('./index.js').MeshInput} Given
   * @param {Given} mesh
   * @param {any} [options]
   * @param {string} [name]
   */
  function modelOf(mesh, options, name = 'mesh') {
    const checked = checkMesh(mesh, name);
    const { sources, ...settings } = checkModelOptions(options, triangleCount(checked));
    const { tables, recipe } = ask((core) => core.modelOf(checked, sources === undefined ? settings : { ...settings, sources }), [checked]);
    return new Model({ mesh, tables, settings: { ...settings, ...recipe }, attributes: labelAttributes(checked, tables.triangleFace) });
  }

  /**
   * @param {any} operand
   * @param {number} k
   * @returns {Model<any> | { plane: Float64Array }}
   */
  function operandModel(operand, k) {
    const name = `operands[${k}]`;
    if (operand instanceof Model) return operand;
    if (operand?.plane !== undefined) return { plane: checkPlane(operand.plane) };
    if (operand instanceof PreparedOperand || operand instanceof PlacedOperand) throw invalidArgument(`${name} is a prepared operand: give its mesh, moved as it was, or the model of that`);
    try {
      return modelOf(operand, undefined, name);
    } catch (error) {
      if (error instanceof MeshError) error.details = { ...error.details, operand: k };
      throw error;
    }
  }

  /**
   * @param {any} result
   * @param {any} operands
   * @param {any} [options]
   */
  function resultModel(result, operands, options) {
    const { given, mesh, provenance, groups } = checkResult(result);
    if (!Array.isArray(operands) || operands.length === 0) throw invalidArgument(`resultModel takes an array of the operands second, not ${describe(operands)}`);
    if (groups !== undefined && operands.length !== 1) throw invalidArgument(`an operand of an imprint comes from one operand: give its model only, not ${operands.length}`);
    const { attributesOf, splitAtAttributes = true, graphEdges = false, names, ...others } = checkOptions(options, [...plainOptions, ...resultOptions]);
    if (typeof splitAtAttributes !== 'boolean') throw invalidArgument(`splitAtAttributes must be true or false, not ${describe(splitAtAttributes)}`);
    if (typeof graphEdges !== 'boolean') throw invalidArgument(`graphEdges must be true or false, not ${describe(graphEdges)}`);
    const carried = checkAttributesOf(attributesOf, operands.length);
    const settings = checkModelOptions(others);
    const resultSettings = { ...settings, groups, splitAtAttributes, graphEdges, names: checkNames(names, operands.length) };
    const models = operands.map(operandModel);
    const checked = models.map((model, k) => (model instanceof Model ? { ...model.checked(`operands[${k}]`), carried: carried?.includes(k) ?? true } : model));
    const meshes = checked.map((operand) => ('mesh' in operand ? operand.mesh : operand));
    const { tables, recipe, attributes, interfaces, lineage } = ask((core) => core.resultModel({ mesh, provenance }, checked, resultSettings), meshes, mesh);
    const counts = models.map((model) => (model instanceof Model ? entityCounts(model.tables) : undefined));
    const parts = { mesh: given, tables, settings: { ...settings, ...recipe }, attributes: wholeAttributes(attributes) };
    const ofGraph = groups === undefined ? provenance : undefined;
    return new ResultModel(parts, { links: lineage, counts: entityCounts(tables), operands: counts, interfaces: wholeAttributes(interfaces), provenance: ofGraph });
  }

  /**
   * @param {any} source
   * @param {any} [options]
   */
  function readModel(source, options) {
    const [modelSettings, reading] = parted(checkOptions(options, ['format', 'name', ...plainOptions]), plainOptions);
    const settings = checkModelOptions(modelSettings);
    const { bytes, name } = readRequest(files, source, reading, 'readModel');
    const { mesh, tables, recipe, attributes: flat } = ask((core) => core.readModel(bytes, name, settings));
    const groups = wholeAttributes(flat);
    const labels = labelAttributes(mesh, tables.triangleFace).filter(({ name: label }) => !groups.some((group) => group.name === label));
    return new Model({ mesh, tables, settings: { ...settings, ...recipe }, attributes: [...groups, ...labels] });
  }

  /**
   * writeModel(path, model, options?) or writeModel(model, options).
   * @param {any[]} args
   * @returns {any}
   */
  function writeModel(...args) {
    return writeBytes(files, args, { name: 'writeModel', known: modelFormats }, (model, format) => {
      const { attributes, ...checked } = checkModel(model, 'writeModel').checked('model');
      return ask((core) => core.writeModel(checked, attributes, format), [checked.mesh]);
    });
  }

  /** @param {any} model @param {any} options */
  function gmshProject(model, options) {
    const { meshFile } = checkOptions(options, ['meshFile']);
    if (typeof meshFile !== 'string' || meshFile === '') throw invalidArgument(`gmshProject(model, {meshFile}) needs the name of the mesh's file, not ${describe(meshFile)}`);
    const { attributes, ...checked } = checkModel(model, 'gmshProject').checked('model');
    return ask((core) => core.gmshProject(checked, attributes, meshFile), [checked.mesh]);
  }

  return { model: modelOf, resultModel, readModel, writeModel, gmshProject };
}
