// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes as plain arrays.

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
   * where they need them, so that these can be operands again; PLY files keep them, and models in MSH 4.1, others do not.
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

export interface Box {
  min: [number, number, number];
  max: [number, number, number];
}
