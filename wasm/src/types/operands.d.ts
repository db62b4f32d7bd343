// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What operations on several meshes take.

/// <reference lib="esnext.disposable" />

import type { MeshInput } from './mesh.js';
import type { TransformStep } from './mesh_operations.js';

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

/** The mesh as an operand for many calls, in many places. */
export function prepare(mesh: MeshInput): Promise<PreparedOperand>;
