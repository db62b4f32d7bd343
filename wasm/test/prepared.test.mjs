// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Prepared operands: the results of meshes, in every place; whose they are, and when they go.

import assert from 'node:assert/strict';
import process from 'node:process';
import test from 'node:test';
import { setTimeout } from 'node:timers/promises';
import v8 from 'node:v8';
import vm from 'node:vm';

import { imprint, intersect, load, make, MeshError, partition, prepare, transform, union } from 'mortise';

import { cube, meshError, soupOf } from './support.mjs';

const refused = (text) => (error) => error instanceof MeshError && error.code === 'INVALID_ARGUMENT' && error.message.includes(text);

/** Numbers between -1 and 1, the same in every run. */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
}

/** Steps of every kind. */
function randomSteps(random) {
  const steps = [{ rotateX: 180 * random() }, { rotateZ: 180 * random() }, { translate: [random(), random(), random()] }];
  if (random() > 0.5) steps.unshift({ scale: [1 + 0.5 * random(), 1 + 0.5 * random(), 1] });
  if (random() > 0.5) steps.unshift({ mirror: 'y' });
  return steps;
}

/** A result without what is measured by the clock. */
function lasting({ report, ...rest }) {
  return { ...rest, report: { ...report, milliseconds: 0, stages: report.stages.length } };
}

test('500 places give the same bits as calls with meshes', async () => {
  const m = await load();
  const host = m.make('icosphere', { levels: 2 });
  const torus = m.make('torus', { majorRadius: 0.6, minorRadius: 0.2, around: 12, across: 8 });
  const [preparedHost, prepared] = [m.prepare(host), m.prepare(torus)];
  const operations = ['union', 'intersect', 'subtract', 'partition', 'imprint'];
  const random = randomNumbers(1);
  for (let i = 0; i < 500; ++i) {
    const steps = randomSteps(random);
    const operation = operations[i % operations.length];
    const fresh = m[operation](host, m.transform(torus, steps), { inspect: false });
    assert.deepEqual(lasting(m[operation](preparedHost, prepared.at(steps), { inspect: false })), lasting(fresh), `${operation} in place ${i}`);
  }
  preparedHost.dispose();
  prepared.dispose();
});

test('soups, sheets, labels and half-spaces are prepared as they are', async () => {
  const sheet = await make('gridSheet', { width: 3, depth: 3 });
  const labelled = { ...cube(), faceLabels: new Uint32Array(12).fill(1), labelNames: ['a', 'b'] };
  for (const mesh of [soupOf(cube()), sheet, labelled, { positions: Float32Array.from(cube().positions), triangles: cube().triangles }]) {
    const prepared = await prepare(mesh);
    const steps = [{ rotateY: 30 }, { translate: [0.25, 0.25, 0.5] }];
    const moved = await transform(mesh, steps);
    assert.deepEqual(lasting(await partition(prepared.at(steps), cube())), lasting(await partition(moved, cube())));
    assert.deepEqual(lasting(await partition([prepared, { plane: [1, 2, 3, 0.5] }])), lasting(await partition([mesh, { plane: [1, 2, 3, 0.5] }])));
    assert.deepEqual([prepared.vertices, prepared.triangles], [mesh.positions.length / 3, (mesh.triangles?.length ?? mesh.positions.length / 3) / 3]);
    prepared.dispose();
  }
});

test('a matrix is a step, column after column as in three.js', async () => {
  const matrix = [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1];
  const moved = await transform(cube(), [{ matrix }]);
  assert.deepEqual(moved, await transform(cube(), [{ rotateZ: 90 }, { scale: 2 }, { translate: [5, 6, 7] }]));
  assert.deepEqual(moved, await transform(cube(), [{ matrix: Float32Array.from(matrix) }]));
  const prepared = await prepare(cube());
  assert.deepEqual((await union(prepared.at([{ matrix }]))).mesh, (await union(moved)).mesh);
  await assert.rejects(() => transform(cube(), [{ matrix: matrix.slice(1) }]), refused('steps[0]'));
  await assert.rejects(() => transform(cube(), [{ matrix: [...matrix.slice(0, 15), 2] }]), refused('last row'));
  prepared.dispose();
});

test('places without an inverse are refused, naming the operand', async () => {
  const prepared = await prepare(cube());
  const error = await meshError('INVALID_ARGUMENT', () => union(cube(), prepared.at([{ scale: [1, 1, 0] }])), MeshError);
  assert.equal(error.details.operand, 1);
  const far = await meshError('OUT_OF_RANGE', () => union(cube(), prepared.at([{ scale: 1e308 }, { translate: [1e308, 0, 0] }])), MeshError);
  assert.deepEqual([far.details.operand, far.details.kind], [1, 'vertices']);
  assert.throws(() => prepared.at([{ turn: 3 }]), refused('steps[0]'));
  assert.throws(() => prepared.at(), refused('array of steps'));
  prepared.dispose();
});

test('what is no mesh is not prepared', async () => {
  await meshError('INVALID_ARGUMENT', () => prepare({ plane: [1, 0, 0, 0] }), MeshError);
  await meshError('NOT_FINITE', () => prepare({ positions: [0, 0, NaN], triangles: [] }), MeshError);
  const error = await meshError('BAD_INDEX', () => prepare({ ...cube(), triangles: Uint32Array.of(0, 1, 99) }), MeshError);
  assert.deepEqual(error.details.ids, [0]);
});

test('a disposed operand is refused, and disposing twice is fine', async () => {
  const prepared = await prepare(cube());
  const placed = prepared.at([{ translate: [0.5, 0, 0] }]);
  assert.equal((await union(prepared, placed)).report.volume, 1.5);
  prepared.dispose();
  prepared.dispose();
  await assert.rejects(() => union(cube(), prepared), refused('operand 1 was disposed of'));
  await assert.rejects(() => union(placed, cube()), refused('operand 0 was disposed of'));
});

test('Symbol.dispose is dispose', async () => {
  const prepared = await prepare(cube());
  prepared[Symbol.dispose]();
  await assert.rejects(() => union(prepared), refused('disposed'));
});

test('options may follow prepared operands', async () => {
  const prepared = await prepare(cube());
  const { report } = await union(prepared, prepared.at([{ translate: [0.5, 0, 0] }]), { inspect: false });
  assert.deepEqual([report.volume, report.selfIntersections], [1.5, null]);
  assert.equal((await intersect([prepared, cube(0.5)], { inspect: false })).report.volume, 0.5);
  assert.equal((await imprint(prepared, cube(1))).operands.length, 2);
  prepared.dispose();
});

test('a listener that disposes of an operand disturbs nothing', async () => {
  const prepared = await prepare(await make('icosphere', { levels: 3 }));
  const expected = (await union(prepared, cube())).mesh;
  const { mesh } = await union(prepared, cube(), { onProgress: () => prepared.dispose() });
  assert.deepEqual(mesh, expected);
});

test('prepared operands outlive other calls and the growth of the memory', async () => {
  const m = await load();
  const prepared = m.prepare(cube());
  const before = m.union(prepared, cube(0.5)).mesh;
  const ball = m.make('icosphere', { levels: 7 });
  m.union(ball, m.transform(ball, [{ translate: [3, 0, 0] }]), { inspect: false });
  assert.deepEqual(m.union(prepared, cube(0.5)).mesh, before);
  prepared.dispose();
});

test('disposed and forgotten operands leave no memory behind', async () => {
  v8.setFlagsFromString('--expose-gc');
  const collect = vm.runInNewContext('gc');
  const m = await load();
  const ball = m.make('icosphere', { levels: 5 });
  const prepareMany = () => {
    for (let i = 0; i < 60; ++i) m.prepare(ball).dispose();
    for (let i = 0; i < 60; ++i) m.prepare(ball);
  };
  prepareMany();
  const before = process.memoryUsage().rss;
  for (let round = 0; round < 5; ++round) {
    collect();
    await setTimeout(1);
    prepareMany();
  }
  const grown = process.memoryUsage().rss - before;
  assert.ok(grown < 3e8, `600 operands of 20,480 triangles took ${grown} bytes more than 120`);
});
