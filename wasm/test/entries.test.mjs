// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The ways into the package: import, require, the browser's entry, and where the core comes from.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import process from 'node:process';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import * as mortise from 'mortise';

import * as browser from '../src/browser.js';
import { coreLoader } from '../src/core.js';
import { createSyncApi } from '../src/sync_api.js';
import { cube, meshError } from './support.mjs';

const require = createRequire(import.meta.url);
const wasmFile = fileURLToPath(import.meta.resolve('mortise/core.wasm'));
const names = [
  ...['MeshError', 'combine', 'cornersToVertices', 'extrudeTo', 'gmshProject', 'groupByLabel', 'implant', 'imprint', 'inspect', 'intersect', 'keep', 'load', 'make', 'model', 'partition', 'predictTriangles', 'prepare', 'quality', 'readMesh', 'readModel', 'remesh', 'repair'],
  ...['resolve', 'resultModel', 'roundToFloat32', 'sizing', 'slice', 'split', 'splitPinches', 'subtract', 'symmetricDifference', 'transform', 'union', 'writeMesh', 'writeModel'],
];

test('import, require and the browser entry export the same names', () => {
  for (const entry of [mortise, require('mortise'), browser]) assert.deepEqual(Object.keys(entry).sort(), names);
});

test('require gives the same functions, and recognises the same errors', async () => {
  const required = require('mortise');
  assert.equal((await required.union(cube(), cube(0.5))).report.volume, 1.5);
  assert.equal(await required.load(), await mortise.load());
  const error = await meshError('INVALID_ARGUMENT', () => required.union(5), required.MeshError);
  assert.ok(error instanceof mortise.MeshError);
  assert.equal(new Error('x') instanceof required.MeshError, false);
  const own = new required.MeshError('NOT_CLOSED', 'text', { operand: 1 });
  assert.deepEqual([own.code, own.details.operand, own instanceof mortise.MeshError], ['NOT_CLOSED', 1, true]);
});

test('importing starts nothing: the core is loaded by the first call', () => {
  const script = `const before = WebAssembly.compile; let calls = 0; WebAssembly.compile = (x) => (++calls, before(x));
    const { make } = await import('mortise'); const early = calls; await make('box'); await make('box'); console.log(early, calls);`;
  const out = execFileSync(process.execPath, ['--input-type=module', '-e', script], { cwd: fileURLToPath(new URL('.', import.meta.url)) });
  assert.equal(out.toString(), '0 1\n');
});

test('the core runs where code from strings is forbidden', () => {
  const script = `const { union, make } = await import('mortise'); console.log((await union(await make('box'))).report.volume);`;
  const flags = ['--disallow-code-generation-from-strings', '--input-type=module', '-e', script];
  assert.equal(execFileSync(process.execPath, flags, { cwd: fileURLToPath(new URL('.', import.meta.url)) }).toString(), '1\n');
});

/** A server of one answer. */
async function serve(t, status, type, body) {
  const server = createServer((_, response) => response.writeHead(status, { 'content-type': type }).end(body));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => server.close());
  return `http://127.0.0.1:${server.address().port}/core.wasm`;
}

test('the browser entry says when core.wasm is not where it is looked for, and can be told again', async (t) => {
  const wasm = readFileSync(wasmFile);
  const missing = await meshError('FILE_FAILED', async () => browser.load({ wasmUrl: await serve(t, 404, 'text/plain', 'no') }), browser.MeshError);
  assert.match(missing.message, /HTTP 404/);
  const page = await serve(t, 200, 'text/html', '<!doctype html>');
  const html = await meshError('FILE_FAILED', () => browser.load({ wasmUrl: page }), browser.MeshError);
  assert.match(html.message, /not a WebAssembly file but text\/html/);
  const loaded = await browser.load({ wasmUrl: await serve(t, 200, 'application/octet-stream', wasm) });
  assert.equal(loaded.union(cube(), cube(0.5)).report.volume, 1.5);
  assert.equal((await browser.readMesh(new File([await browser.writeMesh(cube(), { format: 'off' })], 'cube.off'))).triangles.length, 36);
  await meshError('INVALID_ARGUMENT', () => browser.readMesh('cube.off'), browser.MeshError);
  await meshError('INVALID_ARGUMENT', () => browser.writeMesh('cube.off', cube()), browser.MeshError);
});

test('a core can be started from bytes or from compiled code', async () => {
  const never = () => assert.fail('the package must not look for its own file');
  const bytes = readFileSync(wasmFile);
  for (const options of [{ wasmBinary: bytes }, { wasmModule: await WebAssembly.compile(bytes) }]) {
    const core = await coreLoader(never).start(options);
    assert.equal(core.makeShape('box', Float64Array.of(0, 0, 0, 1, 1, 1)).value.triangles.length, 36);
  }
  await meshError('FILE_FAILED', () => coreLoader(never).start({ wasmBinary: new Uint8Array(8) }), mortise.MeshError);
  await meshError('INVALID_ARGUMENT', () => coreLoader(never).start({ wasmModule: {} }), mortise.MeshError);
});

test('a core that traps is not used again, and the next load starts a new one', async () => {
  let stops = 0;
  const trap = () => {
    throw new WebAssembly.RuntimeError('unreachable');
  };
  const api = createSyncApi({ makeShape: trap }, {}, () => ++stops);
  assert.match((await meshError('INTERNAL_ERROR', () => api.make('box'), mortise.MeshError)).message, /unreachable/);
  assert.match((await meshError('INTERNAL_ERROR', () => api.inspect(cube()), mortise.MeshError)).message, /load\(\) gives a new one/);
  assert.equal(stops, 1);

  const module = await WebAssembly.compile(readFileSync(wasmFile));
  const loader = coreLoader(async () => module);
  const first = await loader.start();
  assert.equal(await loader.start(), first);
  loader.forget();
  assert.notEqual(await loader.start(), first);
});

test('memory JavaScript does not have is an error after which the core goes on', async () => {
  let calls = 0;
  const answers = () => {
    if (++calls === 1) throw new RangeError('Array buffer allocation failed');
    return { value: cube() };
  };
  const api = createSyncApi({ makeShape: answers }, {}, assert.fail);
  await meshError('OUT_OF_MEMORY', () => api.make('box'), mortise.MeshError);
  assert.deepEqual(api.make('box'), cube());
});

test('the declarations fit both resolutions, and the sources fit the declarations', () => {
  const tsc = require.resolve('typescript/bin/tsc');
  for (const project of ['test/types/tsconfig.nodenext.json', 'test/types/tsconfig.bundler.json', 'tsconfig.json']) {
    const path = fileURLToPath(new URL(`../${project}`, import.meta.url));
    assert.equal(execFileSync(process.execPath, [tsc, '-p', path], { encoding: 'utf8' }), '', project);
  }
});
