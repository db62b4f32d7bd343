// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How long edges of elements are to be where: sources of sizes.

/// <reference lib="esnext.disposable" />

import type { IntersectionGraph } from './booleans.js';
import type { Box, MeshInput } from './mesh.js';
import type { Model, ModelEntity } from './models.js';

export type Point = readonly [number, number, number];

/** What all sources have. */
export interface SourceOptions {
  /** From one element to the next away from the source sizes grow by this factor: in distance D the size is S + D (growth - 1). Default: that of the call. */
  growth?: number;
  /** Distances count from this far on: a ball round a point, a capsule round a segment. Default 0. */
  radius?: number;
}

export interface PointSource extends SourceOptions {
  type: 'point';
  at: Point;
  size: number;
}

/** Sizes are one, or at both ends, or at both ends and in the middle (then quadratic between them). */
export interface SegmentSource extends SourceOptions {
  type: 'segment';
  from: Point;
  to: Point;
  size: number | readonly [number, number] | readonly [number, number, number];
}

/** Sizes are one, or at the three corners, or at these and in the middles of the edges from corner 0 to 1, 1 to 2, 2 to 0. */
export interface TriangleSource extends SourceOptions {
  type: 'triangle';
  corners: readonly [Point, Point, Point];
  size: number | readonly number[];
}

/** All edges of the graph of a result. Without a size every chain has its own: its length by the number of its edges. */
export interface GraphSource extends SourceOptions {
  graph: Pick<IntersectionGraph, 'points' | 'edges'>;
  size?: number;
}

/** The same, as a kind of source. */
export interface SegmentsSource extends SourceOptions {
  type: 'segments';
  from: Pick<IntersectionGraph, 'points' | 'edges'>;
  size?: number;
}

/** Sources on a model: default that of the call. */
export interface ModelSource extends SourceOptions {
  model?: Model<MeshInput>;
}

/** One size on a vertex, an edge, a face, or all faces of a region. */
export interface EntitySizeSource extends ModelSource {
  entity: ModelEntity;
  size: number;
}

/** At least so many elements along every model edge, none smaller than `smallest` (default 0) for that. */
export interface EdgeCountSource extends ModelSource {
  edgeCount: number;
  smallest?: number;
}

/**
 * Elements that follow curved faces and edges: off by no more than `chordError`, or `perTurn` of them round a full circle, or both; none
 * smaller than `smallest` (default 0). For the result of an operation take the models of its operands: they have the same surfaces, whole.
 */
export interface CurvatureSource extends ModelSource {
  curvature: { chordError?: number; perTurn?: number; smallest?: number };
}

/** The attributes of kind 'size', whose values are sizes, on their targets. */
export interface AttributeSource extends ModelSource {
  attributes: true;
}

/** A size for each vertex of a mesh (default: that of the call), or a function that gives it; linear on triangles. */
export interface VertexSizeSource extends SourceOptions {
  mesh?: MeshInput;
  sizes: ArrayLike<number> | ((x: number, y: number, z: number) => number);
}

export type SizeSource =
  | PointSource
  | SegmentSource
  | TriangleSource
  | GraphSource
  | SegmentsSource
  | EntitySizeSource
  | EdgeCountSource
  | CurvatureSource
  | AttributeSource
  | VertexSizeSource;

export interface SizingOptions {
  /** Where no source asks for less. */
  size: number;
  /** No size is below it, whatever sources ask for. Default 0. */
  smallest?: number;
  /** Of sources that say nothing else. Default 1.2. */
  growth?: number;
  sources?: readonly SizeSource[];
  /** What sources are about that name no other, and what `toGmshView` covers. */
  model?: Model<MeshInput>;
  mesh?: MeshInput;
}

/** The edge length wanted at any point: the least that any source asks for. It stays in the core until it is disposed of or collected. */
export interface Sizing {
  /** At one point. */
  sizeAt(point: Point): number;
  /** At points, three coordinates each. */
  sizeAt(points: Float64Array | Float32Array): Float64Array;
  /**
   * The text of a file for Gmsh, NAME.pos: tetrahedra that fill a box (default: the one round the mesh or model) with sizes within a few
   * per cent. `Merge "NAME.pos"; Background Mesh View[0];` meshes by it.
   */
  toGmshView(box?: Box): string;
  /** Frees its memory in the core. A second time nothing happens. */
  dispose(): void;
  [Symbol.dispose](): void;
}

export function sizing(options: SizingOptions): Promise<Sizing>;
