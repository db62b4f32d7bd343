// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the cut left is taken out again.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { imprint, load, make, partition, resolve, subtract, transform, union } from 'mortise';

const box = (lo, hi) => make('box', { lo, hi });
const countOf = ({ report }) => [report.vertices, report.triangles];

test('flush boxes lose the cut, or become one box', async () => {
  const operands = [await box([0, 0, 0], [1, 1, 1]), await box([0.5, 0, 0], [1.5, 1, 1])];
  assert.deepEqual(countOf(await union(operands)), [24, 44]);
  assert.deepEqual(countOf(await union(operands, { simplify: 'off' })), [24, 44]);
  assert.deepEqual(countOf(await union(operands, { simplify: 'cut' })), [16, 28]);
  const one = await union(operands, { simplify: 'coplanar' });
  assert.deepEqual(countOf(one), [8, 12]);
  assert.equal(one.report.volume, 1.5);
  assert.equal(one.report.certified, true);
  assert.equal(one.report.contact.area, 0.5 * 4);
  assert.ok(one.report.stages.some(({ stage }) => stage === 'simplify'));
  const regions = (await partition(operands, { simplify: 'coplanar' })).report.regions;
  assert.deepEqual(regions.map(({ volume }) => volume), [0.5, 0.5, 0.5]);
});

test('1,000 touching cubes become 12 triangles, in a call without waiting too', async () => {
  const mortise = await load();
  const cubes = [];
  for (let i = 0; i < 1000; ++i) {
    const lo = [i % 10, Math.floor(i / 10) % 10, Math.floor(i / 100)];
    cubes.push(mortise.make('box', { lo, hi: lo.map((x) => x + 1) }));
  }
  const { report } = mortise.union(cubes, { simplify: 'coplanar' });
  assert.deepEqual([report.vertices, report.triangles, report.volume], [8, 12, 1000]);
});

test('a chain of drills grows by the holes alone', async () => {
  const drill = await make('cylinder', { radius: 0.3, height: 3, around: 12 });
  let plate = await box([0, 0, 0], [10, 1, 1]);
  for (let k = 1; k <= 8; ++k) {
    const result = await subtract(plate, await transform(drill, [{ translate: [0.6 + 1.1 * k, 0.47, -1] }]), { simplify: 'coplanar' });
    assert.deepEqual([...countOf(result), result.report.genus], [8 + 24 * k, 2 * (8 + 24 * k) + 4 * k - 4, k]);
    plate = result.mesh;
  }
});

test('one mesh is simplified as a whole; an imprint and other words are refused', async () => {
  const sheet = await make('gridSheet', { width: 3, depth: 3, cellsX: 5, cellsY: 5 });
  assert.deepEqual(countOf(await resolve(sheet, { simplify: 'coplanar' })), [4, 2]);
  await assert.rejects(imprint(sheet, await box([0, 0, 0], [1, 1, 1]), { simplify: 'cut' }), { code: 'INVALID_ARGUMENT' });
  await assert.rejects(union(sheet, sheet, { simplify: true }), { code: 'INVALID_ARGUMENT' });
});
