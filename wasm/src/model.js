// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A model: tables of entities from the core, read a row at a time, and attributes on them.
// @ts-check

import { checkMesh, checkOperand, checkOptions, describe } from './arguments.js';
import { entityCounts, flatAttributes, measuresOf, wholeAttributes } from './attributes.js';
import { invalidArgument } from './errors.js';
import { isNumberArray } from './values.js';

/** @typedef {import('./index.js').ModelTables} Tables */
/** @typedef {import('./index.js').MeshInput} MeshInput */

/** @type {Record<number, 'vertex' | 'edge' | 'face' | 'none'>} by the number the core has for them */
const dimensionNames = { 0: 'vertex', 1: 'edge', 2: 'face', 4: 'none' };
const seamModes = ['none', 'annulus', 'disc'];
export const modelOptions = ['faceAngle', 'weakAngle', 'edgeAngle', 'leastDangling', 'splitAtLabels', 'userEdges', 'seams', 'sources'];

/**
 * The numbers from begin[i] up to begin[i + 1].
 * @param {Uint32Array} begin
 * @param {number} i
 */
function rangeOf(begin, i) {
  return Array.from({ length: begin[i + 1] - begin[i] }, (_, k) => begin[i] + k);
}

/**
 * What a model is made of.
 * @template {MeshInput} Given
 * @typedef {object} Parts
 * @property {Given} mesh
 * @property {Tables} tables
 * @property {import('./glue_types.js').ModelRecipe} settings to build it again with
 * @property {import('./index.js').Attribute[]} attributes
 */

/** @template {MeshInput} Given */
export class Model {
  #tables;
  #settings;
  /** @type {Uint32Array | undefined} triangles by face */
  #sorted;
  /** @type {Uint32Array | undefined} */
  #begin;

  /** @param {Parts<Given>} parts */
  constructor({ mesh, tables, settings, attributes }) {
    this.#tables = tables;
    this.#settings = settings;
    this.mesh = mesh;
    this.attributes = attributes;
  }

  /**
   * What crosses into the core.
   * @param {string} name how the caller knows it: "model", "operands[0]"
   */
  checked(name) {
    return { mesh: checkMesh(this.mesh, `${name}.mesh`), settings: this.#settings, attributes: this.#checkedAttributes(`${name}.attributes`) };
  }

  /**
   * What it is made of there: entities of the same numbers, which no building anew would give them, and the same attributes.
   * @param {import('./index.js').Mesh} mesh
   * @param {Tables} tables
   */
  partsOn(mesh, tables) {
    return { mesh, tables, settings: { tables }, attributes: wholeAttributes(this.#checkedAttributes('model.attributes')) };
  }

  /**
   * The model on another mesh of it.
   * @param {import('./index.js').Mesh} mesh
   * @param {Tables} tables
   * @returns {Model<import('./index.js').Mesh>}
   */
  on(mesh, tables) {
    return new Model(this.partsOn(mesh, tables));
  }

  measures() {
    return measuresOf(this.#checkedAttributes('attributes'), this.#tables);
  }

  get counts() {
    const t = this.#tables;
    const voids = t.regionIsVoid.reduce((sum, isVoid) => sum + isVoid, 0);
    return {
      triangles: t.triangleFace.length,
      modelFaces: t.faceGenus.length,
      modelEdges: t.edgeStart.length,
      modelVertices: t.meshVertex.length,
      regions: t.regionVolume.length - 1 - voids,
      voids,
      meshEdgesOnModelEdges: t.path.length - t.edgeStart.length,
    };
  }

  get triangleFace() {
    return this.#tables.triangleFace;
  }

  get tables() {
    return this.#tables;
  }

  /** @param {number} i */
  vertex(i) {
    const t = this.#tables;
    this.#require('vertex', i, t.meshVertex.length);
    return { meshVertex: t.meshVertex[i], edges: [...t.edgesOfVertex.subarray(t.edgesOfVertexBegin[i], t.edgesOfVertexBegin[i + 1])] };
  }

  /** @param {number} i */
  edge(i) {
    const t = this.#tables;
    this.#require('edge', i, t.edgeStart.length);
    const faces = rangeOf(t.facesOfEdgeBegin, i).map((k) => ({ face: t.faceOfEdge[k], reversed: t.faceOfEdgeIsReversed[k] === 1 }));
    const path = t.path.slice(t.pathBegin[i], t.pathBegin[i + 1]);
    return { start: t.edgeStart[i], end: t.edgeEnd[i], seam: t.edgeIsSeam[i] === 1, length: t.edgeLength[i], faces, path };
  }

  /** @param {number} i */
  face(i) {
    const t = this.#tables;
    this.#require('face', i, t.faceGenus.length);
    const loops = rangeOf(t.loopsOfFaceBegin, i).map((l) => ({
      start: t.loopStart[l],
      edges: rangeOf(t.usesOfLoopBegin, l).map((k) => ({ edge: t.useEdge[k], reversed: t.useIsReversed[k] === 1 })),
    }));
    return { genus: t.faceGenus[i], area: t.faceArea[i], regionBehind: t.faceBehind[i], regionInFront: t.faceInFront[i], loops };
  }

  /** @param {number} i */
  region(i) {
    const t = this.#tables;
    this.#require('region', i, t.regionVolume.length);
    const shells = [...t.shellsOfRegion.subarray(t.shellsOfRegionBegin[i], t.shellsOfRegionBegin[i + 1])].map((s) =>
      rangeOf(t.sidesOfShellBegin, s).map((k) => ({ face: t.sideFace[k], front: t.sideIsFront[k] === 1 })),
    );
    return { volume: t.regionVolume[i], void: t.regionIsVoid[i] === 1, shells };
  }

  /** @param {number} face */
  trianglesOf(face) {
    this.#require('face', face, this.#tables.faceGenus.length);
    this.#sortTriangles();
    const begin = /** @type {Uint32Array} */ (this.#begin);
    return /** @type {Uint32Array} */ (this.#sorted).slice(begin[face], begin[face + 1]);
  }

  /** @param {number} meshVertex */
  entityOf(meshVertex) {
    const t = this.#tables;
    this.#require('mesh vertex', meshVertex, t.vertexEntity.length);
    return { dimension: dimensionNames[t.vertexDimension[meshVertex]], id: t.vertexEntity[meshVertex] };
  }

  /** @param {string} name */
  #checkedAttributes(name) {
    return flatAttributes(this.attributes, entityCounts(this.#tables), name);
  }

  #sortTriangles() {
    if (this.#sorted) return;
    const { triangleFace, faceGenus } = this.#tables;
    const begin = new Uint32Array(faceGenus.length + 1);
    for (const face of triangleFace) ++begin[face + 1];
    for (let i = 0; i < faceGenus.length; ++i) begin[i + 1] += begin[i];
    const next = begin.slice();
    this.#sorted = new Uint32Array(triangleFace.length);
    for (let t = 0; t < triangleFace.length; ++t) this.#sorted[next[triangleFace[t]]++] = t;
    this.#begin = begin;
  }

  /**
   * @param {string} kind
   * @param {number} i
   * @param {number} count
   */
  #require(kind, i, count) {
    if (!Number.isInteger(i) || i < 0 || i >= count) throw invalidArgument(`the model has no ${kind} ${typeof i === 'number' ? i : describe(i)}: there are ${count}`);
  }
}

/**
 * @param {any} edges
 * @returns {Uint32Array}
 */
function checkUserEdges(edges) {
  const flat = Array.isArray(edges) ? edges.flat() : edges;
  const isFlat = Array.isArray(flat) || isNumberArray(flat);
  if (!isFlat || flat.length % 2 !== 0 || !Array.prototype.every.call(flat, (i) => Number.isInteger(i) && i >= 0 && i <= 0xffffffff)) {
    throw invalidArgument(`userEdges must be pairs of vertices, not ${describe(edges)}`);
  }
  return Uint32Array.from(flat);
}

/**
 * Where each triangle of a result comes from. The core checks the numbers.
 * @param {any} provenance
 * @param {number} triangles
 * @param {string} name
 * @returns {import('./index.js').Provenance}
 */
export function checkProvenance(provenance, triangles, name) {
  const arrays = [provenance?.sourceOperand, provenance?.sourceFace, provenance?.flipped];
  if (!arrays.every((array) => array instanceof Uint32Array || array instanceof Uint8Array)) throw invalidArgument(`${name} must be the provenance of a result, not ${describe(provenance)}`);
  if (arrays.some(({ length }) => length !== triangles)) throw invalidArgument(`${name} is about ${arrays[0].length} triangles, but there are ${triangles}`);
  return provenance;
}

/**
 * @param {any} sources
 * @param {number} triangles
 */
function checkSources(sources, triangles) {
  const { provenance, operands } = checkOptions(sources, ['provenance', 'operands']);
  if (!Array.isArray(operands)) throw invalidArgument('sources must be {provenance, operands}: of a result, and the meshes it was made from');
  const meshes = operands.map((/** @type {any} */ mesh, /** @type {number} */ k) => checkOperand(mesh, `sources.operands[${k}]`));
  return { provenance: checkProvenance(provenance, triangles, 'sources.provenance'), operands: meshes };
}

/**
 * @param {any} options
 * @param {number} [triangles] of the mesh, where options may have sources
 * @returns {import('./glue_types.js').ModelSettings}
 */
export function checkModelOptions(options, triangles) {
  const checked = checkOptions(options, triangles === undefined ? modelOptions.slice(0, -1) : modelOptions);
  for (const name of ['faceAngle', 'weakAngle', 'edgeAngle', 'leastDangling']) {
    if (checked[name] !== undefined && typeof checked[name] !== 'number') throw invalidArgument(`${name} must be a number, not ${describe(checked[name])}`);
  }
  const { faceAngle = 40, weakAngle, edgeAngle = 45, leastDangling = 0, splitAtLabels = true, userEdges = [], seams = 'annulus', sources } = checked;
  if (!seamModes.includes(seams)) throw invalidArgument(`seams is one of ${seamModes.join(', ')}, not ${describe(seams)}`);
  if (typeof splitAtLabels !== 'boolean') throw invalidArgument(`splitAtLabels must be true or false, not ${describe(splitAtLabels)}`);
  if (!Number.isInteger(leastDangling) || leastDangling < 0 || leastDangling > 0xffffffff) {
    throw invalidArgument(`leastDangling must be a number of edges, not ${describe(leastDangling)}`);
  }
  const settings = { faceAngle, weakAngle, edgeAngle, leastDangling, splitAtLabels, userEdges: checkUserEdges(userEdges), seams };
  return sources === undefined || triangles === undefined ? settings : { ...settings, sources: checkSources(sources, triangles) };
}
