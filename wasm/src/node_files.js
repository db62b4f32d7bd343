// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files of Node, with errors that name them.
// @ts-check

import { readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import process from 'node:process';

import { MeshError } from './errors.js';

/**
 * @param {string} action
 * @param {any} cause
 */
function fileFailed(action, cause) {
  return new MeshError('FILE_FAILED', `cannot ${action}: ${cause?.message ?? cause}`, {}, { cause });
}

/** @param {string | URL} path @returns {Uint8Array} */
export function readBytes(path) {
  try {
    return readFileSync(path);
  } catch (cause) {
    throw fileFailed(`read ${path}`, cause);
  }
}

/**
 * Writes beside the target first, so that nothing half-written ever has its name.
 * @param {string | URL} path
 * @param {Uint8Array} bytes
 */
export function writeBytes(path, bytes) {
  const draft = path instanceof URL ? new URL(`${path.href}.${process.pid}.part`) : `${path}.${process.pid}.part`;
  try {
    writeFileSync(draft, bytes);
    renameSync(draft, path);
  } catch (cause) {
    rmSync(draft, { force: true });
    throw fileFailed(`write ${path}`, cause);
  }
}
