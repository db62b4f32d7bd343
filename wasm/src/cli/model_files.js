// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files that keep models: operands with their names, results with what they inherit, projects for Gmsh.
// @ts-check

import { basename } from 'node:path';

import { MeshError, invalidArgument } from '../errors.js';
import { modelFormats } from '../formats.js';
import { parseOptional } from './arguments.js';
import { displayName, namingFiles, readOperand, readingFormat, send, targetOf } from './common.js';

/**
 * @typedef {import('./common.js').Arguments} Arguments
 * @typedef {import('./common.js').Mortise} Mortise
 * @typedef {import('./common.js').Streams} Streams
 * @typedef {import('./common.js').Target} Target
 * @typedef {import('../index.js').Model<any>} Model
 * @typedef {import('../index.js').MeshInput} MeshInput
 */

/**
 * A file for a mesh, or NAME.geo with NAME.msh for a project of Gmsh.
 * @typedef {Omit<Target, 'format'> & { format: import('../index.js').Format | 'geo' }} ModelTarget
 */

/**
 * What an operand is, and its model when it is known.
 * @typedef {{ mesh: MeshInput | import('../index.js').HalfSpace, model?: Model }} Named
 */

/** What every verb that can write models takes. @type {Record<string, import('./arguments.js').Option>} */
export const modelAngleOptions = { 'face-angle': { type: 'string' }, 'edge-angle': { type: 'string' } };

/** @type {Record<string, import('./arguments.js').Option>} */
export const namingOptions = { ...modelAngleOptions, interfaces: { type: 'boolean' }, 'name-regions': { type: 'boolean' } };

export const modelAngleHelp = `  --face-angle DEGREES  of the model in .msh .vtk .vtu .mesh .inp .bdf .geo: larger angles part faces (default 40)
  --edge-angle DEGREES  and where edges turn by more they have a vertex (default 45)
`;

export const namingHelp = `${modelAngleHelp}  --interfaces          names there for faces that operands share and edges where they cross: interface(hull.deck, gun.face 3)
  --name-regions        regions there have the names of the files they are in
`;

/** @param {Arguments} args */
export function anglesOf(args) {
  return { faceAngle: parseOptional(args, 'face-angle'), edgeAngle: parseOptional(args, 'edge-angle') };
}

/**
 * Where a mesh or its model goes.
 * @param {Arguments} args
 * @returns {ModelTarget}
 */
export function modelTargetOf(args) {
  const { output, format } = args.values;
  const isProject = format === 'geo' || (format === undefined && /\.geo$/i.test(output ?? ''));
  if (!isProject) return targetOf(args);
  if (output === undefined || output === '-') throw invalidArgument('a project for Gmsh is two files: -o NAME.geo writes NAME.msh too');
  return { file: output, format: 'geo' };
}

/** @param {ModelTarget} target */
export function keepsModels({ format }) {
  return format === 'geo' || modelFormats.some((known) => known === format);
}

/**
 * Refuses options about names where the file keeps none.
 * @param {Arguments} args
 * @param {ModelTarget} target
 */
export function checkNaming({ values }, target) {
  const given = Object.keys(namingOptions).find((name) => values[name] !== undefined);
  if (given !== undefined && !keepsModels(target)) throw invalidArgument(`--${given} needs an output that keeps models: .msh, .vtk, .vtu, .mesh, .inp, .bdf or .geo`);
}

/** The name of a file as operands are called by. @param {string} file */
export function shortName(file) {
  return file === '-' ? 'stdin' : basename(file).replace(/\.[^.]*$/, '');
}

/**
 * The model in a file, or in the standard input for `-`, with its names.
 * @param {Mortise} mortise
 * @param {string} file
 * @param {Arguments} args
 * @param {Streams} streams
 * @param {import('../index.js').ModelOptions} options
 */
export function readModelFile(mortise, file, args, { stdin }, options) {
  return namingFiles([file], () => (file === '-' ? mortise.readModel(stdin(), { ...readingFormat(args), ...options }) : mortise.readModel(file, options)));
}

/**
 * The model in a file with its names. One that is not sound enough for a model is its mesh, which booleans take.
 * @param {Mortise} mortise
 * @param {string} file
 * @param {Arguments} args
 * @param {Streams} streams
 * @returns {Named}
 */
export function readNamed(mortise, file, args, streams) {
  try {
    const model = readModelFile(mortise, file, args, streams, anglesOf(args));
    return { mesh: model.mesh, model };
  } catch (error) {
    if (!(error instanceof MeshError) || error.code !== 'INVALID_ARGUMENT') throw error;
    return { mesh: readOperand(mortise, file, args, streams) };
  }
}

/**
 * Puts a name on every region of a model but for its cavities.
 * @param {Model | undefined} model
 * @param {string} name
 */
export function nameRegions(model, name) {
  if (model === undefined) return;
  const { regions, voids } = model.counts;
  const ids = Array.from({ length: regions + voids }, (_, i) => i + 1).filter((id) => !model.region(id).void);
  if (ids.length > 0) model.attributes.push({ name, kind: 'material', targets: ids.map((id) => ({ dimension: 'region', id })) });
}

/**
 * The interfaces of a result without the edges round shared faces, which only repeat them: each goes by all faces at it.
 * @param {import('../index.js').ResultModel} model
 */
function tellingInterfaces(model) {
  const shared = new Set(model.interfaces.flatMap(({ targets }) => targets.filter(({ dimension }) => dimension === 'face').map(({ id }) => id)));
  const isRim = (/** @type {number} */ edge) => model.edge(edge).faces.some(({ face }) => shared.has(face));
  const telling = (/** @type {import('../index.js').ModelEntity} */ { dimension, id }) => dimension === 'face' || !isRim(id);
  return model.interfaces.map((attribute) => ({ ...attribute, targets: attribute.targets.filter(telling) })).filter(({ targets }) => targets.length > 0);
}

/**
 * The model of a result with the names of its operands, or one by labels where an operand is not sound enough for a model; `note` says so.
 * @param {Mortise} mortise
 * @param {any} result
 * @param {import('../index.js').ModelOperand[]} operands
 * @param {import('../index.js').ResultModelOptions} options
 * @returns {{ model: Model, interfaces: import('../index.js').Attribute[], note?: string }}
 */
export function modelOfResult(mortise, result, operands, options) {
  try {
    const model = mortise.resultModel(result, operands, options);
    return { model, interfaces: tellingInterfaces(model) };
  } catch (error) {
    if (!(error instanceof MeshError) || error.code !== 'INVALID_ARGUMENT' || error.details.operand === undefined) throw error;
    const { faceAngle, edgeAngle } = options;
    const note = `names are those of faces only: operand ${error.details.operand}: ${error.message}`;
    return { model: mortise.model(result.mesh ?? result, { faceAngle, edgeAngle }), interfaces: [], note };
  }
}

/**
 * @param {Mortise} mortise
 * @param {Model} model
 * @param {ModelTarget} target of a format that keeps models
 * @param {Streams} streams
 */
export function sendModel(mortise, model, { file, format }, streams) {
  if (format !== 'geo') return send({ file }, mortise.writeModel(model, { format: /** @type {any} */ (format) }), streams);
  const meshFile = `${file.replace(/\.geo$/i, '')}.msh`;
  const { mesh, script } = mortise.gmshProject(model, { meshFile: basename(meshFile) });
  streams.writeFile(meshFile, mesh);
  streams.writeFile(file, new TextEncoder().encode(script));
}

/** @param {ModelTarget} target */
export function targetName({ file, format }) {
  return `${displayName(file)} (${format})`;
}
