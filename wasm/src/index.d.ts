// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The declarations of the package: exact booleans of triangle meshes.

export * from './types/mesh.js';
export * from './types/operands.js';
export * from './types/report.js';
export * from './types/booleans.js';
export * from './types/mesh_operations.js';
export * from './types/models.js';
export * from './types/sizing.js';
export * from './types/quality.js';
export * from './types/remesh.js';
export * from './types/files.js';
export * from './types/errors.js';
export * from './types/load.js';
