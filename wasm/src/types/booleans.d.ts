// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operations on several meshes, and what they answer.

import type { Mesh } from './mesh.js';
import type { MeshOperand, Operand } from './operands.js';
import type { Report } from './report.js';

/** Where boundaries of different operands meet. */
export interface IntersectionGraph {
  /** Three coordinates per graph vertex. */
  points: Float64Array;
  /** Two indices of graph vertices per edge. */
  edges: Uint32Array;
  /** Polylines of graph vertices, closed loops first; a closed loop repeats its first vertex. */
  chains: Uint32Array[];
  closedLoops: number;
  openChains: number;
}

/** Where every triangle and vertex of a result comes from. */
export interface Provenance {
  /** Per triangle: which operand; the first where several coincide. */
  sourceOperand: Uint32Array;
  /** Per triangle: which triangle of that operand. */
  sourceFace: Uint32Array;
  /** Per triangle: 1 when it runs against its source. */
  flipped: Uint8Array;
  /** Per triangle: id of the region behind it; 0 in an open result. */
  regionLeft: Uint32Array;
  /** Per triangle: id of the region in front of it; 0 but for a partition, an implant or an imprint. */
  regionRight: Uint32Array;
  /** Per triangle: how it lies to the operands other than its own, an index into `categoryNames`. */
  category: Uint8Array;
  /** 'outside' all of them, 'inside' one at least, coinciding with a face of another: 'onSame' or 'onOpposite' way round. */
  categoryNames: ['outside', 'inside', 'onSame', 'onOpposite'];
  /** Per triangle: which operands contain the space just behind it, an index into `coveringSets`. */
  covering: Uint32Array;
  coveringSets: Uint32Array[];
  /** Of a partition, an implant or an imprint, per triangle: which operands contain the space just in front of it. */
  coveringFront?: Uint32Array;
  /** Triangle i coincides also with the sources from otherSourceBegin[i] up to otherSourceBegin[i + 1] of the next two arrays. */
  otherSourceBegin: Uint32Array;
  otherSourceOperand: Uint32Array;
  otherSourceFace: Uint32Array;
  /** Of these further sources: 1 when the triangle runs against it. */
  otherSourceFlipped: Uint8Array;
  /** Per vertex: operand of the vertex it is, or 0xffffffff for a vertex the cut made. */
  vertexOperand: Uint32Array;
  /** Per vertex: vertex of that operand, or 0xffffffff for a vertex the cut made. */
  vertexSource: Uint32Array;
}

/**
 * A tag of the paper: faces of the first operand outside (10) and inside (11) others, faces of any other operand outside (20) and inside
 * (21) others, faces that coincide with one of another operand and run the same way, or all opposite.
 */
export type FaceTag = '10' | '11' | '20' | '21' | 'same' | 'opposite';

export interface BooleanResult {
  mesh: Mesh;
  report: Report;
  graph: IntersectionGraph;
  provenance: Provenance;
}

export interface BooleanOptions {
  /** Called now and then with the fraction of the whole call done. Return false to cancel. */
  onProgress?: (progress: { stage: string; fraction: number }) => boolean | void;
  /** Looked at before the call and whenever progress is reported. */
  signal?: AbortSignal;
  /**
   * Default true: the result is searched for self-intersections and triangles without area, which may take as long as the boolean itself.
   * With false `report.selfIntersections` is null and `report.notes` do not speak of them; all else is the same, `certified` too.
   */
  inspect?: boolean;
  /** 'solid': an operand with a border is an error that names its open edges (`NOT_CLOSED`), not a sheet. */
  kind?: 'solid';
  /**
   * What of the cut is taken out of the result again, exactly and before any vertex is rounded. 'cut': edges and vertices it made inside
   * one triangle or on one edge of an operand. 'coplanar': also edges between triangles of one plane and label, of any operand, and
   * vertices only these need: two boxes that share a face become 12 triangles. Triangles that touch no other operand stay as they are.
   * Default 'off'; an imprint cannot be simplified.
   */
  simplify?: 'off' | 'cut' | 'coplanar';
  /**
   * What `report.certified` says. 'relative' (the default): rounding added no crossing to those the operands had. 'absolute': no two
   * triangles of the result meet beyond what they share, and all have area; crossings an operand brought along make it false.
   */
  certify?: 'relative' | 'absolute';
  /**
   * 'float32': every coordinate of the result is one a float32 holds, and what is certified are these: for STL, GLB and graphics cards. What
   * this rounding folds is repaired as well. Default 'float64'.
   */
  coordinates?: 'float64' | 'float32';
  /**
   * A length in the unit of the coordinates; default 0. Operands that are as near as this are made to share: vertices become one, vertices are
   * put into edges and faces, edges that pass get a common vertex, faces on one another get the same triangles. No vertex moves farther.
   */
  tolerance?: number;
  /** Bytes that the list of faces which may touch can take, before the call fails with RESULT_TOO_LARGE. Default, and at most: 2 ** 30. */
  contactMemory?: number;
}

/** An operand after an imprint; pass it on as a mesh. Equal ids are one vertex, or coinciding triangles, of several operands. */
export interface ImprintedOperand extends Mesh {
  /** Per vertex: its number in the `mesh` of the result, ascending. */
  vertexIds: Uint32Array;
  /** Per triangle: its number in the `mesh` of the result; triangles of two operands with one number may run against each other. */
  facetIds: Uint32Array;
  /** Per vertex: the lowest vertex of the operand there, or 0xffffffff for a vertex the cut made. */
  sourceVertex: Uint32Array;
  /** Per triangle: the triangle of the operand it is a part of; ascending. */
  sourceFace: Uint32Array;
  /** Per triangle, seen from this operand: an index into `provenance.categoryNames`. */
  category: Uint8Array;
}

export interface ImprintResult extends BooleanResult {
  /** All triangles of all operands, those that coincide once: the model glued together. Provenance, graph and report are about it. */
  mesh: Mesh;
  operands: ImprintedOperand[];
}

export interface ImplantOptions extends BooleanOptions {
  /** The faces between host and component: 'keep' (the default) makes them regions of one mesh, 'drop' one body. */
  contact?: 'keep' | 'drop';
}

/**
 * All that is inside any operand; any number of them, one resolves itself.
 *
 * Operands that are not closed are sheets, in every operation: sets of points without volume. A result has volume where the
 * operation says so of the solids, and there are triangles of sheets in it where the operation says so of the operands that
 * contain them, a solid with its boundary: `intersect(sheet, solid)` is the part of the sheet inside, `subtract(sheet, solid)`
 * the part outside, `union` has both the solid and the part outside.
 */
export function union(operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;
export function union(first: Operand, ...rest: Operand[]): Promise<BooleanResult>;
export function union(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): Promise<BooleanResult>;

/** All that is inside every operand. */
export function intersect(operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;
export function intersect(first: Operand, ...rest: Operand[]): Promise<BooleanResult>;
export function intersect(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): Promise<BooleanResult>;

/** The first operand without all others. */
export function subtract(operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;
export function subtract(first: Operand, ...rest: Operand[]): Promise<BooleanResult>;
export function subtract(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): Promise<BooleanResult>;

/** What is inside an odd number of operands. */
export function symmetricDifference(operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;
export function symmetricDifference(first: Operand, ...rest: Operand[]): Promise<BooleanResult>;
export function symmetricDifference(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): Promise<BooleanResult>;

/**
 * The union with the faces inside it that separate regions of different operands, each once, and all sheets, inside and
 * outside: the non-regularized union. A sheet that separates a solid makes two regions of it.
 * `provenance.regionLeft` and `regionRight` name the regions on both sides, `report.regions` who contains them.
 */
export function partition(operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;
export function partition(first: Operand, ...rest: Operand[]): Promise<BooleanResult>;
export function partition(...operandsAndOptions: [Operand, ...Operand[], BooleanOptions]): Promise<BooleanResult>;

/**
 * What an expression says, '(a | b) & !c'. Operands are a, b, c ... in their order, or #0, #1, #2 ... From tight to loose: ! outside,
 * - without, & and, ^ an odd number, | or. What is true outside all operands is refused.
 */
export function combine(expression: string, operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;

/** The faces with the given tags after cutting all operands along their contacts; the result may be open. */
export function keep(tags: readonly FaceTag[], operands: readonly Operand[], options?: BooleanOptions): Promise<BooleanResult>;

/**
 * Every operand as it is, split along its contacts with the others; nothing is removed. Vertices, edges (by their vertices) and
 * coinciding triangles of `operands` have common ids; `mesh` has each of them once.
 */
export function imprint(operands: readonly MeshOperand[], options?: BooleanOptions): Promise<ImprintResult>;
export function imprint(first: MeshOperand, ...rest: MeshOperand[]): Promise<ImprintResult>;
export function imprint(...operandsAndOptions: [MeshOperand, ...MeshOperand[], BooleanOptions]): Promise<ImprintResult>;

/**
 * Components set into a host: host faces inside a component go, where faces coincide there is one, both sides share every edge. A
 * component stays entire; space inside both is the component's (the last one's). With `contact: 'drop'` it is the union.
 */
export function implant(operands: readonly MeshOperand[], options?: ImplantOptions): Promise<BooleanResult>;
export function implant(host: MeshOperand, component: MeshOperand, ...rest: MeshOperand[]): Promise<BooleanResult>;
export function implant(...operandsAndOptions: [MeshOperand, MeshOperand, ...MeshOperand[], ImplantOptions]): Promise<BooleanResult>;

/** The boundary of what a mesh that overlaps or crosses itself covers: all points where its winding is positive. */
export function resolve(mesh: MeshOperand, options?: BooleanOptions): Promise<BooleanResult>;
