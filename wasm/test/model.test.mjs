// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models in JavaScript and from the command.

import assert from 'node:assert/strict';
import test from 'node:test';

import { load } from 'mortise';

import { cube as makeCube, run, temporaryFolder } from './support.mjs';

const { make, model, partition, subtract, union, transform } = await load();
const cube = makeCube();

test('a cube has 8 vertices, 12 edges, 6 faces and a region', () => {
  const box = model(cube);
  assert.deepEqual(box.counts, { triangles: 12, modelFaces: 6, modelEdges: 12, modelVertices: 8, regions: 1, voids: 0, meshEdgesOnModelEdges: 12 });
  for (let i = 0; i < 8; ++i) assert.equal(box.vertex(i).edges.length, 3);
  for (let i = 0; i < 12; ++i) {
    const { start, end, faces, path, length, seam } = box.edge(i);
    assert.equal(faces.length, 2);
    assert.deepEqual([...path], [box.vertex(start).meshVertex, box.vertex(end).meshVertex]);
    assert.deepEqual([length, seam], [1, false]);
  }
  for (let i = 0; i < 6; ++i) {
    const { area, genus, loops, regionBehind, regionInFront } = box.face(i);
    assert.deepEqual([area, genus, regionBehind, regionInFront, loops.length], [1, 0, 1, 0, 1]);
    assert.equal(loops[0].edges.length, 4);
    assert.equal(box.trianglesOf(i).length, 2);
    for (const t of box.trianglesOf(i)) assert.equal(box.triangleFace[t], i);
  }
  assert.equal(box.region(1).volume, 1);
  assert.equal(box.region(0).volume, Infinity);
  assert.equal(box.region(1).shells[0].length, 6);
  assert.deepEqual(box.entityOf(box.vertex(3).meshVertex), { dimension: 'vertex', id: 3 });
  assert.ok(box.tables.path instanceof Uint32Array);
});

test('a cylinder has a seam, or none, and a torus as many as open it', () => {
  const cylinder = make('cylinder', { radius: 1, height: 3, around: 17 });
  const { modelFaces, modelEdges, modelVertices } = model(cylinder).counts;
  assert.deepEqual([modelFaces, modelEdges, modelVertices], [3, 3, 2]);
  assert.equal(model(cylinder, { seams: 'none' }).counts.modelEdges, 2);
  const side = model(cylinder).tables.edgeIsSeam.indexOf(1);
  assert.equal(model(cylinder).edge(side).faces.length, 2);
  const torus = make('torus', { majorRadius: 2, minorRadius: 0.5, around: 24, across: 12 });
  assert.equal(model(torus).face(0).genus, 1);
  assert.equal(model(torus, { seams: 'disc' }).face(0).genus, 0);
});

test('cavities are voids, partitions have several regions', () => {
  const big = make('box', { lo: [0, 0, 0], hi: [4, 4, 4] }), small = make('box', { lo: [1, 1, 1], hi: [2, 2, 2] });
  const hollow = model(subtract(big, small).mesh);
  assert.deepEqual([hollow.counts.regions, hollow.counts.voids], [1, 1]);
  assert.deepEqual([1, 2].map((i) => [hollow.region(i).volume, hollow.region(i).void]), [[63, false], [1, true]]);
  const overlapping = partition(make('box', { lo: [0, 0, 0], hi: [2, 2, 2] }), make('box', { lo: [1, 1, 1], hi: [3, 3, 3] }));
  const { modelVertices, modelEdges, modelFaces, regions } = model(overlapping.mesh).counts;
  assert.deepEqual([modelVertices, modelEdges, modelFaces, regions], [22, 36, 18, 3]);
});

test('faces of a result have the creases of its operands', () => {
  // Thin slices of a ball's triangles have normals of their own only by rounding.
  const ball = make('icosphere', { radius: 1, levels: 2 });
  const operands = [ball, transform(ball, [{ rotateX: 1e-7 }, { rotateY: 2e-7 }])];
  const { mesh, provenance } = union(...operands);
  const faces = model(mesh, { sources: { provenance, operands } });
  assert.deepEqual([faces.counts.modelFaces, faces.counts.modelEdges, faces.counts.regions], [1, 0, 1]);
});

test('labels and chosen edges part faces', () => {
  const sheet = { ...make('gridSheet', { width: 2, depth: 1, cellsX: 2, cellsY: 1 }), labelNames: ['left', 'right'] };
  const labelled = { ...sheet, faceLabels: Uint32Array.from({ length: sheet.triangles.length / 3 }, (_, t) => (t < 2 ? 0 : 1)) };
  assert.equal(model(labelled).counts.modelFaces, 2);
  assert.equal(model(labelled, { splitAtLabels: false }).counts.modelFaces, 1);
  const { labelNames: _, ...plain } = sheet;
  assert.equal(model(plain, { userEdges: [[1, 4]] }).counts.modelFaces, 2);
});

test('what has no meaning is refused', () => {
  for (const options of [{ faceAngle: 200 }, { faceAngle: '40' }, { seams: 'some' }, { leastDangling: -1 }, { userEdges: [[0, 1, 2]] }, { userEdges: [[0, 7]] }, { splitAtLabels: 1 }, { sources: {} }, { angle: 3 }]) {
    assert.throws(() => model(cube, /** @type {any} */ (options)), { code: 'INVALID_ARGUMENT' }, JSON.stringify(options));
  }
  assert.throws(() => model({ ...cube, triangles: [0, 0, 1] }), { code: 'INVALID_ARGUMENT' });
  assert.throws(() => model(cube).face(6), { code: 'INVALID_ARGUMENT', message: /no face 6: there are 6/ });
});

test('the command prints counts, or all as JSON', (t) => {
  const cwd = temporaryFolder(t);
  assert.equal(run(['make', 'box', '-o', 'box.ply', '--quiet'], { cwd }).code, 0);
  const text = run(['model', 'box.ply'], { cwd }).out;
  assert.match(text, /faces {9}6\n/);
  const json = JSON.parse(run(['model', 'box.ply', '--json'], { cwd }).out);
  assert.deepEqual([json.counts.modelFaces, json.faces.length, json.edges.length, json.vertices.length, json.regions.length], [6, 6, 12, 8, 2]);
  assert.equal(json.edges[0].path.length, 2);
  assert.equal(run(['model', 'box.ply', '--seams', 'odd'], { cwd }).code, 2);
  assert.equal(run(['model'], { cwd }).code, 2);
});
