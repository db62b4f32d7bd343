// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Runs the command lines the page shows.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const command = fileURLToPath(new URL('../../../wasm/src/cli/main.js', import.meta.url));

/** Runs lines in a shell, in a folder that holds these files; `npx mortise` is the command of this repository. */
export function runCommands(t, text, files = []) {
  const folder = mkdtempSync(join(tmpdir(), 'mortise-page-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  for (const { name, bytes } of files) writeFileSync(join(folder, name), bytes);
  const lines = text.replaceAll(/^npx mortise/gm, '"$NODE" "$MORTISE"').split('\n');
  const last = `${lines.pop()} --json`;
  const run = (line) => {
    const done = spawnSync('sh', ['-euc', line], { cwd: folder, env: { ...process.env, NODE: process.execPath, MORTISE: command }, encoding: 'utf8' });
    assert.equal(done.status, 0, `${line}\n${done.stderr}`);
    return done.stdout;
  };
  lines.forEach(run);
  return { report: JSON.parse(run(last)), bytes: new Uint8Array(readFileSync(join(folder, 'result.ply'))) };
}
