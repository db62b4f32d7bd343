// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sheets, walls and half-spaces as operands.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { combine, intersect, make, MeshError, partition, subtract, transform, union } from 'mortise';

const box = await make('box');
const sheet = await transform(await make('gridSheet', { width: 3, depth: 3, cellsX: 2, cellsY: 2 }), [{ translate: [-1, -1, 0.25] }]);

test('a sheet is trimmed by a solid, in any order', async () => {
  for (const operands of [[sheet, box], [box, sheet]]) {
    const { mesh, report } = await intersect(operands);
    assert.equal(report.area, 1);
    assert.equal(report.closed, false);
    assert.equal(report.volume, null);
    assert.equal(report.certified, true);
    assert.deepEqual(report.operands.map(({ kind }) => kind).sort(), ['sheet', 'solid']);
    assert.ok(mesh.walls.every((wall) => wall === 1));
  }
  assert.equal((await subtract(sheet, box)).report.area, 8);
  const both = await union(box, sheet);
  assert.equal(both.report.area, 14);
  assert.deepEqual(both.report.regions.map(({ volume }) => volume), [1]);
});

test('open edges are named in the report and its notes', async () => {
  const { report } = await union(box, sheet);
  const [solid, open] = report.operands;
  assert.equal(solid.openEdges, undefined);
  assert.equal(open.openEdges.length, 16);
  assert.ok(report.notes.some((note) => note === 'operand 1 is a sheet: it has 8 open edges'));
  await assert.rejects(union(box, sheet, { kind: 'solid' }), { code: 'NOT_CLOSED' });
  await assert.rejects(union(box, sheet, { kind: 'sheet' }), { code: 'INVALID_ARGUMENT' });
});

test('a sheet divides a solid, and cuts it', async () => {
  const halves = await partition(box, sheet);
  assert.deepEqual(halves.report.regions.map(({ volume }) => volume).sort(), [0.25, 0.75]);
  assert.equal((await subtract(box, sheet)).report.volume, 0.75);
  const short = await transform(sheet, [{ translate: [-1.5, 0, 0] }]);
  const { report } = await subtract(box, short);
  assert.equal(report.volume, 1);
  assert.ok(report.notes.some((note) => note.startsWith('sheet operand 1 ends inside the solid')));
});

test('a partition is an operand', async () => {
  const other = await transform(box, [{ translate: [0.5, 0.5, 0.5] }]);
  const once = await partition(box, other);
  const twice = await partition(once.mesh);
  assert.deepEqual(twice.mesh.positions, once.mesh.positions);
  assert.equal(twice.report.triangles, once.report.triangles);
  assert.deepEqual(twice.report.regions.map(({ volume }) => volume), once.report.regions.map(({ volume }) => volume));
  assert.equal((await union(once.mesh)).report.volume, (await union(box, other)).report.volume);
  const moved = await transform(once.mesh, [{ translate: [1, 2, 3] }]);
  assert.deepEqual(moved.walls, once.mesh.walls);
  await assert.rejects(union({ ...box, walls: new Uint8Array(3) }), { code: 'INVALID_ARGUMENT' });
});

test('half-spaces', async () => {
  assert.equal((await intersect(box, { plane: [0, 0, 1, 0.25] })).report.volume, 0.25);
  const { report } = await subtract([box, { plane: [0, 0, 1, 0.25] }, { plane: [0, 0, -2, -1.5] }]);
  assert.equal(report.volume, 0.5);
  assert.deepEqual(report.operands.map(({ kind }) => kind), ['solid', 'halfSpace', 'halfSpace']);
  assert.equal((await combine('a & !b', [box, { plane: [1, 0, 0, 0.5] }])).report.volume, 0.5);
  assert.deepEqual((await partition(box, { plane: [1, 0, 0, 0.25] })).report.regions.map(({ volume }) => volume).sort(), [0.25, 0.75]);
  await assert.rejects(union(box, { plane: [1, 0, 0, 0.5] }), (error) => error instanceof MeshError && error.code === 'INVALID_ARGUMENT' && /infinity/.test(error.message));
  await assert.rejects(intersect(box, { plane: [0, 0, 0, 1] }), { code: 'INVALID_ARGUMENT' });
  await assert.rejects(intersect(box, { plane: [0, 0, 1] }), { code: 'INVALID_ARGUMENT' });
  await assert.rejects(intersect({ plane: [0, 0, 1, 1] }), { code: 'INVALID_ARGUMENT' });
});
