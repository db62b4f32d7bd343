// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The names of the file formats.
// @ts-check

/**
 * The plain extension means the binary kind, or the newest version.
 * @type {import('./index.js').ReadableFormat[]}
 */
export const readableFormats = ['stl', 'stl-ascii', 'obj', 'ply', 'ply-ascii', 'off', 'msh', 'msh22', 'vtk', 'vtu', 'mesh'];

/** @type {import('./index.js').Format[]} */
export const writtenOnly = ['glb', 'inp', 'bdf'];

/**
 * All that can be written.
 * @type {import('./index.js').Format[]}
 */
export const formats = [...readableFormats, ...writtenOnly];

/**
 * Those of analysis programs, which keep entities of models and named groups.
 * @type {import('./index.js').ModelFormat[]}
 */
export const modelFormats = ['msh', 'msh22', 'vtk', 'vtu', 'mesh', 'inp', 'bdf'];
