// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers about a mesh and the call that made it.

import type { Box, MeshInput } from './mesh.js';

/** What is known about one operand of a call. */
export interface OperandReport {
  /** Set by the command: the file's name. */
  name?: string;
  vertices: number;
  triangles: number;
  /** True when it crosses itself where that mattered, and the crossings were resolved. */
  selfContacts: boolean;
  /** A sheet bounds no volume: an odd number of its triangles meets at its open edges, or all its triangles are walls. */
  kind: 'solid' | 'sheet' | 'halfSpace';
  /** Of a sheet: its open edges, two vertices of the operand each. */
  openEdges?: Uint32Array;
}

export interface StageReport {
  stage: string;
  milliseconds: number;
}

export interface RegionReport {
  /** 1, 2, ...: what `provenance.regionLeft` says; 0 is the space outside. */
  id: number;
  /** Operands that contain the region next to its boundary, ascending. */
  operands: number[];
  volume: number;
  /** Of its whole boundary, cavities included. */
  area: number;
}

/**
 * Exact places of the corners of failed triangles, by points of the operands: vertex i has points begin[i] .. begin[i + 1]. One
 * point is the place itself; of four, the line through the first two meets the line through the others there; of five, that line
 * meets the plane through the others; of nine, three planes meet.
 */
export interface ExactPlaces {
  /** Of the result, ascending. */
  vertices: Uint32Array;
  begin: Uint32Array;
  /** x, y, z of each. */
  points: Float64Array;
}

/** What was tested of the doubles of a result, and what it took to make them free of crossings. Lengths in units of the mesh. */
export interface Certificate {
  level: 'relative' | 'absolute';
  /** With a vertex that was rounded; all of them for 'absolute'. */
  trianglesTested: number;
  pairsTested: number;
  /** Pairs that cross because their sources did so in one operand; none of them is counted against 'relative'. */
  inheritedPairs: number;
  /** Triangles of the result not proven, ascending; empty when certified. */
  failedTriangles: Uint32Array;
  exactPlaces: ExactPlaces;
  /** The farthest any point of the result may lie from its exact place. */
  largestDisplacement: number;
  /** The part of it that repair added; 0: every vertex the cut made is at its nearest doubles. */
  repairDisplacement: number;
  /** Rounds of repair: vertices merged; slivers swapped; operands as cut arranged again, some vertices moved to a grid. */
  mergeRounds: number;
  swapRounds: number;
  snapRounds: number;
  /** Vertices of operands that are in the result, but had to move. */
  movedInputVertices: { operand: number; vertex: number }[];
}

/** What it took to let operands share what lay within the tolerance. Lengths in units of the mesh. */
export interface ToleranceReport {
  /** Vertices of operands that went to the place of another one. */
  movedVertices: number;
  /** Vertices added where edges passed one another. */
  madeVertices: number;
  /** The farthest a vertex moved; at most the tolerance. */
  largestMove: number;
  /** Triangles of operands whose corners became two or one. */
  collapsed: { operand: number; face: number }[];
  /** Triangles of operands that could not share all that is near, or that sharing let cross others of their operand. */
  unresolved: { operand: number; face: number }[];
}

/** Numbers about a mesh and the call that made it; the JSON report of the command has the same fields. */
export interface Report {
  vertices: number;
  triangles: number;
  /** Every edge is balanced: as many triangles run along it one way as the other; of a partition, round every region. */
  closed: boolean;
  /** No two triangles run the same way along an edge they alone share. */
  oriented: boolean;
  /** Every edge has at most two triangles and every vertex one fan of them. */
  manifold: boolean;
  boundaryEdges: number;
  nonManifoldEdges: number;
  components: number;
  /** Handles, summed over shells; null when the mesh is not closed. */
  genus: number | null;
  /** Signed: negative when inside out; null when the mesh is not closed; of a partition, the sum over its regions. */
  volume: number | null;
  area: number;
  /** Null when the mesh has no triangles. */
  bbox: Box | null;
  /** In degrees; null when the mesh has no triangles. */
  minAngleDeg: number | null;
  maxAngleDeg: number | null;
  /** Pairs of triangles that meet elsewhere than in what they share, found exactly; null when not looked for (`inspect: false`). */
  selfIntersections: number | null;
  /**
   * Of a boolean: the doubles of the result are proven to add no crossing to what the operands had (see `certify`).
   * Of `inspect`: there is no crossing and no triangle without area.
   */
  certified: boolean;
  /** Of a boolean: what `certified` stands on. Null for `inspect`. */
  certificate: Certificate | null;
  /** Null but for a boolean with a `tolerance`. */
  tolerance: ToleranceReport | null;
  operands: OperandReport[];
  stages: StageReport[];
  milliseconds: number;
  /** The connected solids of a boolean's result; bodies that touch in an edge or a corner are two. Empty for `inspect`. */
  regions: RegionReport[];
  /** Where boundaries of different operands meet. */
  graph: { vertices: number; edges: number; closedLoops: number; openChains: number };
  /** What operands share without sharing volume. */
  contact: { points: number; length: number; area: number };
  notes: string[];
}

/** Numbers about one mesh. */
export function inspect(mesh: MeshInput): Promise<Report>;
