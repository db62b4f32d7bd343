// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Symmetric differences, partitions, expressions and tags as a program calls them.

import assert from 'node:assert/strict';
import test from 'node:test';

import { combine, keep, load, MeshError, partition, symmetricDifference, union } from 'mortise';

import { cube } from './support.mjs';

const refused = (text) => (error) => error instanceof MeshError && error.code === 'INVALID_ARGUMENT' && error.message.includes(text);

test('a symmetric difference is what lies in an odd number of operands', async () => {
  assert.equal((await symmetricDifference(cube(), cube(0.5, 0.5, 0.5))).report.volume, 1.75);
  assert.equal((await symmetricDifference([cube(), cube(0.5), cube(0.25)])).report.volume, 1);
  const { mesh, report } = await symmetricDifference(cube(), cube());
  assert.equal(mesh.triangles.length, 0);
  assert.equal(report.certified, true);
});

test('a partition names the regions on both sides of every face', async () => {
  const { report, provenance } = await partition(cube(), cube(0.5, 0.5, 0.5));
  assert.deepEqual(report.regions.map(({ operands, volume }) => [operands.join(), volume]).sort(), [['0', 0.875], ['0,1', 0.125], ['1', 0.875]]);
  assert.equal(report.volume, 1.875);
  assert.equal(report.closed, true);
  assert.equal(report.certified, true);
  const { regionLeft, regionRight, coveringSets, covering, coveringFront } = provenance;
  for (let f = 0; f < regionLeft.length; ++f) {
    assert.notEqual(regionLeft[f], 0);
    assert.notEqual(regionLeft[f], regionRight[f]);
    assert.deepEqual([...coveringSets[covering[f]]], report.regions[regionLeft[f] - 1].operands);
    assert.deepEqual([...coveringSets[coveringFront[f]]], regionRight[f] === 0 ? [] : report.regions[regionRight[f] - 1].operands);
  }
});

test('cubes that share a face have it once between two regions', async () => {
  const { report, provenance } = await partition(cube(), cube(1));
  assert.equal(report.regions.length, 2);
  assert.equal(report.area, 11);
  const inner = [...provenance.regionRight].flatMap((region, f) => (region === 0 ? [] : [f]));
  assert.ok(inner.length >= 2);
  for (const f of inner) assert.equal(provenance.otherSourceBegin[f + 1] - provenance.otherSourceBegin[f], 1);
});

test('booleans have nothing in front of their faces, and no second covering', async () => {
  const { provenance } = await union(cube(), cube(0.5));
  assert.ok(provenance.regionRight.every((region) => region === 0));
  assert.equal(provenance.coveringFront, undefined);
});

test('an expression is evaluated over all operands at once', async () => {
  const operands = [cube(), cube(0.5), cube(0.25)];
  assert.equal((await combine('(a | b) & !c', operands)).report.volume, 0.5);
  assert.equal((await combine('#0 - #1', operands, { inspect: false })).report.volume, 0.5);
  const mortise = await load();
  assert.deepEqual(mortise.combine('a|b|c', operands).mesh, mortise.union(operands).mesh);
});

test('wrong expressions are refused with their column', async () => {
  await assert.rejects(combine('a | | b', [cube(), cube(1)]), refused('column 5'));
  await assert.rejects(combine('a | c', [cube(), cube(1)]), refused('column 5'));
  await assert.rejects(combine('!a', [cube()]), refused('infinity'));
  await assert.rejects(combine(cube(), cube(1)), refused('expression'));
  await assert.rejects(combine('a', cube()), refused('array of meshes'));
  await assert.rejects(combine('a', []), refused('at least one mesh'));
});

test('faces are kept by tags', async () => {
  const operands = [cube(), cube(0.5, 0.5, 0.5)];
  const open = await keep(['10'], operands);
  assert.equal(open.report.closed, false);
  assert.equal(open.report.area, 5.25);
  assert.equal(open.report.certified, true);
  assert.deepEqual(open.report.regions, []);
  assert.equal((await keep(['11', '21'], operands)).report.volume, 0.125);
  assert.equal((await keep(['opposite'], [cube(), cube(1)])).report.area, 1);
  assert.equal((await keep([], operands)).mesh.triangles.length, 0);
  await assert.rejects(keep(['12'], operands), refused("'12'"));
  await assert.rejects(keep('10', operands), refused('array of tags'));
});
