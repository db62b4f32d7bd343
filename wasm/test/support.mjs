// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the tests of the package share.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const command = fileURLToPath(new URL('../src/cli/main.js', import.meta.url));

/** The unit cube, moved by (x, y, z). */
export function cube(x = 0, y = 0, z = 0) {
  const positions = [];
  for (let i = 0; i < 8; ++i) positions.push(x + (i & 1), y + ((i >> 1) & 1), z + ((i >> 2) & 1));
  const triangles = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5];
  return { positions: Float64Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** The same surface without shared vertices. */
export function soupOf(mesh) {
  return { positions: Float64Array.from([...mesh.triangles].flatMap((v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)])) };
}

/** Runs the command; `input` goes to its standard input. */
export function run(args, { input = undefined, cwd = undefined } = {}) {
  const done = spawnSync(process.execPath, [command, ...args], { input, cwd, maxBuffer: 1 << 28 });
  return { code: done.status, out: done.stdout.toString(), bytes: done.stdout, err: done.stderr.toString() };
}

/** Starts the command without waiting for it. */
export function start(args, { cwd }) {
  return spawn(process.execPath, [command, ...args], { cwd });
}

/** A folder that is gone after the test. */
export function temporaryFolder(test) {
  const folder = mkdtempSync(join(tmpdir(), 'mortise-test-'));
  test.after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Asserts that a call throws or rejects with a MeshError of this code, and returns it. */
export async function meshError(code, call, MeshError) {
  try {
    await call();
  } catch (error) {
    assert.ok(error instanceof MeshError, `not a MeshError: ${error?.stack}`);
    assert.equal(error.code, code, error.message);
    return error;
  }
  return assert.fail(`no error, ${code} was expected`);
}
