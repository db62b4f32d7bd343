// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the bindings export; the glue the compiler writes carries no types.

import type { BooleanResult, GmshProject, GroupedMesh, ImprintResult, Mesh, MeshErrorCode, MeshErrorDetails, MeshPart } from './index.js';
import type { MergedFeatures, ModelTables, PinchFreeMesh, Provenance, RemeshResult, RepairedMesh, Report, Section, VertexMesh } from './index.js';

/** One of the two. */
export interface Answer<Value> {
  value?: Value;
  error?: { code: MeshErrorCode; message: string; details: MeshErrorDetails };
}

export interface CheckedMesh {
  positions: Float64Array | Float32Array;
  triangles?: Uint32Array;
  faceLabels?: Uint32Array;
  labelNames?: string[];
  walls?: Uint8Array;
  diagonals?: Uint8Array;
  vertexData?: CheckedChannel[];
  cornerData?: CheckedChannel[];
}

export interface CheckedChannel {
  name: string;
  components: number;
  kind: 'value' | 'vector' | 'normal';
  values: Float64Array | Float32Array;
}

/** Name and numbers of a step of `transform`. */
export type FlatStep = [string, ...number[]];

/** A mesh, all behind a plane, or a prepared operand by its number, moved. */
export type CheckedOperand = CheckedMesh | { plane: Float64Array; positions?: undefined } | { prepared: number; steps: FlatStep[]; positions?: undefined };

/** What every call that arranges operands is told. */
export interface BooleanSettings {
  listener: ((stage: string, fraction: number) => boolean) | undefined;
  inspect: boolean;
  requireSolids: boolean;
  simplify: 'off' | 'cut' | 'coplanar';
  certify: 'relative' | 'absolute';
  coordinates: 'float64' | 'float32';
  tolerance: number;
  contactMemory: number;
}

export interface Core {
  evaluateBoolean(operation: string, operands: CheckedOperand[], settings: BooleanSettings): Answer<BooleanResult>;
  evaluateExpression(expression: string, operands: CheckedOperand[], settings: BooleanSettings): Answer<BooleanResult>;
  keepFaces(tags: string[], operands: CheckedOperand[], settings: BooleanSettings): Answer<BooleanResult>;
  implant(contact: string, operands: CheckedOperand[], settings: BooleanSettings): Answer<BooleanResult>;
  imprint(operands: CheckedOperand[], settings: BooleanSettings): Answer<ImprintResult>;
  resolve(mesh: CheckedOperand, settings: BooleanSettings): Answer<BooleanResult>;
  /** Answers with a number for CheckedOperand. */
  prepare(mesh: CheckedMesh): Answer<number>;
  forgetPrepared(prepared: number): void;
  roundToFloat32(mesh: CheckedMesh): Answer<Mesh>;
  inspectMesh(mesh: CheckedMesh): Answer<Report>;
  transformMesh(mesh: CheckedMesh, steps: FlatStep[]): Answer<Mesh>;
  splitMesh(mesh: CheckedMesh, by: string): Answer<MeshPart[]>;
  splitPinches(mesh: CheckedMesh): Answer<PinchFreeMesh>;
  repairMesh(mesh: CheckedMesh, steps: string[]): Answer<RepairedMesh>;
  extrudeTo(mesh: CheckedMesh, z: number): Answer<Mesh>;
  cornersToVertices(mesh: CheckedMesh, missing: number): Answer<VertexMesh>;
  groupByLabel(mesh: CheckedMesh): Answer<GroupedMesh>;
  sliceMesh(mesh: CheckedMesh, plane: Float64Array): Answer<Section>;
  modelOf(mesh: CheckedMesh, settings: ModelSettings): Answer<BuiltModel>;
  readModel(bytes: Uint8Array, name: string, settings: ModelSettings): Answer<BuiltModel & { mesh: Mesh; attributes: FlatAttribute[] }>;
  resultModel(result: { mesh: CheckedMesh; provenance: Provenance }, operands: CheckedModelOperand[], settings: ModelSettings & ResultSettings): Answer<BuiltResultModel>;
  writeModel(model: CheckedModel, attributes: FlatAttribute[], format: string): Answer<Uint8Array>;
  gmshProject(model: CheckedModel, attributes: FlatAttribute[], meshFile: string): Answer<GmshProject>;
  /** Answers with a number for the functions below. */
  makeSizing(request: CheckedSizing): Answer<number>;
  forgetSizing(sizing: number): void;
  sizesAt(sizing: number, points: Float64Array | Float32Array): Answer<Float64Array>;
  gmshView(sizing: number, corners: Float64Array): Answer<string>;
  remesh(given: GivenModel, settings: RemeshSettings, sizing: number): Answer<RemeshedMesh>;
  mergeFeatures(given: GivenModel, settings: { least: number | undefined; listener: RemeshSettings['listener'] }): Answer<MergedMesh>;
  predictTriangles(given: GivenModel, features: FeatureSettings | undefined, sizing: number): Answer<number>;
  measureMesh(mesh: CheckedMesh, settings: ModelSettings & { reference: GivenModel | undefined; refinement?: Float64Array }, sizing: number): Answer<MeasuredMesh>;
  makeShape(name: string, numbers: Float64Array): Answer<Mesh>;
  readMesh(bytes: Uint8Array, name: string): Answer<Mesh>;
  writeMesh(mesh: CheckedMesh, format: string): Answer<Uint8Array>;
  formatOfPath(path: string): Answer<string>;
}

/** What `model` is told. */
export interface ModelSettings {
  faceAngle: number;
  weakAngle: number | undefined;
  edgeAngle: number;
  leastDangling: number;
  splitAtLabels: boolean;
  userEdges: Uint32Array;
  seams: 'none' | 'annulus' | 'disc';
  sources?: { provenance: Provenance; operands: CheckedOperand[] };
  /** Per triangle, and for facets of results only. */
  groups?: Uint32Array;
  normals?: Float64Array;
  planes?: Uint32Array;
}

/** What a model is built from, or its tables where no building anew would number its entities so. */
export type ModelRecipe = ModelSettings | { tables: ModelTables };

/** What is to become of features that are too small. */
export interface FeatureSettings {
  growth: number;
  least?: number;
}

/** What `remesh` is told beside. */
export interface RemeshSettings {
  features: FeatureSettings | undefined;
  listener: ((stage: string, fraction: number) => boolean) | undefined;
  mostTriangles: number;
  maxDeviation: number;
  isPaper: boolean;
  isFrontal: boolean;
  rounds: Float64Array | undefined;
  zone: Uint8Array | undefined;
  layers: number | undefined;
  /** What layers are round. */
  provenance: Provenance | undefined;
  lastRounds: number;
  audits: number;
}

/** A mesh without its small features. */
export interface MergedMesh extends MergedFeatures {
  mesh: Mesh;
  /** Per triangle: of the mesh given. */
  sources: Uint32Array;
}

export interface RemeshedMesh extends RemeshResult {
  /** Where a model was given. */
  tables?: ModelTables;
}

/** Numbers in the order of quality.js. */
export interface MeasuredMesh {
  numbers: Float64Array;
  deviation?: Float64Array;
  table: string;
}

/** What `resultModel` is told beside. */
export interface ResultSettings {
  splitAtAttributes: boolean;
  graphEdges: boolean;
  names: string[];
}

/** A model as it crosses. The core keeps none: it builds it again. */
export interface CheckedModel {
  mesh: CheckedMesh;
  settings: ModelRecipe;
}

/** A model, or a mesh with what its model is made by. */
export interface GivenModel extends CheckedModel {
  isModel: boolean;
}

export type CheckedModelOperand = (CheckedModel & { attributes: FlatAttribute[]; carried: boolean; plane?: undefined }) | { plane: Float64Array };

/** Sources of sizes; `model` is a position in the models they come with. */
export type CheckedSizeSource = { growth: number; radius: number } & (
  | { kind: 'plain'; corners: Float64Array; sizes: Float64Array }
  | { kind: 'graph'; points: Float64Array | Float32Array; edges: Uint32Array; size: number | undefined }
  | { kind: 'entity'; model: number; entity: number[]; size: number }
  | { kind: 'edgeCount'; model: number; count: number; smallest: number }
  | { kind: 'curvature'; model: number; chordError: number | undefined; perTurn: number | undefined; smallest: number; largest: number }
  | { kind: 'vertexSizes'; mesh: CheckedMesh; sizes: Float64Array }
  | { kind: 'attributes'; model: number }
);

export interface CheckedSizeSources {
  sources: CheckedSizeSource[];
  models: (CheckedModel & { attributes: FlatAttribute[] })[];
}

export interface CheckedSizing extends CheckedSizeSources {
  size: number;
  smallest: number;
}

/** `recipe` is what to build it again with, beside the settings it was built with. */
export interface BuiltModel {
  tables: ModelTables;
  recipe: Partial<ModelSettings>;
}

export interface BuiltResultModel extends BuiltModel {
  attributes: FlatAttribute[];
  interfaces: FlatAttribute[];
  lineage: Links;
}

/** An attribute as it crosses the border: JSON; numbers of kind and policies on split, merge and deletion; dimension and number of each target. */
export interface FlatAttribute {
  name: string;
  value: string;
  pieceName: string;
  codes: Uint32Array;
  targets: Uint32Array;
}

/** Links between entities of a result and of operands, by result. */
export interface Links {
  dimension: Uint32Array;
  result: Uint32Array;
  operand: Uint32Array;
  source: Uint32Array;
  measure: Float64Array;
}

export type CreateGlue = (options: {
  instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void): object;
}) => Promise<Core>;
