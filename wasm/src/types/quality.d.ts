// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are for the sizes wanted.

import type { BooleanResult } from './booleans.js';
import type { MeshInput } from './mesh.js';
import type { Model } from './models.js';
import type { HalfSpace } from './operands.js';
import type { RemeshResult, RemeshSizes } from './remesh.js';

/** Of a set of triangles; zeros when it is empty. Angles are in degrees. */
export interface TriangleMarks {
  count: number;
  minAngleDeg: number;
  maxAngleDeg: number;
  /** 0.1 %, 1 % and half of the triangles have a smaller smallest angle. */
  permilleAngleDeg: number;
  percentAngleDeg: number;
  medianAngleDeg: number;
  /** Triangles with an angle below 30, above 115 degrees. */
  below30: number;
  above115: number;
  /** 2 r / R of the circles in and round a triangle: 1 for an equilateral one. */
  minRadiusRatio: number;
  meanRadiusRatio: number;
  /** Longest to shortest edge; Infinity for one of length 0. */
  maxEdgeRatio: number;
  meanEdgeRatio: number;
  /** From the edge of an equilateral triangle of the same area to that of a neighbour. */
  maxGrowth: number;
}

/** Of a set of edges, in units of the size wanted along them. */
export interface LengthMarks {
  count: number;
  min: number;
  max: number;
  mean: number;
  /** The part of them in 1 / sqrt 2 .. sqrt 2. */
  inBand: number;
  /** From one to the next along a model edge. */
  maxGrowth: number;
  /** Counts up to 0.5, 1 / sqrt 2, 0.8, 0.9, 1.1, 1.25, sqrt 2, 2 and beyond. */
  bins: number[];
}

/** From points of one to the closest points of the other. Infinity where there is no other. */
export interface OneWayDistance {
  max: number;
  /** The greatest in units of the size wanted at the point. */
  inSizes: number;
  /** Where that is. */
  at: [number, number, number];
}

export interface Deviation {
  /** Surfaces, at vertices, middles of edges and centroids of triangles. */
  toReference: OneWayDistance;
  fromReference: OneWayDistance;
  /** Model edges, at vertices; those of the reference half-way between them too. */
  curvesToReference: OneWayDistance;
  curvesFromReference: OneWayDistance;
  /** In sizes, per face of the model of the reference, when a remeshed result is judged: faces are compared with those of their number then. */
  byFace: { to: number; from: number }[] | null;
}

export interface QualityReport {
  all: TriangleMarks;
  /** Of triangles no vertex of which is within the size wanted there of an obstacle. */
  free: TriangleMarks;
  edges: LengthMarks;
  /** Edges of free triangles. */
  freeEdges: LengthMarks;
  /** What no mesh of the size has good triangles at: model edges below 0.7 of it, corners of faces below 60 degrees, places on model edges closer
   *  than the size to another part of those of a face. */
  obstacles: { shortEdges: number; sharpCorners: number; closeFeatures: number };
  /** Vertices inside faces by the number of their edges, 0 to 11, and 12 or more. */
  valences: number[];
  /** Edges inside faces where the surface folds back by more than 90 degrees. */
  folds: number;
  /** null without a reference. */
  deviation: Deviation | null;
  /** All of it to read. */
  table: string;
}

export type QualityOptions = RemeshSizes & {
  /** As for remesh: they make the model, unless that of a remeshed result is known. Defaults 40 and 45. */
  featureAngle?: number;
  curveAngle?: number;
} & ({ reference?: MeshInput | Model<MeshInput>; operands?: undefined } | { reference: Pick<BooleanResult, 'mesh' | 'provenance'>; operands: readonly (MeshInput | HalfSpace)[] });

/** A mesh, or what `remesh` answered. */
export type JudgedMesh = MeshInput | (Pick<RemeshResult, 'mesh' | 'modelFaces' | 'modelEdges'> & Partial<Pick<RemeshResult, 'refinement'>>);

/**
 * How good the triangles of a mesh are for the sizes wanted: of any mesh, or of what `remesh` answered, which knows its model and where its sizes had to be smaller. With a `reference`,
 * say the mesh or the model that was remeshed (and its `operands`, as for remesh, when it is a result), how far the two are apart.
 */
export function quality(mesh: JudgedMesh, options: QualityOptions): Promise<QualityReport>;
