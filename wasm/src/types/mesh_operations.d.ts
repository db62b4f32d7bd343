// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operations on one mesh.

import type { Mesh, MeshInput } from './mesh.js';

/** Exactly one of the properties. */
type One<All> = { [Name in keyof All]: { [Given in Name]: All[Given] } & { [Other in Exclude<keyof All, Name>]?: never } }[keyof All];

/** One step of `transform`. Angles are degrees, rotations are about the origin. */
export type TransformStep = One<{
  scale: number | readonly [number, number, number];
  rotateX: number;
  rotateY: number;
  rotateZ: number;
  translate: readonly [number, number, number];
  /** Column after column, as three.js has it; the last row is 0 0 0 1. */
  matrix: readonly number[] | Float64Array | Float32Array;
  mirror: 'x' | 'y' | 'z';
}>;

/** The shapes of `make` and their parameters. Lengths are in the unit of the coordinates; outlines may be concave. */
export interface Shapes {
  /** Between two corners; default from (0, 0, 0) to (1, 1, 1). */
  box: { lo?: readonly [number, number, number]; hi?: readonly [number, number, number] };
  /** About the origin, with poles; default 1, 64, 32. */
  sphere: { radius?: number; around?: number; rings?: number };
  /** About the origin, an icosahedron cut in four `levels` times; default 1, 4. */
  icosphere: { radius?: number; levels?: number };
  /** Standing on z = 0; default 1, 1, 64. */
  cylinder: { radius?: number; height?: number; around?: number };
  /** Standing on z = 0; default 1, 1, 64. */
  cone: { radius?: number; height?: number; around?: number };
  /** About the z axis; default 1, 0.25, 64, 32. */
  torus: { majorRadius?: number; minorRadius?: number; around?: number; across?: number };
  /** An open rectangle in z = 0; default 1, 1, 8, 8. */
  gridSheet: { width?: number; depth?: number; cellsX?: number; cellsY?: number };
  /** The prism over a polygon in z = 0; default height 1. */
  extrude: { outline: readonly (readonly [number, number])[]; height?: number };
  /** What a polygon of (radius, z) sweeps about the z axis; default around 64. */
  revolve: { profile: readonly (readonly [number, number])[]; around?: number };
}

/** A part of a mesh; pass it on as a mesh. */
export interface MeshPart extends Mesh {
  /** Per triangle: which triangle of the mesh. */
  sourceFace: Uint32Array;
  /** Per vertex: which vertex of the mesh, the lowest at its position. */
  sourceVertex: Uint32Array;
}

/** A mesh whose data all are `vertexData`. */
export interface VertexMesh extends Mesh {
  /** Per vertex: the vertex it is a copy of. */
  sourceVertex: Uint32Array;
}

/** A mesh whose triangles are in runs of one label. */
export interface GroupedMesh extends MeshPart {
  /** As three.js has them: `start` and `count` in numbers of `triangles`, `materialIndex` an index into `labelNames`. */
  groups: { start: number; count: number; materialIndex: number }[];
}

export interface SplitOptions {
  /**
   * 'components' (the default): triangles connected through edges; what meets in a vertex only comes apart.
   * 'regions': the solids of a closed mesh, each with its cavities; solids that touch in an edge or a vertex are two. Of a mesh with
   * walls (a partition) its regions: a triangle between two is in both, each time with the region behind it.
   */
  by?: 'components' | 'regions';
}

/** A mesh whose edges have at most two triangles and whose vertices have one fan of them. */
export interface PinchFreeMesh extends Mesh {
  /** Per vertex: the vertex it is a copy of. */
  sourceVertex: Uint32Array;
  /** Per triangle: number of its shell. */
  shell: Uint32Array;
}

/** What `repair` does, in this order; nothing unless asked. */
export interface RepairSteps {
  /** Triangles without area; what was closed stays closed. */
  dropDegenerate?: boolean;
  /** Triangles that run round the same vertices the same way as an earlier one. */
  dropDuplicates?: boolean;
  /** Pairs of triangles that run round the same vertices opposite ways. */
  cancelOpposites?: boolean;
  /** Triangles that run against most of their surface. */
  orient?: boolean;
  /** Closed shells that are inside out, with all that lies in them; cavities stay. */
  flipInsideOut?: boolean;
  /** Simple holes whose corners lie in one plane exactly. */
  fillPlanarHoles?: boolean;
}

export interface RepairNote {
  step: keyof RepairSteps;
  /**
   * What was not 'done' stays as it was: one-sided surfaces ('notOrientable'); holes in no plane ('notPlanar'), that meet
   * themselves or lie in one another ('notSimple'), or whose filling would lie on their neighbours ('wouldOverlap').
   */
  outcome: 'done' | 'notOrientable' | 'notPlanar' | 'notSimple' | 'wouldOverlap';
  /** Triangles; one-sided surfaces; holes. */
  count: number;
  /** Triangles of the mesh as given: those changed or left, or those round the holes. */
  faces: Uint32Array;
}

export interface RepairedMesh {
  mesh: Mesh;
  /** What was done and what could not be; a step that found nothing to do is not in it. */
  done: RepairNote[];
  /** Per triangle: the one it is or is a part of; 0xffffffff for a filling. */
  sourceFace: Uint32Array;
  /** Per vertex: which vertex of the mesh, the lowest at its position. */
  sourceVertex: Uint32Array;
}

/** Where a plane cuts a mesh. */
export interface Section {
  /** Closed polygons of three coordinates per point, the first not repeated; seen against the normal, the inside is on their left. */
  polygons: Float64Array[];
  /** Per polygon, negative for holes. */
  areas: Float64Array;
  area: number;
}

/** The mesh moved by all steps in order, as one map. A mirrored mesh keeps its outside outside. */
export function transform(mesh: MeshInput, steps: readonly TransformStep[]): Promise<Mesh>;

/** The mesh as a float32 format (binary STL, a GPU) can hold it: rounded, welded, without the triangles that fell together. */
export function roundToFloat32(mesh: MeshInput): Promise<Mesh>;

/** A generated shape; all but gridSheet are closed. */
export function make<Name extends keyof Shapes>(shape: Name, parameters?: Shapes[Name]): Promise<Mesh>;

/** The parts of a mesh, in the order of their first triangles. */
export function split(mesh: MeshInput, options?: SplitOptions): Promise<MeshPart[]>;

/** The mesh with vertices copied where bodies touch in an edge or a vertex: manifold shells, for programs that need them. */
export function splitPinches(mesh: MeshInput): Promise<PinchFreeMesh>;

/** The mesh after the steps asked for, and what they did. */
export function repair(mesh: MeshInput, steps: RepairSteps): Promise<RepairedMesh>;

/** The solid between a sheet that is a heightfield and the plane at height z below or above it. */
export function extrudeTo(mesh: MeshInput, options: { z: number }): Promise<Mesh>;

/**
 * The polygons in which the plane [nx, ny, nz, d] of the points p with n . p = d cuts a closed mesh. A side that lies in the
 * plane counts when the inside is behind it.
 */
export function slice(mesh: MeshInput, options: { plane: readonly [number, number, number, number] }): Promise<Section>;

/**
 * The mesh with corner data as vertex data, for buffers of a graphics card: vertices are copied where values differ. `missing` (default 0) is
 * put where there is no value; a normal that is missing becomes that of its triangle.
 */
export function cornersToVertices(mesh: MeshInput, options?: { missing?: number }): Promise<VertexMesh>;

/** The triangles of each label in one run, for a renderer with a material for each. */
export function groupByLabel(mesh: MeshInput): Promise<GroupedMesh>;
