// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes that nearly touch are made to share; the budget for contacts.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { MeshError, imprint, load, partition, union } from 'mortise';

import { cube, meshError, run, temporaryFolder } from './support.mjs';

const gap = 1e-9;
const near = [cube(), cube(1 + gap, 0, gap), cube(0, 1 - gap, -gap)];

test('cubes that nearly touch are one solid, and regions that conform', async () => {
  const { report } = await union(near, { tolerance: 1e-8 });
  assert.equal(report.regions.length, 1);
  assert.ok(report.certified && Math.abs(report.volume - 3) < 1e-7);
  const { movedVertices, largestMove, collapsed, unresolved } = report.tolerance;
  assert.ok(movedVertices > 0 && largestMove > 0 && largestMove <= 1e-8);
  assert.deepEqual([collapsed, unresolved], [[], []]);
  const parts = await partition(near, { tolerance: 1e-8 });
  assert.equal(parts.report.regions.length, 3);
  assert.equal(parts.mesh.triangles.length / 3, 16 * 2);
  const { operands } = await imprint(near, { tolerance: 1e-8 });
  const shared = operands[0].facetIds.filter((id) => operands[1].facetIds.includes(id));
  assert.equal(shared.length, 2);
  for (const { movedInputVertices } of [report.certificate]) {
    for (const { operand, vertex } of movedInputVertices) assert.ok(operand < 3 && vertex < 8);
  }
});

test('without a tolerance nothing is shared, and the report says so', async () => {
  const { report } = await union(near);
  assert.equal(report.tolerance, null);
  assert.equal(report.regions.length, 2); // the second one is a gap away, the third overlaps the first
});

test('a part thinner than the tolerance vanishes, and is named', async () => {
  const plate = cube();
  for (let i = 2; i < plate.positions.length; i += 3) plate.positions[i] *= 1e-4;
  const { report } = await union(cube(), plate, { tolerance: 1e-3 });
  assert.equal(report.volume, 1);
  assert.equal(report.tolerance.collapsed.length, 8);
  assert.ok(report.tolerance.collapsed.every(({ operand }) => operand === 1));
  assert.ok(report.notes.includes('operand 1 is thinner than the tolerance and vanished'));
});

test('a tolerance is a length, a budget a number of bytes', async () => {
  for (const tolerance of [-1, NaN, Infinity, '1e-9', null]) await meshError('INVALID_ARGUMENT', () => union(near, { tolerance }), MeshError);
  for (const contactMemory of [-1, 2 ** 31, NaN, '1']) await meshError('INVALID_ARGUMENT', () => union(near, { contactMemory }), MeshError);
  await meshError('RESULT_TOO_LARGE', () => union(near, { contactMemory: 8 }), MeshError);
  assert.equal((await union(near, { contactMemory: 2 ** 20 })).report.triangles, (await union(near)).report.triangles);
});

test('errors about shared operands name places of those given', async () => {
  const open = cube();
  const triangles = open.triangles.slice(3);
  const error = await meshError('NOT_CLOSED', () => union(cube(1 + gap, 0, 0), { ...open, triangles }, { tolerance: 1e-8, kind: 'solid' }), MeshError);
  assert.equal(error.details.operand, 1);
  assert.deepEqual([...error.details.ids].sort(), [0, 0, 2, 2, 3, 3]);
  assert.equal(error.details.places.length, 3);
});

test('the command shares as well', async (t) => {
  const mortise = await load();
  const cwd = temporaryFolder(t);
  near.forEach((mesh, i) => mortise.writeMesh(join(cwd, `${i}.ply`), mesh));
  const files = ['0.ply', '1.ply', '2.ply'];
  const json = JSON.parse(run(['union', ...files, '--tolerance', '1e-8', '-o', 'out.ply', '--json'], { cwd }).out);
  assert.equal(json.regions.length, 1);
  assert.ok(json.tolerance.movedVertices > 0);
  assert.match(run(['union', ...files, '--tolerance', '1e-8', '-o', 'out.ply'], { cwd }).out, /tolerance +\d+ vertices moved by at most [\d.e-]+, 0 made, 0 faces collapsed, 0 unresolved/);
  const imprinted = run(['imprint', ...files, '--tolerance', '1e-8', '--certify', 'absolute', '--kind', 'solid', '-o', 'out-%d.ply', '--json'], { cwd });
  assert.equal(imprinted.code, 0, imprinted.err);
  assert.equal(JSON.parse(imprinted.out).certificate.level, 'absolute');
  assert.equal(run(['union', ...files, '--tolerance', 'near', '-o', 'out.ply'], { cwd }).code, 2);
});
