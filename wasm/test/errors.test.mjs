// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every way of being called wrongly: a MeshError with code, words that help, and the place; every code of docs/errors.md.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';

import { extrudeTo, inspect, intersect, make, MeshError, readMesh, split, transform, union, writeMesh } from 'mortise';

import { createSyncApi } from '../src/sync_api.js';
import { cube, meshError } from './support.mjs';

const fails = (code, call) => meshError(code, call, MeshError);

test('an open operand is named with its open edges and where they are', async () => {
  const open = cube(3);
  open.triangles = open.triangles.subarray(3);
  const error = await fails('NOT_CLOSED', () => union(cube(), open, { kind: 'solid' }));
  const { operand, kind, ids, places } = error.details;
  assert.equal(operand, 1);
  assert.equal(kind, 'vertexPairs');
  const pairs = new Set([0, 2, 4].map((i) => [ids[i], ids[i + 1]].sort().join('-')));
  assert.deepEqual(pairs, new Set(['0-2', '2-3', '0-3']));
  assert.equal(places.length, 3);
  assert.ok(places.some((place) => String(place) === '3.5,0.5,0'), 'the middle of the diagonal');
});

test('NaN and infinity are named by vertex', async () => {
  for (const bad of [NaN, Infinity, -Infinity]) {
    const mesh = cube();
    mesh.positions[16] = bad;
    const error = await fails('NOT_FINITE', () => union(cube(), mesh));
    assert.deepEqual([error.details.operand, error.details.kind, error.details.ids], [1, 'vertices', [5]]);
  }
});

test('an index beyond the vertices is named by face, in every function that takes a mesh', async () => {
  const mesh = cube();
  mesh.triangles[4] = 8;
  for (const call of [() => union(mesh, cube()), () => inspect(mesh), () => transform(mesh, []), () => writeMesh(mesh, { format: 'obj' })]) {
    assert.deepEqual((await fails('BAD_INDEX', call)).details.ids, [1]);
  }
});

test('an index no integer holds is not wrapped but refused', async () => {
  const { positions, triangles } = cube();
  for (const bad of [-1, 1.5, 2 ** 32, NaN, '1']) {
    const error = await fails('BAD_INDEX', () => inspect({ positions, triangles: [...triangles.subarray(0, 35), bad] }));
    assert.deepEqual(error.details, { kind: 'faces', ids: [11] });
  }
});

test('an inside-out operand is refused', async () => {
  const mesh = cube();
  mesh.triangles.reverse();
  assert.equal((await fails('INSIDE_OUT', () => union(mesh, cube()))).details.operand, 0);
});

test('an operand with one face turned over is refused with the edges of that face', async () => {
  const mesh = cube();
  mesh.triangles.set([3, 2, 0], 0);
  const error = await fails('NOT_ORIENTED', () => union(cube(5), mesh));
  assert.equal(error.details.operand, 1);
  assert.equal(error.details.kind, 'vertexPairs');
});

test('what is no mesh is refused with what to do instead', async () => {
  const words = [
    [() => union(), /at least one mesh/],
    [() => union([]), /at least one mesh/],
    [() => union(5, cube()), /operand 0 must be a mesh .* not number 5/],
    [() => union(null), /operand 0 must be a mesh .* not null/],
    [() => union(cube(), make('box')), /operand 1 is a promise: await it first/],
    [async () => union(cube(), await union(cube())), /operand 1 is a result: pass its \.mesh/],
    [() => union(cube(), { isBufferGeometry: true }), /BufferGeometry.*attributes\.position\.array/],
    [() => union(cube(), { triangles: [0, 1, 2] }), /operand 1 has no positions/],
    [() => union({ positions: 'x' }), /positions must be a Float64Array.*not the string "x"/],
    [() => union({ positions: [1, 2] }), /2 numbers, which is not a multiple of 3/],
    [() => union({ positions: [1, 2, '3'] }), /positions\[2\] must be a number/],
    [() => union({ positions: new Float64Array(12) }), /no triangles, so its vertices count in threes/],
    [() => union({ ...cube(), triangles: [0, 1] }), /triangles holds 2 numbers/],
    [() => union({ ...cube(), faceLabels: [1] }), /1 entries for 12 triangles/],
    [() => union({ ...cube(), labelNames: ['a'] }), /without operand 0\.faceLabels/],
    [() => union({ ...cube(), faceLabels: new Uint32Array(12).fill(1), labelNames: ['a'] }), /uses label 1/],
    [() => union({ ...cube(), faceLabels: new Uint32Array(12), labelNames: [5] }), /array of strings/],
    [() => union({ ...cube(), faceLabels: new Uint32Array(12).fill(1e6) }), /give operand 0\.labelNames/],
    [() => union([cube()], {}, cube()), /takes two arguments, not 3/],
    [() => union(cube(), { onprogress: () => true }), /unknown option 'onprogress'; known: onProgress, signal/],
    [() => union([cube()], 5), /options must be an object/],
    [() => union(cube(), { onProgress: 5 }), /onProgress must be a function/],
    [() => union(cube(), { signal: {} }), /signal must be an AbortSignal/],
    [() => union(cube(), { inspect: 'brief' }), /inspect must be true or false, not the string "brief"/],
    [() => transform(cube(), { scale: 2 }), /array of steps/],
    [() => transform(cube(), [{ scale: 2, rotateX: 5 }]), /steps\[0\] must be/],
    [() => transform(cube(), [{ translate: [1, 2] }]), /steps\[0\] must be/],
    [() => transform(cube(), [{ mirror: 'w' }]), /steps\[0\] must be/],
    [() => transform(cube(), [{ scale: 0 }]), /./],
    [() => make('teapot'), /the shapes are box, sphere.*not the string "teapot"/],
    [() => make('toString'), /the shapes are/],
    [() => make('box', { radius: 1 }), /no parameter 'radius'; it has lo, hi/],
    [() => make('sphere', { radius: '1' }), /radius of sphere must be a number/],
    [() => make('sphere', { around: 2.5 }), /around of sphere must be a whole number/],
    [() => make('sphere', { radius: -1 }), /positive/],
    [() => make('extrude'), /outline of extrude must be an array/],
    [() => readMesh(5), /readMesh takes/],
    [() => writeMesh(cube()), /needs the format/],
  ];
  for (const [call, text] of words) assert.match((await fails('INVALID_ARGUMENT', call)).message, text);
});

test('a coordinate that does not fit is refused by vertex', async () => {
  const error = await fails('OUT_OF_RANGE', () => transform(cube(9), [{ scale: 1e308 }]));
  assert.equal(error.details.kind, 'vertices');
  const far = await fails('OUT_OF_RANGE', () => writeMesh({ positions: [0, 0, 0, 1e300, 0, 0, 0, 1, 0] }, { format: 'stl' }));
  assert.deepEqual(far.details.ids, [1]);
});

test('more than the memory of the core is an error, and the next call works', async () => {
  await fails('OUT_OF_MEMORY', () => make('gridSheet', { cellsX: 15000, cellsY: 15000 }));
  assert.equal((await union(cube(), cube(0.5))).report.volume, 1.5);
});

test('files that follow no format are refused with line or byte', async () => {
  const text = (s) => new TextEncoder().encode(s);
  const line = await fails('PARSE_FAILED', () => readMesh(text('v 0 0 0\nv 1 zero 0\nf 1 2 1\n'), { format: 'obj' }));
  assert.deepEqual([line.details.kind, line.details.ids], ['line', [2]]);
  await fails('NOT_FINITE', () => readMesh(text('v 0 0 nan\n'), { format: 'obj' }));
  await fails('UNKNOWN_FORMAT', () => readMesh(text('what is this?')));
  await fails('UNKNOWN_FORMAT', () => readMesh(text(''), { format: 'step' }));
  await fails('UNKNOWN_FORMAT', () => writeMesh('/tmp/mesh.step', cube()));
  await fails('FILE_FAILED', () => readMesh('/nowhere/at/all.stl'));
  await fails('FILE_FAILED', () => writeMesh('/nowhere/at/all.stl', cube()));
});

test('an error is an Error with a name, a stack and fields that survive a copy', async () => {
  const error = await fails('NOT_FINITE', () => inspect({ positions: [NaN, 0, 0, 1, 0, 0, 0, 1, 0] }));
  assert.ok(error instanceof Error);
  assert.equal(error.name, 'MeshError');
  assert.match(error.stack, /errors\.test/);
  assert.equal(structuredClone(error.details).kind, 'vertices');
});

/** Code and kinds of places of every line of docs/errors.md. */
function documented() {
  const text = readFileSync(new URL('../../docs/errors.md', import.meta.url), 'utf8');
  const rows = text.split('\n').filter((line) => line.startsWith('| ')).map((line) => line.split('|').map((cell) => cell.trim()));
  return new Map(rows.slice(1).map((cells) => [cells[1], cells[3].split(', ')]));
}

/** The unit cube with a change. */
function changed(change) {
  const mesh = cube();
  return change(mesh) ?? mesh;
}

/** Many long needles: all their boxes overlap. */
function needles(count, step) {
  const corners = (i) => [0, 0, step * i, 1, 0, step * i + 1, 1, 1, step * i + 2];
  return { positions: Float64Array.from(Array.from({ length: count }, (_, i) => corners(i)).flat()) };
}

/** A core that stops. No call reaches INTERNAL_ERROR in the real one: what does is a bug to mend. */
function stoppedCore() {
  return createSyncApi({ makeShape: () => { throw new WebAssembly.RuntimeError('unreachable'); } }, {}, () => {});
}

const sheet = { positions: [0, 0, 0, 1, 0, 0, 1, 1, 2, 0, 1, 2], triangles: [0, 1, 2, 0, 2, 3] };
const upright = { positions: [0, 0, 1, 1, 0, 1, 1, 0, 2] };
const read = (text, format) => readMesh(new TextEncoder().encode(text), { format });

/** The bytes of a file of the cube, with a number in place of another; `at` counts from the end when negative. */
async function fileWith(format, at, write) {
  const bytes = await writeMesh(cube(), { format });
  write(new DataView(bytes.buffer, bytes.byteOffset + (at < 0 ? bytes.length + at : at)));
  return bytes;
}

/** Calls that fail: with which code, with which kind of places. */
const provocations = [
  ['INVALID_ARGUMENT', 'none', () => union()],
  ['INVALID_ARGUMENT', 'faces', () => extrudeTo(upright, { z: 0 })],
  ['INVALID_ARGUMENT', 'vertices', () => extrudeTo(sheet, { z: 0 })],
  ['NOT_FINITE', 'vertices', () => union(cube(), changed((mesh) => void (mesh.positions[4] = NaN)))],
  ['NOT_FINITE', 'line', () => read('v 0 0 nan\n', 'obj')],
  ['NOT_FINITE', 'byte', async () => readMesh(await fileWith('stl', 96, (view) => view.setFloat32(0, NaN, true)), { format: 'stl' })],
  ['BAD_INDEX', 'faces', () => union(cube(), changed((mesh) => void (mesh.triangles[4] = 8)))],
  ['BAD_INDEX', 'line', () => read('v 0 0 0\nf 1 2 1\n', 'obj')],
  ['BAD_INDEX', 'byte', async () => readMesh(await fileWith('ply', -4, (view) => view.setUint32(0, 8, true)), { format: 'ply' })],
  ['NOT_CLOSED', 'vertexPairs', () => union(cube(), changed((mesh) => ({ ...mesh, triangles: mesh.triangles.subarray(3) })), { kind: 'solid' })],
  ['NOT_CLOSED', 'none', () => split({ ...sheet, walls: Uint8Array.of(1, 0) }, { by: 'regions' })],
  ['NOT_ORIENTED', 'vertexPairs', () => union(cube(), changed((mesh) => mesh.triangles.set([3, 2, 0], 0)))],
  ['INSIDE_OUT', 'faces', () => union(cube(), changed((mesh) => void mesh.triangles.reverse()))],
  ['OUT_OF_RANGE', 'vertices', () => transform(cube(9), [{ scale: 1e308 }])],
  ['OUT_OF_RANGE', 'line', () => read('v 0 0 1e999\n', 'obj')],
  ['OUT_OF_RANGE', 'none', () => intersect({ positions: [-1e308, 0, 0, 1e308, 1, 0, 0, 0, 1] }, { plane: [1, 0, 0, 1e308] })],
  ['RESULT_TOO_LARGE', 'none', () => union(needles(8300, 1e-7), needles(8300, 2e-7))],
  ['PARSE_FAILED', 'line', () => read('v 0 zero 0\n', 'obj')],
  ['PARSE_FAILED', 'byte', async () => readMesh((await writeMesh(cube(), { format: 'stl' })).subarray(1), { format: 'stl' })],
  ['UNKNOWN_FORMAT', 'none', () => readMesh(new Uint8Array(9))],
  ['FILE_FAILED', 'none', () => readMesh('/nowhere/at/all.stl')],
  ['CANCELLED', 'none', () => union(cube(), cube(0.5), { onProgress: () => false })],
  ['OUT_OF_MEMORY', 'none', () => make('gridSheet', { cellsX: 15000, cellsY: 15000 })],
  ['INTERNAL_ERROR', 'none', () => stoppedCore().make('box')],
];

test('the documentation has the codes of the declarations', () => {
  const declarations = readFileSync(new URL('../src/types/errors.d.ts', import.meta.url), 'utf8');
  const [, codes] = declarations.match(/export type MeshErrorCode =([^;]*);/);
  assert.deepEqual([...documented().keys()], [...codes.matchAll(/'(\w+)'/g)].map(([, code]) => code));
});

test('every code of the documentation can be provoked, with every kind of places', async () => {
  const words = [...documented()].flatMap(([code, kinds]) => kinds.map((kind) => `${code} ${kind}`));
  assert.deepEqual(provocations.map(([code, kind]) => `${code} ${kind}`).sort(), words.sort());
  for (const [code, kind, call] of provocations) assert.equal((await fails(code, call)).details.kind ?? 'none', kind, code);
  assert.equal((await union(cube(), cube(0.5))).report.volume, 1.5);
});
