// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page and its worker say to each other, and what the page keeps.

import type { Format, IntersectionGraph, Mesh, MeshErrorDetails, Provenance, Report, Shapes, TransformStep } from 'mortise';

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

/** A result in doubles, for `write` and `remesh`: it outlives the worker. */
export interface Made {
  mesh: Mesh;
  provenance: Provenance;
  /** Of its intersection graph. */
  curves: Pick<IntersectionGraph, 'points' | 'edges'>;
}

export interface Evaluation extends Made {
  report: Report;
  display: Display;
  /** Two points per edge of the intersection graph, relative to the origin of `display`. */
  graph: Float32Array;
}

/** What triangles the person wants. */
export interface RemeshWish {
  /** Length of edges. */
  size: number;
  /** Along the intersection graph sizes are those of its own edges, spread evenly, and grow by `growth` from there. */
  finer: boolean;
  growth: number;
  featureAngle: number;
  /** Round the intersection graph: only triangles in so many change. 0: all may. */
  layers: number;
}

/** Numbers about the triangles of a mesh, for the sizes wanted. */
export interface TriangleNumbers {
  triangles: number;
  minAngleDeg: number;
  maxAngleDeg: number;
  /** Of 2 r / R. */
  meanRadiusRatio: number;
  /** The part of the edges that is about as long as wanted. */
  inBand: number;
  /** Triangles by their smallest angle, in bins of 2 degrees. */
  angleCounts: number[];
  /** The bin of every triangle, in the order of the display. */
  bins: Uint8Array;
}

export interface Remeshing {
  /** In doubles, for `write`. */
  mesh: Mesh;
  display: Display;
  before: TriangleNumbers;
  after: TriangleNumbers;
  /** Triangles that stay because faces would have come to cross there. */
  kept: number;
  /** Pairs of triangles. */
  newCrossings: number;
}

/** The calls of the worker: what each takes and answers. */
export interface Calls {
  /** The first call of every worker: takes the compiled core if there is one, answers with it. */
  start: [{ wasmModule: WebAssembly.Module | undefined }, WebAssembly.Module];
  load: [{ key: number; source: Source }, LoadedOperand];
  forget: [{ keys: number[] }, null];
  /** `inspect` as in the package: whether self-intersections of the result are counted. */
  evaluate: [{ operation: Operation; operands: PlacedOperand[]; inspect: boolean }, Evaluation];
  /** About how many triangles a whole surface of the sizes wanted has. */
  predict: [{ made: Made; operands: PlacedOperand[]; wish: RemeshWish }, number];
  /** `origin`: of the display. */
  remesh: [{ made: Made; operands: PlacedOperand[]; wish: RemeshWish; origin: Vector }, Remeshing];
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
  edges: boolean;
  graph: boolean;
  ghosts: boolean;
}

/** A result and what it is the result of. */
export interface Result extends Evaluation {
  choice: Choice;
  /** As they were, in the order of the call. */
  operands: PlacedOperand[];
  /** What was asked for, to be compared with what would be asked for now. */
  asked: string;
  /** From asking to showing. */
  milliseconds: number;
}

/** The result with other triangles. */
export interface Remeshed extends Remeshing {
  wish: RemeshWish;
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
