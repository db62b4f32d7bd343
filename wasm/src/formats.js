// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The names of the file formats.
// @ts-check

/** The plain extension means the binary kind. */
export const formats = ['stl', 'stl-ascii', 'obj', 'ply', 'ply-ascii', 'off'];
