// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files and their formats.

import type { Mesh, MeshInput } from './mesh.js';

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

/** The mesh in a file (Node) or in bytes: equal positions welded, polygons triangulated, names as labels. */
export function readMesh(source: string | URL | Uint8Array | ArrayBuffer | Blob, options?: ReadOptions): Promise<Mesh>;

/** Writes a file (Node). */
export function writeMesh(path: string | URL, mesh: MeshInput, options?: WriteOptions): Promise<void>;
/** The bytes of a file. */
export function writeMesh(mesh: MeshInput, options: { format: Format }): Promise<Uint8Array>;
