// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The declarations of the package: exact booleans of triangle meshes.

/// <reference lib="esnext.disposable" />

/** A quantity with values at the vertices of a mesh, or at the corners of its triangles; linear on each triangle. */
export interface DataChannel {
  /** Numbers per vertex or per corner. */
  components: number;
  /** NaN where there is no value. */
  values: Float64Array;
  /** 'vector': moves along with the mesh. 'normal': the same, and turns round with a triangle that is flipped. Otherwise 'value', not stated. */
  kind?: 'vector' | 'normal';
}

/** What meshes that are handed in may have for a channel; an attribute of three.js with its `itemSize` and `array` will do. */
export type DataInput = ({ components: number; values: NumberArray } | { itemSize: number; array: NumberArray }) & {
  /** Default: 'normal' for a channel of three components with the name `normal`, else 'value'. */
  kind?: 'value' | 'vector' | 'normal';
};

export type NumberArray = Float64Array | Float32Array | ArrayLike<number>;

/** A mesh as plain arrays. Three coordinates per vertex, three vertex indices per triangle, counterclockwise from outside. */
export interface Mesh {
  positions: Float64Array;
  triangles: Uint32Array;
  /** One per triangle: index into `labelNames`. */
  faceLabels?: Uint32Array;
  /** Names of groups, solids or materials. */
  labelNames?: string[];
  /**
   * One per triangle: 1 for a wall, which has the solid on both sides or on neither: faces between regions, sheets. Results have them
   * where they need them, so that these can be operands again; PLY files keep them, others do not.
   */
  walls?: Uint8Array;
  /**
   * One per triangle: bit k is set when the edge from corner k to the next is inside a polygon that was triangulated. Files of polygons are
   * read so; polygons that an operation left whole are written as polygons again.
   */
  diagonals?: Uint8Array;
  /** Channels by name, with values for each vertex. */
  vertexData?: Record<string, DataChannel>;
  /** Channels by name, with values for each corner of each triangle: those of triangle t begin at 3 t components. Results have these. */
  cornerData?: Record<string, DataChannel>;
}

/** What every function takes for a mesh. Without `triangles`, every three vertices are a triangle. Never changed. */
export interface MeshInput {
  positions: Float64Array | Float32Array | ArrayLike<number>;
  triangles?: Uint32Array | ArrayLike<number> | null;
  faceLabels?: Uint32Array | ArrayLike<number>;
  labelNames?: readonly string[];
  walls?: Uint8Array;
  diagonals?: Uint8Array;
  /** uv, normals, colours, temperatures, by name. Results have them at corners; nothing is interpolated across triangles of other meshes. */
  vertexData?: Record<string, DataInput>;
  cornerData?: Record<string, DataInput>;
}

/**
 * All points p with n . p <= d: what lies behind the plane [nx, ny, nz, d]. Exact for planes at right angles to an axis or of numbers a few
 * bits long, else through three doubles next to the plane. A result that would reach to infinity is refused; a partition is divided by it.
 */
export interface HalfSpace {
  plane: readonly [number, number, number, number];
}

/**
 * A mesh that stays in the core for many calls. Its arrays cross once, and what does not depend on its place is computed once; results are
 * bit for bit those of calls with the mesh itself. `dispose` it, or declare it with `using`; one that was forgotten goes when it is collected.
 */
export interface PreparedOperand {
  readonly vertices: number;
  readonly triangles: number;
  /** The operand moved by all steps in order, as `transform` does it; for one call or many. */
  at(steps: readonly TransformStep[]): PlacedOperand;
  /** Frees its memory in the core; calls that still name it fail with INVALID_ARGUMENT. A second time nothing happens. */
  dispose(): void;
  [Symbol.dispose](): void;
}

/** What PreparedOperand.at gives. */
export interface PlacedOperand {
  readonly prepared: PreparedOperand;
}

/** A mesh, or a prepared one. */
export type MeshOperand = MeshInput | PreparedOperand | PlacedOperand;

/** What the operations on several meshes take. */
export type Operand = MeshOperand | HalfSpace;

export interface Box {
  min: [number, number, number];
  max: [number, number, number];
}

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
  /** Triangles of operands that could not share all that is near. */
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

/** 'msh' is version 4.1, 'mesh' is MEDIT. */
export type ReadableFormat = 'stl' | 'stl-ascii' | 'obj' | 'ply' | 'ply-ascii' | 'off' | 'msh' | 'msh22' | 'vtk' | 'vtu' | 'mesh';

/** What can be written: 'glb' (float32 coordinates), 'inp' (Abaqus) and 'bdf' (Nastran) are not read. */
export type Format = ReadableFormat | 'glb' | 'inp' | 'bdf';

export interface ReadOptions {
  /** Default: by the name, then by the content. */
  format?: ReadableFormat;
  /** Name of the file the bytes come from. */
  name?: string;
}

export interface WriteOptions {
  /** Default: by the name. */
  format?: Format;
}

export type MeshErrorCode =
  | 'INVALID_ARGUMENT'
  | 'NOT_FINITE'
  | 'BAD_INDEX'
  | 'NOT_CLOSED'
  | 'NOT_ORIENTED'
  | 'INSIDE_OUT'
  | 'OUT_OF_RANGE'
  | 'RESULT_TOO_LARGE'
  | 'PARSE_FAILED'
  | 'UNKNOWN_FORMAT'
  | 'FILE_FAILED'
  | 'CANCELLED'
  | 'OUT_OF_MEMORY'
  | 'INTERNAL_ERROR';

export interface MeshErrorDetails {
  /** Stage of the pipeline. */
  stage?: string;
  /** Position of the operand in the call. */
  operand?: number;
  /** What `ids` are. */
  kind?: 'vertices' | 'faces' | 'vertexPairs' | 'line' | 'byte';
  /** At most 1,000 indices of the operand as it was given; of vertex pairs, two numbers each. */
  ids?: number[];
  /** Where that is: the vertex, the middle of the face or of the pair, one for each. */
  places?: [number, number, number][];
}

/** Thrown by every function of the package. `code` is for programs, `message` for people, `details` says where. */
export class MeshError extends Error {
  constructor(code: MeshErrorCode, message: string, details?: MeshErrorDetails, options?: { cause?: unknown });
  code: MeshErrorCode;
  details: MeshErrorDetails;
}

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
  model(mesh: MeshInput, options?: ModelOptions): Model;
  slice(mesh: MeshInput, options: { plane: readonly [number, number, number, number] }): Section;
  cornersToVertices(mesh: MeshInput, options?: { missing?: number }): VertexMesh;
  groupByLabel(mesh: MeshInput): GroupedMesh;
  readMesh(source: string | URL | Uint8Array | ArrayBuffer, options?: ReadOptions): Mesh;
  writeMesh(path: string | URL, mesh: MeshInput, options?: WriteOptions): void;
  writeMesh(mesh: MeshInput, options: { format: Format }): Uint8Array;
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

/** The mesh as an operand for many calls, in many places. */
export function prepare(mesh: MeshInput): Promise<PreparedOperand>;

/** Numbers about one mesh. */
export function inspect(mesh: MeshInput): Promise<Report>;

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
 * The model of any mesh: open or closed, with any number of triangles at an edge and of regions. For the result of an operation give
 * it `sources`: then creases are those of the operands.
 */
export function model(mesh: MeshInput, options?: ModelOptions): Promise<Model>;

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

/** The mesh in a file (Node) or in bytes: equal positions welded, polygons triangulated, names as labels. */
export function readMesh(source: string | URL | Uint8Array | ArrayBuffer | Blob, options?: ReadOptions): Promise<Mesh>;

/** Writes a file (Node). */
export function writeMesh(path: string | URL, mesh: MeshInput, options?: WriteOptions): Promise<void>;
/** The bytes of a file. */
export function writeMesh(mesh: MeshInput, options: { format: Format }): Promise<Uint8Array>;

/** The same functions, synchronous. The core is started once per program. */
export function load(options?: LoadOptions): Promise<Mortise>;
