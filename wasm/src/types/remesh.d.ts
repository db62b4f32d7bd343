// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes of the sizes wanted on the same model.

import type { BooleanResult } from './booleans.js';
import type { Mesh, MeshInput } from './mesh.js';
import type { Model, ResultModel } from './models.js';
import type { HalfSpace } from './operands.js';
import type { SizeSource, Sizing } from './sizing.js';

/** How long edges are to be where: said here, or by a sizing. */
export type RemeshSizes =
  | {
      /** The size where no source asks for less. */
      size: number;
      /** Nothing below this, whatever sources ask for. Default 0. */
      smallest?: number;
      /** Of sources that say nothing else. Default 1.2. */
      growth?: number;
      /** Those with `sizes` and no mesh are about the mesh given; where a model is given, those about a model that name none are about that. */
      sources?: readonly SizeSource[];
      sizing?: undefined;
    }
  | { sizing: Sizing; size?: undefined; smallest?: undefined; growth?: undefined; sources?: undefined };

/** How the model of a mesh is made, and what is to become of its small features. */
export interface ModelledOptions {
  /** Triangles at a larger angle, in degrees, are of different model faces; so are those of different labels. Default 40. */
  featureAngle?: number;
  /** A model edge that turns by more at a vertex, in degrees, keeps that vertex. Default 45. */
  curveAngle?: number;
  /**
   * `refine`: model edges below 0.7 of the size get triangles of their length, and where two parts of the edges of a model face have less than that of it
   * between them, triangles of that width; sizes grow from there by `growth` (1.2 with a `sizing`). `merge`: what is nearer to each other than `minFeature`
   * becomes one first: short edges, narrow strips, thin walls and gaps go; what is left is refined. `keep`: they stay as they are, and spoil the triangles
   * at them. Default `refine`.
   */
  features?: 'keep' | 'merge' | 'refine';
  /** Features below this length go with `merge`, and stay as they are with `refine`. Default 1e-6 of the diagonal of the box round the mesh. */
  minFeature?: number;
}

export type PredictOptions = RemeshSizes & ModelledOptions;

export type RemeshOptions = PredictOptions & {
  /** Per triangle of the mesh given: 1 when it may change. All others stay as they are, byte for byte. Default: all may. */
  zone?: ArrayLike<number>;
  /** Of a result, or of its model: only triangles in so many layers round the intersection graph may change. */
  layers?: number;
  /**
   * No point of the new surface is farther from the old one than this, nor the other way round, model face by model face: proven, not sampled. Triangles
   * become smaller where it takes that; where that does not help, triangles of the mesh given stay (`kept`). Default: no bound.
   */
  maxDeviation?: number;
  /** Sizes that ask for more triangles are refused, RESULT_TOO_LARGE. Default 20 million. */
  mostTriangles?: number;
  /** `paper`: edges are collapsed below the size and split above twice the size, in three rounds; they come out 1.4 sizes long. */
  preset?: 'default' | 'paper';
  /**
   * `frontal`: model faces in planes, all of whose triangles may change, get new triangles between their edges from a front that runs inwards; edges as
   * long as the size, whatever the preset. All others are remeshed by local changes. Default `local`.
   */
  mesher?: 'local' | 'frontal';
  /** Rounds of splits, collapses, swaps and moves, each for the size taken so many times: 1 to 64. Default [8, 8, 4, 4, 2, 2, 1]. */
  rounds?: readonly number[];
  /** On the worst triangles, up to 1000. Default 10. */
  lastRounds?: number;
  /** How often it may begin anew when faces came to cross, up to 1000; 0: nobody looks. Default 6. */
  audits?: number;
  /** Called now and then with the fraction of the whole call done. Return false to cancel. */
  onProgress?: (progress: { stage: string; fraction: number }) => boolean | void;
  /** Looked at before the call and whenever progress is reported. */
  signal?: AbortSignal;
};

/** A model says itself what its faces and edges are. */
interface KnownModel {
  featureAngle?: undefined;
  curveAngle?: undefined;
  operands?: undefined;
}

export type ModelPredictOptions = PredictOptions & KnownModel;
export type ModelRemeshOptions = RemeshOptions & KnownModel;

/** Numbers about the triangles of a mesh. */
export interface TriangleShapes {
  triangles: number;
  area: number;
  /** In degrees; null when the mesh has no triangles. */
  minAngleDeg: number | null;
  maxAngleDeg: number | null;
}

/** What `features: 'merge'` did before. */
export interface MergedFeatures {
  /** Triangles of the mesh given of which nothing is left, ascending. */
  gone: Uint32Array;
  /** Triangles of the mesh given that cross others now, or lie on them, or on which not all fitted that is near; ascending. */
  unresolved: Uint32Array;
  /** Vertices that went to the place of another one, and how far at most. */
  movedVertices: number;
  largestMove: number;
}

export interface RemeshResult {
  /** Labels and walls are those of the triangles it lies on. Vertex and corner data are not carried: it has none. */
  mesh: Mesh;
  /** Per triangle: the triangle of the mesh given that its middle is closest to. */
  sources: Uint32Array;
  /** Per triangle: its model face, numbered by the lowest triangles of the mesh given. */
  modelFaces: Uint32Array;
  /** Two vertices for each mesh edge that lies on a model edge. */
  modelEdges: Uint32Array;
  /** Segments, and points, where sizes had to be smaller for small features or `maxDeviation`, nine numbers each: from, to, size, growth, radius. `quality`
   *  judges by them too. */
  refinement: Float64Array;
  /** Triangles of the mesh given that stay because faces would have come to cross there, or to be too far away. */
  kept: Uint32Array;
  /** Pairs of triangles that cross where none did before, left after the last audit. */
  newCrossings: number;
  /** How many triangles the sizes ask for, to a few per cent; those of small features are among them, and where they are up to a quarter more come out. */
  predicted: number;
  before: TriangleShapes;
  after: TriangleShapes;
  /** With `features: 'merge'`; then `before` is about the mesh without them. A model is one of a result then: its entities have other numbers, its
   *  attributes are there. */
  merged?: MergedFeatures;
}

/** What became of a model. */
export interface ModelRemeshResult<Kind extends Model = Model> extends RemeshResult {
  /**
   * The same model on the new mesh: its entities have the numbers they had, its attributes are those it had. Of the model of a result also its
   * `interfaces` and where its entities come from, measured before.
   */
  model: Kind;
}

/**
 * The same model with triangles of the sizes wanted. Vertices of the model (corners) stay as they are, vertices on its edges stay on
 * these, all others on its faces: places on the triangles given. Open meshes, walls and edges with many triangles are welcome;
 * vertices at one place are one. Vertex and corner data are not carried.
 */
export function remesh(mesh: MeshInput, options: RemeshOptions & { operands?: undefined }): Promise<RemeshResult>;
/** Of what an operation answered: `operands` are the meshes of the call, moved as they were there, and creases are those of their triangles. */
export function remesh(result: Pick<BooleanResult, 'mesh' | 'provenance'>, options: RemeshOptions & { operands: readonly (MeshInput | HalfSpace)[] }): Promise<RemeshResult>;
/** Of a model: its faces, edges, seams and vertices as they are, whatever they were made by, with their attributes. Vertices at one place stay as many. */
export function remesh(model: ResultModel, options: ModelRemeshOptions): Promise<ModelRemeshResult<ResultModel>>;
export function remesh(model: Model<MeshInput>, options: ModelRemeshOptions): Promise<ModelRemeshResult>;

/** How many triangles the sizes, and those of small features, ask for: what `remesh` says is `predicted`. */
export function predictTriangles(mesh: MeshInput, options: PredictOptions & { operands?: undefined }): Promise<number>;
export function predictTriangles(result: Pick<BooleanResult, 'mesh' | 'provenance'>, options: PredictOptions & { operands: readonly (MeshInput | HalfSpace)[] }): Promise<number>;
export function predictTriangles(model: Model<MeshInput>, options: ModelPredictOptions): Promise<number>;
