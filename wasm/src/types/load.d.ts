// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The same functions without promises.

import type { BooleanOptions, BooleanResult, FaceTag, ImplantOptions, ImprintResult, ImprintedOperand } from './booleans.js';
import type { Format, ReadOptions, WriteOptions } from './files.js';
import type { Mesh, MeshInput } from './mesh.js';
import type { GroupedMesh, MeshPart, PinchFreeMesh, RepairSteps, RepairedMesh, Section, Shapes, SplitOptions, TransformStep, VertexMesh } from './mesh_operations.js';
import type { GmshProject, Model, ModelFormat, ModelOperand, ModelOptions, ResultModel, ResultModelOptions } from './models.js';
import type { HalfSpace, MeshOperand, Operand, PreparedOperand } from './operands.js';
import type { JudgedMesh, QualityOptions, QualityReport } from './quality.js';
import type { ModelPredictOptions, ModelRemeshOptions, ModelRemeshResult, PredictOptions, RemeshOptions, RemeshResult } from './remesh.js';
import type { Report } from './report.js';
import type { Sizing, SizingOptions } from './sizing.js';

/** Overrides for where the core comes from; only the call that starts it looks at them. */
export interface LoadOptions {
  /** Compiled code, for example from another worker. */
  wasmModule?: WebAssembly.Module;
  /** The bytes of core.wasm. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Where core.wasm is served, or its file in Node. */
  wasmUrl?: string | URL;
}

/** The functions without promises, once the core is loaded. */
export interface Mortise {
  union(operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  union(first: Operand, ...rest: Operand[]): BooleanResult;
  union(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): BooleanResult;
  intersect(operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  intersect(first: Operand, ...rest: Operand[]): BooleanResult;
  intersect(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): BooleanResult;
  subtract(operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  subtract(first: Operand, ...rest: Operand[]): BooleanResult;
  subtract(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): BooleanResult;
  symmetricDifference(operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  symmetricDifference(first: Operand, ...rest: Operand[]): BooleanResult;
  symmetricDifference(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): BooleanResult;
  partition(operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  partition(first: Operand, ...rest: Operand[]): BooleanResult;
  partition(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): BooleanResult;
  combine(expression: string, operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  keep(tags: readonly FaceTag[], operands: readonly Operand[], options?: BooleanOptions): BooleanResult;
  imprint(operands: readonly MeshOperand[], options?: BooleanOptions): ImprintResult;
  imprint(first: MeshOperand, ...rest: MeshOperand[]): ImprintResult;
  imprint(...operandsAndOptions: [MeshOperand, ...MeshOperand[], BooleanOptions]): ImprintResult;
  implant(operands: readonly MeshOperand[], options?: ImplantOptions): BooleanResult;
  implant(host: MeshOperand, component: MeshOperand, ...rest: MeshOperand[]): BooleanResult;
  implant(...operandsAndOptions: [MeshOperand, MeshOperand, ...MeshOperand[], ImplantOptions]): BooleanResult;
  resolve(mesh: MeshOperand, options?: BooleanOptions): BooleanResult;
  prepare(mesh: MeshInput): PreparedOperand;
  inspect(mesh: MeshInput): Report;
  transform(mesh: MeshInput, steps: readonly TransformStep[]): Mesh;
  roundToFloat32(mesh: MeshInput): Mesh;
  make<Name extends keyof Shapes>(shape: Name, parameters?: Shapes[Name]): Mesh;
  split(mesh: MeshInput, options?: SplitOptions): MeshPart[];
  splitPinches(mesh: MeshInput): PinchFreeMesh;
  repair(mesh: MeshInput, steps: RepairSteps): RepairedMesh;
  extrudeTo(mesh: MeshInput, options: { z: number }): Mesh;
  model<Given extends MeshInput>(mesh: Given, options?: ModelOptions): Model<Given>;
  resultModel(result: Pick<BooleanResult, 'mesh' | 'provenance'> | ImprintedOperand, operands: readonly ModelOperand[], options?: ResultModelOptions): ResultModel;
  readModel(source: string | URL | Uint8Array | ArrayBuffer, options?: ReadOptions & Omit<ModelOptions, 'sources'>): Model;
  writeModel(path: string | URL, model: Model<MeshInput>, options?: { format?: ModelFormat }): void;
  writeModel(model: Model<MeshInput>, options: { format: ModelFormat }): Uint8Array;
  gmshProject(model: Model<MeshInput>, options: { meshFile: string }): GmshProject;
  sizing(options: SizingOptions): Sizing;
  remesh(mesh: MeshInput, options: RemeshOptions & { operands?: undefined }): RemeshResult;
  remesh(result: Pick<BooleanResult, 'mesh' | 'provenance'>, options: RemeshOptions & { operands: readonly (MeshInput | HalfSpace)[] }): RemeshResult;
  remesh(model: ResultModel, options: ModelRemeshOptions): ModelRemeshResult<ResultModel>;
  remesh(model: Model<MeshInput>, options: ModelRemeshOptions): ModelRemeshResult;
  predictTriangles(mesh: MeshInput, options: PredictOptions & { operands?: undefined }): number;
  predictTriangles(result: Pick<BooleanResult, 'mesh' | 'provenance'>, options: PredictOptions & { operands: readonly (MeshInput | HalfSpace)[] }): number;
  predictTriangles(model: Model<MeshInput>, options: ModelPredictOptions): number;
  quality(mesh: JudgedMesh, options: QualityOptions): QualityReport;
  slice(mesh: MeshInput, options: { plane: readonly [number, number, number, number] }): Section;
  cornersToVertices(mesh: MeshInput, options?: { missing?: number }): VertexMesh;
  groupByLabel(mesh: MeshInput): GroupedMesh;
  readMesh(source: string | URL | Uint8Array | ArrayBuffer, options?: ReadOptions): Mesh;
  writeMesh(path: string | URL, mesh: MeshInput, options?: WriteOptions): void;
  writeMesh(mesh: MeshInput, options: { format: Format }): Uint8Array;
}

/** The same functions, synchronous. The core is started once per program. */
export function load(options?: LoadOptions): Promise<Mortise>;
