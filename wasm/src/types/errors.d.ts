// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The one error type.

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
