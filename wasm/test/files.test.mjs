// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files, shapes, transforms and reports on single meshes.

import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

import { inspect, load, make, readMesh, roundToFloat32, subtract, transform, writeMesh } from 'mortise';

import { cube, soupOf, temporaryFolder } from './support.mjs';

const formats = ['stl', 'stl-ascii', 'obj', 'ply', 'ply-ascii', 'off', 'msh', 'msh22', 'vtk', 'vtu', 'mesh'];

test('every format but float32 STL gives back the bits it was given', async () => {
  const ball = await transform(await make('icosphere', { levels: 2 }), [{ scale: 1 / 3 }, { rotateX: 10 }]);
  for (const format of formats) {
    const back = await readMesh(await writeMesh(ball, { format }), { format });
    const corners = soupOf(back).positions;
    const expected = format === 'stl' ? Float64Array.from(soupOf(ball).positions, Math.fround) : soupOf(ball).positions;
    assert.deepEqual(corners, expected, format);
  }
});

test('the content tells the format of bytes', async () => {
  for (const format of formats) {
    const back = await readMesh(await writeMesh(cube(), { format }));
    assert.equal(back.triangles.length, 36, format);
  }
});

test('files are named by path or URL, their format by the ending', async (t) => {
  const folder = temporaryFolder(t);
  for (const ending of ['stl', 'obj', 'ply', 'off', 'STL', 'msh', 'vtk', 'vtu', 'mesh']) {
    const path = join(folder, `cube with blanks.${ending}`);
    assert.equal(await writeMesh(path, cube()), undefined);
    assert.equal((await readMesh(path)).triangles.length, 36);
    assert.equal((await readMesh(pathToFileURL(path))).positions.length, 24);
  }
  const mortise = await load();
  mortise.writeMesh(pathToFileURL(join(folder, 'now.ply')), cube());
  assert.equal(mortise.readMesh(join(folder, 'now.ply')).triangles.length, 36);
  assert.deepEqual(readdirSync(folder).filter((name) => name.endsWith('.part')), [], 'no drafts are left');
});

test('bytes may be a Uint8Array, a part of one, an ArrayBuffer or a Blob', async () => {
  const bytes = await writeMesh(cube(), { format: 'stl' });
  const within = new Uint8Array(bytes.length + 10);
  within.set(bytes, 7);
  const sources = [bytes, within.subarray(7, 7 + bytes.length), bytes.buffer, Buffer.from(bytes), new Blob([bytes]), new File([bytes], 'cube.stl')];
  for (const source of sources) assert.equal((await readMesh(source)).triangles.length, 36);
});

test('polygons an operation leaves whole are written as they were read', async () => {
  const faces = ['4 3 2 1 0', '4 4 5 6 7', '4 0 1 5 4', '4 1 2 6 5', '4 2 3 7 6', '4 3 0 4 7'];
  const text = `OFF\n8 6 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 4\n4 0 4\n4 4 4\n0 4 4\n${faces.join('\n')}\n`;
  const box = await readMesh(new TextEncoder().encode(text), { name: 'box.off' });
  assert.equal(box.triangles.length, 36);
  assert.equal(box.diagonals.length, 12);
  const { mesh } = await subtract(box, await make('box', { lo: [3, 3, 3], hi: [5, 5, 5] }));
  const written = new TextDecoder().decode(await writeMesh(mesh, { format: 'off' })).split('\n');
  assert.deepEqual(written.filter((line) => line.startsWith('4 ')).slice(-3), [faces[0], faces[2], '4 3 0 4 6'], 'vertex 6 is cut off');
  await assert.rejects(subtract({ ...box, diagonals: new Uint8Array(3) }, box), { code: 'INVALID_ARGUMENT' });
  await assert.rejects(subtract({ ...box, diagonals: box.diagonals.map(() => 8) }, box), { code: 'INVALID_ARGUMENT' });
});

test('groups of an OBJ become labels and are written again', async () => {
  const text = 'o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\no right\nf 1 2 4\n';
  const mesh = await readMesh(new TextEncoder().encode(text), { name: 'two.obj' });
  const names = (m) => [...m.faceLabels].map((label) => m.labelNames[label]);
  assert.equal(new Set(names(mesh)).size, 2);
  const again = await readMesh(await writeMesh(mesh, { format: 'obj' }), { format: 'obj' });
  assert.deepEqual(names(again), names(mesh));
});

test('labels are named groups in the formats of analysis programs', async () => {
  const mesh = { ...cube(), faceLabels: new Uint32Array(12).map((_, i) => (i < 2 ? 1 : 0)), labelNames: ['wall', 'in let \u00e4'] };
  const names = (m) => [...m.faceLabels].map((label) => m.labelNames[label]);
  for (const format of ['msh', 'msh22', 'vtk', 'vtu', 'mesh']) {
    const again = await readMesh(await writeMesh(mesh, { format }), { format });
    assert.deepEqual(names(again), names(mesh), format);
  }
});

test('inp and bdf are written, with the names of labels, and not read', async () => {
  const mesh = { ...cube(), faceLabels: new Uint32Array(12), labelNames: ['wall'] };
  const texts = { inp: /^\*ELSET, ELSET=wall$/m, bdf: /^\$HMNAME COMP +1"wall"$/m };
  for (const [format, pattern] of Object.entries(texts)) {
    const bytes = await writeMesh(mesh, { format });
    assert.match(new TextDecoder().decode(bytes), pattern);
    await assert.rejects(readMesh(bytes, { format }), { code: 'UNKNOWN_FORMAT' });
    await assert.rejects(readMesh(bytes, { name: `deck.${format}` }), { code: 'UNKNOWN_FORMAT', message: /written, not read/ });
  }
});

test('glb is written, a named material for each label, and not read', async () => {
  const mesh = { ...cube(), faceLabels: new Uint32Array(12).map((_, i) => (i < 2 ? 1 : 0)), labelNames: ['wall', 'in let \u00e4'] };
  const bytes = await writeMesh(mesh, { format: 'glb' });
  const { buffer, byteOffset } = bytes;
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, byteOffset + 20, new DataView(buffer, byteOffset).getUint32(12, true))));
  assert.deepEqual(json.materials.map(({ name }) => name), mesh.labelNames);
  assert.deepEqual(json.accessors.map(({ count }) => count), [8, 30, 6]);
  await assert.rejects(readMesh(bytes, { format: 'glb' }), { code: 'UNKNOWN_FORMAT' });
});

test('volume elements of analysis files are refused with their line', async () => {
  const text = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 4 2 0 1 1 1 1 1\n$EndElements\n';
  await assert.rejects(readMesh(new TextEncoder().encode(text)), (error) => {
    assert.deepEqual([error.code, error.details.kind, error.details.ids], ['PARSE_FAILED', 'line', [10]]);
    return true;
  });
});

test('steps are done in the order given', async () => {
  const point = { positions: [1, 0, 0, 2, 0, 0, 1, 1, 0] };
  const first = async (steps) => [...(await transform(point, steps)).positions.subarray(0, 3)].map((x) => x + 0);
  assert.deepEqual(await first([{ translate: [1, 0, 0] }, { rotateZ: 90 }]), [0, 2, 0]);
  assert.deepEqual(await first([{ rotateZ: 90 }, { translate: [1, 0, 0] }]), [1, 1, 0]);
  assert.deepEqual(await first([{ scale: [2, 3, 4] }, { mirror: 'x' }]), [-2, 0, 0]);
  assert.deepEqual(await first([]), [1, 0, 0]);
});

test('a mirrored solid keeps its outside outside', async () => {
  const mirrored = await transform(cube(), [{ mirror: 'y' }]);
  assert.equal((await inspect(mirrored)).volume, 1);
});

test('labels survive a transform', async () => {
  const labelled = { ...cube(), faceLabels: new Uint32Array(12).fill(1), labelNames: ['a', 'b'] };
  const moved = await transform(labelled, [{ scale: 2 }]);
  assert.deepEqual([moved.faceLabels, moved.labelNames], [labelled.faceLabels, labelled.labelNames]);
});

test('every shape has the counts and the measure of its definition', async () => {
  const count = async (shape, parameters) => {
    const { vertices, triangles, closed, genus, volume } = await inspect(await make(shape, parameters));
    return { vertices, triangles, closed, genus, volume: volume === null ? null : Number(volume.toFixed(6)) };
  };
  assert.deepEqual(await count('box', { lo: [-1, -1, 0], hi: [1, 1, 3] }), { vertices: 8, triangles: 12, closed: true, genus: 0, volume: 12 });
  assert.deepEqual(await count('icosphere', { levels: 1 }), { vertices: 42, triangles: 80, closed: true, genus: 0, volume: 3.658712 });
  assert.deepEqual(await count('sphere', { around: 4, rings: 2 }), { vertices: 6, triangles: 8, closed: true, genus: 0, volume: 1.333333 });
  assert.deepEqual(await count('cylinder', { height: 3, around: 4 }), { vertices: 10, triangles: 16, closed: true, genus: 0, volume: 6 });
  assert.deepEqual(await count('cone', { height: 3, around: 4 }), { vertices: 6, triangles: 8, closed: true, genus: 0, volume: 2 });
  assert.deepEqual(await count('gridSheet', { cellsX: 2, cellsY: 3 }), { vertices: 12, triangles: 12, closed: false, genus: null, volume: null });
  const torus = await count('torus', { majorRadius: 3, minorRadius: 1, around: 8, across: 6 });
  assert.deepEqual([torus.vertices, torus.triangles, torus.genus], [48, 96, 1]);
  const outline = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
  assert.deepEqual(await count('extrude', { outline, height: 2 }), { vertices: 12, triangles: 20, closed: true, genus: 0, volume: 6 });
  const ring = await count('revolve', { profile: [[1, 0], [2, 0], [2, 1], [1, 1]], around: 4 });
  assert.deepEqual(ring, { vertices: 16, triangles: 32, closed: true, genus: 1, volume: 6 });
});

test('shapes have defaults', async () => {
  for (const shape of ['box', 'sphere', 'icosphere', 'cylinder', 'cone', 'torus']) assert.ok((await inspect(await make(shape))).volume > 0, shape);
});

test('inspect finds open edges, self-intersections and what it welded', async () => {
  const open = cube();
  open.triangles = open.triangles.subarray(3);
  const report = await inspect(open);
  assert.deepEqual([report.closed, report.boundaryEdges, report.volume, report.genus], [false, 3, null, null]);

  const [a, b] = [cube(), cube(0.5, 0.5, 0.5)];
  const both = { positions: [...a.positions, ...b.positions], triangles: [...a.triangles, ...b.triangles.map((v) => v + 8)] };
  const crossing = await inspect(both);
  assert.ok(crossing.selfIntersections > 0);
  assert.equal(crossing.certified, false);
  assert.equal(crossing.components, 2);

  const welded = await inspect(soupOf(cube()));
  assert.deepEqual([welded.vertices, welded.closed, welded.certified], [8, true, true]);
  assert.ok(welded.notes.some((note) => note.startsWith('28 vertices were welded')));
});

test('what float32 collapses is cleaned up, so that the file is sound', async () => {
  const ball = await make('icosphere', { levels: 3 });
  const cut = await subtract(ball, await transform(ball, [{ translate: [1e-4, 2e-4, 3e-4] }]));
  const plain = await inspect(await readMesh(await writeMesh(cut.mesh, { format: 'stl' })));
  const rounded = await roundToFloat32(cut.mesh);
  assert.ok(rounded.positions.every((x) => x === Math.fround(x)));
  const stored = await readMesh(await writeMesh(rounded, { format: 'stl' }));
  const report = await inspect(stored);
  assert.deepEqual(stored.positions.length, rounded.positions.length);
  assert.equal(report.closed, true);
  assert.ok(!plain.notes.some((note) => /no area/.test(note)) || !report.notes.some((note) => /no area/.test(note)), report.notes.join());
});
