// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models: entities and what bounds what.

import type { Provenance } from './booleans.js';
import type { MeshInput } from './mesh.js';

/** What parts faces and edges of a model. Angles in degrees. */
export interface ModelOptions {
  /** Triangles at a larger angle are of different faces. Default 40. */
  faceAngle?: number;
  /** Edges above this smaller angle part faces too where they continue one. Default: there are none. */
  weakAngle?: number;
  /** A model edge that turns by more at a mesh vertex has a model vertex there. Default 45. */
  edgeAngle?: number;
  /** Creases that end inside a face after fewer mesh edges do not count. Default 0. */
  leastDangling?: number;
  /** Do triangles of different labels lie on different faces? Default true. */
  splitAtLabels?: boolean;
  /** Pairs of mesh vertices: these mesh edges part faces whatever their angle. */
  userEdges?: readonly (readonly [number, number])[] | ArrayLike<number>;
  /** Edges that open faces: where a face without handles lies between two loops, as the side of a cylinder (default), or in all. */
  seams?: 'none' | 'annulus' | 'disc';
  /** Of the result of an operation: angles are those between the triangles it was made from, and there are none inside these. */
  sources?: { provenance: Provenance; operands: readonly MeshInput[] };
}

export interface ModelCounts {
  triangles: number;
  modelFaces: number;
  modelEdges: number;
  modelVertices: number;
  /** Enclosed pieces of space that are not voids. */
  regions: number;
  /** Enclosed by faces that all have their fronts to them and are no walls: cavities. */
  voids: number;
  meshEdgesOnModelEdges: number;
}

/** A model edge or face as a neighbour; reversed: it is used from its end to its start. */
export interface ModelEdgeUse {
  edge: number;
  reversed: boolean;
}
export interface ModelFaceUse {
  face: number;
  reversed: boolean;
}

/** Rows of one table that belong to row i of another run from xBegin[i] up to xBegin[i + 1]. */
export interface ModelTables {
  edgeStart: Uint32Array;
  edgeEnd: Uint32Array;
  edgeIsSeam: Uint32Array;
  edgeLength: Float64Array;
  faceGenus: Uint32Array;
  faceBehind: Uint32Array;
  faceInFront: Uint32Array;
  faceArea: Float64Array;
  regionVolume: Float64Array;
  regionIsVoid: Uint8Array;
  loopStart: Uint32Array;
  loopsOfFaceBegin: Uint32Array;
  usesOfLoopBegin: Uint32Array;
  useEdge: Uint32Array;
  useIsReversed: Uint32Array;
  shellRegion: Uint32Array;
  sidesOfShellBegin: Uint32Array;
  sideFace: Uint32Array;
  sideIsFront: Uint32Array;
  shellsOfRegionBegin: Uint32Array;
  shellsOfRegion: Uint32Array;
  edgesOfVertexBegin: Uint32Array;
  edgesOfVertex: Uint32Array;
  facesOfEdgeBegin: Uint32Array;
  faceOfEdge: Uint32Array;
  faceOfEdgeIsReversed: Uint32Array;
  meshVertex: Uint32Array;
  pathBegin: Uint32Array;
  path: Uint32Array;
  triangleFace: Uint32Array;
  vertexDimension: Uint32Array;
  vertexEntity: Uint32Array;
}

/**
 * The regions, faces, edges and vertices of a mesh: what bounds what, and what every part of the mesh lies on. Entities are numbered
 * from 0; region 0 is the space outside. Numbers that are not there are a MeshError, INVALID_ARGUMENT.
 */
export interface Model {
  readonly counts: ModelCounts;
  /** Per triangle: its face. */
  readonly triangleFace: Uint32Array;
  /** All of it in plain arrays. */
  readonly tables: ModelTables;
  /** A closed edge is listed twice. */
  vertex(i: number): { meshVertex: number; edges: number[] };
  /** `path`: mesh vertices from start to end. `faces`: each as often as its loops use the edge. */
  edge(i: number): { start: number; end: number; seam: boolean; length: number; faces: ModelFaceUse[]; path: Uint32Array };
  /** Loops run with the face on their left; one without edges is a vertex that the face touches. `genus`: handles. */
  face(i: number): { genus: number; area: number; regionBehind: number; regionInFront: number; loops: { start: number; edges: ModelEdgeUse[] }[] };
  /** Connected sets of sides of faces: the outer one, cavities, sheets. The volume of region 0 is Infinity. */
  region(i: number): { volume: number; void: boolean; shells: { face: number; front: boolean }[][] };
  /** Ascending. */
  trianglesOf(face: number): Uint32Array;
  /** What a mesh vertex lies on; 'none': no triangle uses it. */
  entityOf(meshVertex: number): { dimension: 'vertex' | 'edge' | 'face' | 'none'; id: number };
}

/**
 * The model of any mesh: open or closed, with any number of triangles at an edge and of regions. For the result of an operation give
 * it `sources`: then creases are those of the operands.
 */
export function model(mesh: MeshInput, options?: ModelOptions): Promise<Model>;
