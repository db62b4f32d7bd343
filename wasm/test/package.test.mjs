// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The packed package, installed in an empty folder.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import process from 'node:process';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';

import { temporaryFolder } from './support.mjs';

const require = createRequire(import.meta.url);
const packageFolder = fileURLToPath(new URL('..', import.meta.url));
// The core: 461 with remeshing, its bound on the deviation and the report of quality, 4 for merged features, 4 for zones (what could be compiled for size is).
const mostKilobytes = { 'dist/core.wasm': 472, 'dist/glue.mjs': 16 };

test('the tarball installs without a network and works by import, require and command', (t) => {
  const folder = temporaryFolder(t);
  const npm = (...args) => execFileSync('npm', [...args, '--loglevel=error'], { cwd: folder, encoding: 'utf8' });
  const [{ filename, files }] = JSON.parse(npm('pack', '--json', packageFolder));
  const packed = files.map(({ path }) => path);
  for (const needed of ['LICENSE', 'THIRD_PARTY_NOTICES', 'README.md', 'package.json', 'dist/core.wasm', 'dist/glue.mjs', 'src/node.js', 'src/index.d.ts', 'src/types/models.d.ts', 'src/types/quality.d.ts', 'src/types/remesh.d.ts', 'src/types/sizing.d.ts']) {
    assert.ok(packed.includes(needed), needed);
  }
  assert.deepEqual(packed.filter((path) => /^(test|tools|bindings)\//.test(path)), []);
  assert.equal(existsSync(join(packageFolder, 'LICENSE')), false, 'the lent licence is taken back');

  writeFileSync(join(folder, 'package.json'), '{"private": true}');
  npm('install', '--offline', '--no-audit', '--no-fund', filename);
  const lock = JSON.parse(readFileSync(join(folder, 'package-lock.json'), 'utf8'));
  assert.deepEqual(Object.keys(lock.packages), ['', 'node_modules/mortise'], 'no dependencies');
  const notices = readFileSync(join(folder, 'node_modules/mortise/THIRD_PARTY_NOTICES'), 'utf8');
  assert.match(notices, /fast_float/i);
  assert.match(notices, /tinyobjloader/i);
  assert.match(readFileSync(join(folder, 'node_modules/mortise/LICENSE'), 'utf8'), /MIT/);

  const main = `const { make, union } = await load_(); console.log((await union(await make('box'), await make('icosphere'))).report.certified);`;
  writeFileSync(join(folder, 'main.mjs'), main.replace('load_()', "import('mortise')"));
  writeFileSync(join(folder, 'main.cjs'), `(async () => { ${main.replace('load_()', "require('mortise')")} })();`);
  for (const script of ['main.mjs', 'main.cjs']) {
    assert.equal(execFileSync(process.execPath, [script], { cwd: folder, encoding: 'utf8' }), 'true\n', script);
  }
  const bin = (...args) => execFileSync(join(folder, 'node_modules/.bin/mortise'), args, { cwd: folder, encoding: 'utf8' });
  bin('make', 'box', '-o', 'box.stl');
  assert.equal(JSON.parse(bin('union', 'box.stl', 'box.stl', '-o', 'two.ply', '--json')).volume, 1);

  for (const [kind, text] of [['mts', "import { union } from 'mortise';"], ['cts', "import { union } from 'mortise';"]]) {
    writeFileSync(join(folder, `use.${kind}`), `${text}\nexport const f: typeof union = union;\n`);
    const flags = ['--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', `use.${kind}`];
    assert.equal(execFileSync(process.execPath, [require.resolve('typescript/bin/tsc'), ...flags], { cwd: folder, encoding: 'utf8' }), '');
  }
});

test('the core stays within its size', (t) => {
  for (const [file, most] of Object.entries(mostKilobytes)) {
    const bytes = readFileSync(join(packageFolder, file));
    const [raw, gzip, brotli] = [bytes, gzipSync(bytes, { level: 9 }), brotliCompressSync(bytes)].map(({ length }) => length / 1024);
    t.diagnostic(`${file}: ${raw.toFixed(0)} KB, gzip ${gzip.toFixed(0)} KB, brotli ${brotli.toFixed(0)} KB`);
    assert.ok(brotli <= most, `${file} is ${brotli.toFixed(1)} KB in brotli, more than ${most}`);
  }
});
