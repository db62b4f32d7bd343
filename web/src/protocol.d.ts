// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page and its worker say to each other, and what the page keeps.

import type { Format, Mesh, MeshErrorDetails, Report, Shapes, TransformStep } from 'mortise';

export type Vector = [number, number, number];

export type Operation = 'union' | 'intersect' | 'subtract';

/** Where an operand comes from: enough for any worker to make it. */
export type Source =
  | { kind: 'shape'; name: string; shape: keyof Shapes; parameters: Record<string, number | Vector> }
  | { kind: 'file'; name: string; file: File };

/** Consecutive triangles of one operand. */
export interface Group {
  operand: number;
  start: number;
  count: number;
}

/** A mesh for the screen: nine floats per triangle, relative to `origin`, which is in doubles. */
export interface Display {
  origin: Vector;
  positions: Float32Array;
  normals: Float32Array;
  groups: Group[];
}

export interface LoadedOperand {
  vertices: number;
  triangles: number;
  /** Lengths of the sides of its box. */
  size: Vector;
  display: Display;
}

export interface PlacedOperand {
  key: number;
  /** For a worker that does not have it: the one that had was stopped. */
  source: Source;
  steps: TransformStep[];
}

export interface Evaluation {
  /** In doubles, for `write`: it outlives the worker. */
  mesh: Mesh;
  report: Report;
  display: Display;
  /** Two points per edge of the intersection graph, relative to the origin of `display`. */
  graph: Float32Array;
}

/** The calls of the worker: what each takes and answers. */
export interface Calls {
  /** The first call of every worker: takes the compiled core if there is one, answers with it. */
  start: [{ wasmModule: WebAssembly.Module | undefined }, WebAssembly.Module];
  load: [{ key: number; source: Source }, LoadedOperand];
  forget: [{ keys: number[] }, null];
  /** `inspect` as in the package: whether self-intersections of the result are counted. */
  evaluate: [{ operation: Operation; operands: PlacedOperand[]; inspect: boolean }, Evaluation];
  write: [{ mesh: Mesh; format: Format }, Uint8Array];
}

export interface Request {
  id: number;
  name: keyof Calls;
  args: Calls[keyof Calls][0];
}

/** A MeshError as plain data. */
export interface PlainError {
  code: string;
  message: string;
  details: MeshErrorDetails;
}

export interface Progress {
  stage: string;
  fraction: number;
}

export type Answer = { id: number } & ({ value: Calls[keyof Calls][1] } | { error: PlainError } | { progress: Progress });

/** A value to send and the buffers to hand over with it. */
export interface Parcel<Value> {
  value: Value;
  transfer: ArrayBuffer[];
}

/** How an operand is moved: about its own origin it is scaled, turned about x, y, z in degrees, then moved. */
export interface Placement {
  move: Vector;
  turn: Vector;
  scale: Vector;
}

/** An operand as the page knows it. */
export interface Operand extends LoadedOperand {
  key: number;
  name: string;
  source: Source;
  placement: Placement;
}

/** One of the buttons. */
export type Choice = 'union' | 'intersect' | 'first' | 'second';

export interface Shown {
  wireframe: boolean;
  graph: boolean;
  ghosts: boolean;
}

/** A result and what it is the result of. */
export interface Result extends Evaluation {
  choice: Choice;
  /** Keys of the operands in the order of the call. */
  keys: number[];
  /** What was asked for, to be compared with what would be asked for now. */
  asked: string;
  /** From asking to showing. */
  milliseconds: number;
}

/** What takes time. */
export interface Work {
  title: string;
  /** 0 to 1; undefined where nobody knows. */
  fraction: number | undefined;
  /** When it began, by performance.now(). */
  since: number;
}

/** An error, and what it is about. */
export interface Trouble extends PlainError {
  /** "B (open.stl)", or a file that was not read. */
  about: string;
}

export type GizmoMode = 'translate' | 'rotate' | 'scale';
