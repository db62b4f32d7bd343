// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models: entities and what bounds what, named data on them, and what they inherit.

import type { BooleanResult, ImprintedOperand, Provenance } from './booleans.js';
import type { ReadOptions } from './files.js';
import type { Mesh, MeshInput } from './mesh.js';
import type { HalfSpace } from './operands.js';

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
  sources?: { provenance: Provenance; operands: readonly (MeshInput | HalfSpace)[] };
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

/** A part of a model, by its number among those of its dimension. */
export interface ModelEntity {
  dimension: 'vertex' | 'edge' | 'face' | 'region';
  id: number;
}

/** What becomes of an attribute in the model of a result. */
export interface AttributePolicy {
  /** When an entity became several: 'copy' (default), all of them get it; 'largest', the one that has most of it; 'drop', none. */
  split?: 'copy' | 'largest' | 'drop';
  /**
   * When attributes of one name and different values meet on an entity: 'union' (default), it has all of them; 'first' and 'second', that of
   * the first or of the last operand; 'error', a MeshError; 'drop', none.
   */
  merge?: 'union' | 'first' | 'second' | 'error' | 'drop';
  /** When nothing of an entity is left: 'drop' (default), or 'toNeighbours', what is left of entities beside it gets it. */
  delete?: 'drop' | 'toNeighbours';
  /** What a copy on a part of a split entity is called: '{name} {piece}', pieces from 1. Default: as before. */
  pieceName?: string;
}

/** Named data on entities of a model: a material, a boundary condition, a load. */
export interface Attribute {
  name: string;
  targets: ModelEntity[];
  /** Default 'user'. */
  kind?: 'material' | 'boundaryCondition' | 'load' | 'size' | 'user';
  /** Anything JSON can hold; default null. Values are equal when their JSON is, whatever the order of keys. */
  value?: unknown;
  policy?: AttributePolicy;
}

/** What the attributes of a name cover, every entity once. */
export interface AttributeMeasure {
  name: string;
  vertices: number;
  length: number;
  area: number;
  volume: number;
}

/**
 * The regions, faces, edges and vertices of a mesh: what bounds what, and what every part of the mesh lies on. Entities are numbered
 * from 0; region 0 is the space outside. Numbers that are not there are a MeshError, INVALID_ARGUMENT.
 */
export interface Model<Given extends MeshInput = Mesh> {
  /** What it is a model of: not a copy, do not change its arrays. */
  readonly mesh: Given;
  readonly counts: ModelCounts;
  /** Per triangle: its face. */
  readonly triangleFace: Uint32Array;
  /** All of it in plain arrays. */
  readonly tables: ModelTables;
  /** At first one for each label of the mesh, on its faces; then what you make of it. Looked at when the model is used. */
  attributes: Attribute[];
  /** What the attributes cover, by name. */
  measures(): AttributeMeasure[];
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

/** An operand of an operation: its model, or what it is made of, for a model by default options. */
export type ModelOperand = Model<MeshInput> | MeshInput | HalfSpace;

export interface ResultModelOptions extends Omit<ModelOptions, 'sources'> {
  /** Operands whose attributes the result gets, by position. Default: all. */
  attributesOf?: readonly number[];
  /** Do faces end where attributes of faces of operands do? Default true. */
  splitAtAttributes?: boolean;
  /** Do faces end where operands met, whatever the angle? Default false. */
  graphEdges?: boolean;
  /** What `interfaces` call the operands. Default: a, b, c ... */
  names?: readonly string[];
}

/** An entity of the model of an operand, and how much of it is here: length, area or volume; 1 for a vertex. */
export interface EntitySource extends ModelEntity {
  operand: number;
  measure: number;
}

/** An entity of the model of a result, and how much of the source it has. */
export interface EntityPart extends ModelEntity {
  measure: number;
}

/** The model of a result with what it inherits: `attributes` are those of the operands, by their policies. */
export interface ResultModel extends Model<Mesh> {
  /** Where an entity comes from, ascending; nothing for what the cut made. */
  sourcesOf(entity: ModelEntity): EntitySource[];
  /** What became of an entity of an operand, ascending; nothing when it is gone. */
  partsOf(operand: number, entity: ModelEntity): EntityPart[];
  /**
   * 'interface(a.deck, b.face 3)' on every face that several operands share and every edge where faces of several meet; faces go by the
   * first attribute they have. Not among the `attributes` unless you put them there.
   */
  readonly interfaces: Attribute[];
}

/** Formats that keep entities of models and named groups. */
export type ModelFormat = 'msh' | 'msh22' | 'vtk' | 'vtu' | 'mesh' | 'inp' | 'bdf';

/** What `gmsh FILE.geo -3` fills with tetrahedra, regions conforming. */
export interface GmshProject {
  /** The surface in MSH 4.1, for a file of the name the script says. */
  mesh: Uint8Array;
  /** The regions and their names. */
  script: string;
}

/**
 * The model of any mesh: open or closed, with any number of triangles at an edge and of regions. For the result of an operation there is
 * `resultModel`; `sources` only gives it the creases of the operands.
 */
export function model<Given extends MeshInput>(mesh: Given, options?: ModelOptions): Promise<Model<Given>>;

/**
 * The model of what any operation answered, or of an operand of an imprint: with the creases of the operands, their attributes, and where
 * every entity comes from. Operands are those of the call in its order, moved as they were there. Of an operand of an imprint it is one;
 * its faces are parted where they lie otherwise to the others.
 */
export function resultModel(result: Pick<BooleanResult, 'mesh' | 'provenance'> | ImprintedOperand, operands: readonly ModelOperand[], options?: ResultModelOptions): Promise<ResultModel>;

/**
 * The model in a file (Node) or in bytes. Faces and edges of the file stay apart, and creases part faces as for `model`; named groups of
 * any dimension become attributes. `mesh` is what readMesh gives.
 */
export function readModel(source: string | URL | Uint8Array | ArrayBuffer | Blob, options?: ReadOptions & Omit<ModelOptions, 'sources'>): Promise<Model>;

/**
 * Writes a file (Node) with every vertex, edge, face and region the format can hold, and a named group for every attribute. When there
 * are attributes, faces and regions without one are called 'face 3' and 'region 2', so that programs do not leave them out.
 */
export function writeModel(path: string | URL, model: Model<MeshInput>, options?: { format?: ModelFormat }): Promise<void>;
/** The bytes of a file. */
export function writeModel(model: Model<MeshInput>, options: { format: ModelFormat }): Promise<Uint8Array>;

/** A script and a mesh for Gmsh. `meshFile`: the name the mesh will have, beside the script. */
export function gmshProject(model: Model<MeshInput>, options: { meshFile: string }): Promise<GmshProject>;
