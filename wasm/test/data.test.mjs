// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex and corner data, and groups, through the package.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import test from 'node:test';

import * as mortise from 'mortise';

import { cube, meshError, run, soupOf, temporaryFolder } from './support.mjs';

const { readMesh, writeMesh, union, subtract, imprint, split, transform, cornersToVertices, groupByLabel, make, MeshError } = mortise;

/** The mesh with two linear functions of the position as `uv`. */
function charted(mesh) {
  const values = [];
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.subarray(i, i + 3);
    values.push(0.5 * x + 0.25 * y - z, 2 * x + y + 0.125 * z);
  }
  return { ...mesh, vertexData: { uv: { components: 2, values } } };
}

/** The largest difference between `uv` of corners and the chart. */
function deviation({ positions, triangles, cornerData }) {
  const expected = charted({ positions }).vertexData.uv.values;
  return Math.max(...Array.from(triangles, (v, corner) => [0, 1].map((k) => Math.abs(cornerData.uv.values[2 * corner + k] - expected[2 * v + k]))).flat());
}

const turned = (mesh) => transform(mesh, [{ rotateX: 33 }, { rotateZ: 12 }, { translate: [0.3, 0.2, 0.1] }]);

/** The mesh with the normals of its triangles at their corners. */
function faceted({ positions, triangles }) {
  const values = [];
  const at = (v) => positions.subarray(3 * v, 3 * v + 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => at(triangles[t + i]));
    const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const size = Math.hypot(...n);
    for (let i = 0; i < 3; ++i) values.push(...n.map((x) => x / size));
  }
  return { positions, triangles, cornerData: { normal: { components: 3, values } } };
}

test('a linear chart stays linear across the cut', async () => {
  const a = charted(await turned(await make('box', { lo: [-1, -1, -1], hi: [1, 1, 1] })));
  const b = charted(await make('icosphere', { radius: 1.2, levels: 2 }));
  for (const name of ['union', 'intersect', 'subtract', 'symmetricDifference', 'partition']) {
    const { mesh } = await mortise[name](a, b);
    assert.equal(mesh.vertexData, undefined);
    assert.equal(mesh.cornerData.uv.components, 2);
    assert.equal(mesh.cornerData.uv.kind, undefined);
    assert.ok(mesh.cornerData.uv.values instanceof Float64Array);
    assert.ok(deviation(mesh) < 1e-14, `${name}: ${deviation(mesh)}`);
  }
  const { mesh, operands } = await imprint(a, b);
  for (const each of [mesh, ...operands]) assert.ok(deviation(each) < 1e-14);
});

test('the functions without promises give the same, and results are operands again', async () => {
  const m = await mortise.load();
  const a = charted(cube()), b = charted(cube(0.5, 0.25, 0.125));
  const { mesh } = m.subtract(a, b);
  assert.deepEqual(mesh, (await subtract(a, b)).mesh);
  assert.ok(deviation(m.union(mesh, charted(cube(-0.5))).mesh) < 1e-15);
  assert.ok(deviation((await split(mesh))[0]) < 1e-15);
});

test('data survive a structured clone, as between workers', async () => {
  const { mesh } = await subtract(charted(cube()), cube(0.5, 0.5, 0.5));
  const clone = structuredClone(mesh);
  assert.deepEqual(clone, mesh);
  assert.deepEqual((await union(clone, cube(3))).mesh.cornerData, (await union(mesh, cube(3))).mesh.cornerData);
});

test('an operand without a channel has NaN in the result', async () => {
  const { mesh, provenance } = await subtract(charted(cube()), cube(0.5, 0.5, 0.5));
  mesh.cornerData.uv.values.forEach((x, i) => assert.equal(Number.isNaN(x), provenance.sourceOperand[Math.floor(i / 6)] === 1));
});

test('attributes of three.js are channels; what is called normal turns round with the tool', async () => {
  const tool = faceted(await make('box', { lo: [0.5, 0.5, 0.5], hi: [2, 2, 2] }));
  const { components, values } = tool.cornerData.normal;
  const attribute = { isBufferAttribute: true, itemSize: components, array: Float32Array.from(values), normalized: false };
  const { mesh } = await subtract(faceted(cube()), { ...tool, cornerData: { normal: attribute } });
  const { normal } = mesh.cornerData;
  assert.equal(normal.kind, 'normal');
  const expected = faceted(mesh).cornerData.normal.values;
  normal.values.forEach((x, i) => assert.ok(Math.abs(x - expected[i]) < 1e-15));
  const value = await subtract(cube(), { ...tool, cornerData: { normal: { ...tool.cornerData.normal, kind: 'value' } } });
  assert.equal(value.mesh.cornerData.normal.kind, undefined);
});

test('a soup has data per vertex of its own', async () => {
  const soup = soupOf(cube());
  const values = Array.from({ length: 36 }, (_, i) => Math.floor(i / 6));
  const { mesh, provenance } = await union({ ...soup, vertexData: { side: { components: 1, values } } }, cube(5));
  mesh.cornerData.side.values.forEach((x, corner) => {
    const t = Math.floor(corner / 3);
    assert.ok(provenance.sourceOperand[t] === 1 ? Number.isNaN(x) : x === Math.floor(provenance.sourceFace[t] / 2));
  });
});

test('cornersToVertices copies vertices along seams and fills what is missing', async () => {
  const { mesh } = await subtract(faceted(cube()), cube(0.5, 0.5, 0.5));
  const drawn = await cornersToVertices({ ...mesh, faceLabels: new Uint32Array(mesh.triangles.length / 3) });
  assert.equal(drawn.cornerData, undefined);
  assert.equal(drawn.positions.length / 3, 3 * 4 + 3 * 6 + 3 * 4);
  assert.equal(drawn.sourceVertex.length, drawn.positions.length / 3);
  assert.equal(drawn.faceLabels.length, mesh.triangles.length / 3);
  const { normal } = drawn.vertexData;
  const expected = faceted(drawn).cornerData.normal.values;
  drawn.triangles.forEach((v, corner) => [0, 1, 2].forEach((k) => assert.ok(Math.abs(normal.values[3 * v + k] - expected[3 * corner + k]) < 1e-15)));
  const cut = (await subtract(charted(cube()), cube(0.5, 0.5, 0.5))).mesh;
  assert.ok((await cornersToVertices(cut)).vertexData.uv.values.every((x) => !Number.isNaN(x)));
  assert.ok((await cornersToVertices(cut, { missing: -7 })).vertexData.uv.values.includes(-7));
});

test('groupByLabel gives runs of triangles as three.js draws them', async () => {
  const a = { ...cube(), faceLabels: Uint32Array.from({ length: 12 }, (_, i) => i % 2), labelNames: ['steel', 'copper'] };
  const b = { ...cube(0.5, 0.5, 0.5), faceLabels: new Uint32Array(12), labelNames: ['glass'] };
  const { mesh, provenance } = await subtract(a, b);
  const { groups, triangles, labelNames, sourceFace } = await groupByLabel(mesh);
  assert.deepEqual(groups.map(({ materialIndex }) => labelNames[materialIndex]), ['steel', 'copper', 'glass']);
  let next = 0;
  for (const { start, count, materialIndex } of groups) {
    assert.equal(start, next);
    next += count;
    for (let t = start / 3; t < next / 3; ++t) {
      const operand = [a, b][provenance.sourceOperand[sourceFace[t]]];
      assert.equal(operand.labelNames[operand.faceLabels[provenance.sourceFace[sourceFace[t]]]], labelNames[materialIndex]);
    }
  }
  assert.equal(next, triangles.length);
  assert.deepEqual((await groupByLabel(cube())).groups, [{ start: 0, count: 36, materialIndex: 0 }]);
});

test('OBJ files keep uv and normals, on the command line too', async (t) => {
  const folder = temporaryFolder(t);
  const { cornerData, ...box } = faceted(cube());
  await writeMesh(join(folder, 'a.obj'), { ...charted(box), cornerData });
  await writeMesh(join(folder, 'b.stl'), cube(0.5, 0.5, 0.5));
  assert.equal(run(['subtract', 'a.obj', 'b.stl', '-o', 'c.obj'], { cwd: folder }).code, 0);
  const cut = await readMesh(join(folder, 'c.obj'));
  const { mesh } = await subtract(await readMesh(join(folder, 'a.obj')), await readMesh(join(folder, 'b.stl')));
  assert.deepEqual(Object.keys(cut.cornerData), ['uv', 'normal']);
  assert.deepEqual(cut.cornerData, mesh.cornerData);
  assert.ok(cut.cornerData.uv.values.some(Number.isNaN));
});

test('transform moves vectors and normals along', async () => {
  const values = Array.from({ length: 24 }, (_, i) => [0, 0, 1][i % 3]);
  const data = { n: { components: 3, values, kind: 'normal' }, v: { components: 3, values, kind: 'vector' }, x: { components: 3, values } };
  const { vertexData } = await transform({ ...cube(), vertexData: data }, [{ scale: [1, 1, 4] }, { rotateX: 90 }]);
  const first = (name) => [...vertexData[name].values.subarray(0, 3)];
  assert.deepEqual([first('n'), first('v'), first('x')], [[0, -1, 0], [0, -4, 0], [0, 0, 1]]);
  assert.deepEqual([vertexData.n.kind, vertexData.v.kind, vertexData.x.kind], ['normal', 'vector', undefined]);
});

test('wrong data are errors that name the channel', async () => {
  const wrong = [
    [{ vertexData: 5 }, /operand 1\.vertexData must be an object of channels/],
    [{ vertexData: { uv: 5 } }, /operand 1\.vertexData\.uv must be \{components, values\}, not number 5/],
    [{ vertexData: { uv: { components: 0, values: [] } } }, /vertexData\.uv\.components must be a positive integer/],
    [{ cornerData: { uv: { components: 2, values: 'x' } } }, /cornerData\.uv\.values must be a Float64Array/],
    [{ cornerData: { uv: { components: 2, values: [1, null] } } }, /cornerData\.uv\.values\[1\] must be a number, NaN for no value, not null/],
    [{ cornerData: { uv: { components: 2, values: [1, 2] } } }, /cornerData\.uv has 2 values for 36 places of 2 components/],
    [{ vertexData: { uv: { itemSize: 2, array: new Float32Array(16), isInterleavedBufferAttribute: true } } }, /interleaved or normalized/],
    [{ vertexData: { n: { components: 3, values: new Float64Array(24), kind: 'colour' } } }, /vertexData\.n\.kind is one of value, vector, normal/],
    [{ vertexData: { n: { components: 1, values: new Float64Array(8), kind: 'normal' } } }, /channel 'n' holds vectors or normals: they have 3 components/],
    [{ vertexData: { h: { components: 1, values: new Float64Array(8).fill(Infinity) } } }, /channel 'h' has an infinite value/],
    [{ vertexData: { h: { components: 1, values: new Float64Array(8) } }, cornerData: { h: { components: 1, values: new Float64Array(36) } } }, /two data channels have the name 'h'/],
  ];
  for (const [data, message] of wrong) {
    const error = await meshError('INVALID_ARGUMENT', () => union(cube(), { ...cube(5), ...data }), MeshError);
    assert.match(error.message, message);
  }
  const two = { ...cube(5), vertexData: { uv: { components: 2, values: new Float64Array(16) } } };
  const one = { ...cube(), vertexData: { uv: { components: 1, values: new Float64Array(8) } } };
  const error = await meshError('INVALID_ARGUMENT', () => union(one, two), MeshError);
  assert.match(error.message, /channel 'uv' has 2 components here and 1 in an operand before/);
  assert.equal(error.details.operand, 1);
  await meshError('INVALID_ARGUMENT', () => cornersToVertices(cube(), { missing: 'none' }), MeshError);
});
