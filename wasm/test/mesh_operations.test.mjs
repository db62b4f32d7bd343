// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Parts, repair, solids of sheets and sections through the package.

import assert from 'node:assert/strict';
import test from 'node:test';

import * as mortise from 'mortise';

import { cube, meshError, soupOf } from './support.mjs';

/** Several meshes as one, without shared vertices between them. */
function joined(...meshes) {
  let first = 0;
  const triangles = [];
  for (const mesh of meshes) {
    triangles.push(...mesh.triangles.map((v) => v + first));
    first += mesh.positions.length / 3;
  }
  return { positions: Float64Array.from(meshes.flatMap(({ positions }) => [...positions])), triangles: Uint32Array.from(triangles) };
}

/** The same surface, the other way round. */
function insideOut({ positions, triangles }) {
  return { positions, triangles: triangles.map((_, i) => triangles[i - (i % 3) + ((2 * i) % 3)]) };
}

const volumes = async (meshes) => Promise.all(meshes.map(async (mesh) => (await mortise.inspect(mesh)).volume));

test('split gives components, or solids with their cavities', async () => {
  const cavity = insideOut(await mortise.make('box', { lo: [0.25, 0.25, 0.25], hi: [0.75, 0.75, 0.75] }));
  const mesh = joined(cube(), cube(5), cavity);
  assert.deepEqual(await volumes(await mortise.split(mesh)), [1, 1, -0.125]);
  const regions = await mortise.split(mesh, { by: 'regions' });
  assert.deepEqual(await volumes(regions), [0.875, 1]);
  assert.deepEqual([...regions[0].sourceFace], [...Array(12).keys(), ...Array.from({ length: 12 }, (_, i) => 24 + i)]);
  assert.deepEqual([...regions[1].sourceVertex], [8, 9, 10, 11, 12, 13, 14, 15]);
  assert.deepEqual(await mortise.split({ positions: [], triangles: [] }), []);
});

test('split welds a soup and names its vertices', async () => {
  const [part] = await mortise.split(soupOf(cube()), { by: 'regions' });
  assert.deepEqual([part.positions.length, part.triangles.length, part.sourceVertex.length], [24, 36, 8]);
});

test('split refuses what has no regions', async () => {
  const open = cube();
  open.triangles = open.triangles.subarray(3);
  assert.equal((await mortise.split(open)).length, 1);
  const error = await meshError('NOT_CLOSED', () => mortise.split(open, { by: 'regions' }), mortise.MeshError);
  assert.deepEqual([error.details.kind, error.details.ids.length, error.details.places.length], ['vertexPairs', 6, 3]);
  await meshError('INSIDE_OUT', () => mortise.split(insideOut(cube()), { by: 'regions' }), mortise.MeshError);
  await meshError('INVALID_ARGUMENT', () => mortise.split(cube(), { by: 'colour' }), mortise.MeshError);
  await meshError('INVALID_ARGUMENT', () => mortise.split(cube(), { per: 'region' }), mortise.MeshError);
});

test('splitPinches gives bodies that touch along an edge their own vertices', async () => {
  const { mesh } = await mortise.union(cube(), cube(1, 1, 0));
  assert.equal(mesh.positions.length / 3, 14);
  const split = await mortise.splitPinches(mesh);
  assert.equal(split.positions.length / 3, 16);
  assert.deepEqual(new Set(split.shell), new Set([0, 1]));
  split.sourceVertex.forEach((source, v) => {
    assert.deepEqual(split.positions.subarray(3 * v, 3 * v + 3), mesh.positions.subarray(3 * source, 3 * source + 3));
  });
});

test('repair does what is asked, says what it did, and nothing else', async () => {
  const mesh = insideOut(cube());
  mesh.triangles = Uint32Array.from([...mesh.triangles.subarray(3), ...mesh.triangles.subarray(6, 9), 0, 0, 5]);
  assert.deepEqual((await mortise.repair(mesh, {})).done, []);
  assert.deepEqual((await mortise.repair(mesh, {})).mesh.triangles, mesh.triangles);
  const steps = { dropDegenerate: true, dropDuplicates: true, orient: true, fillPlanarHoles: true, cancelOpposites: false };
  const { mesh: repaired, done, sourceFace, sourceVertex } = await mortise.repair(mesh, steps);
  assert.deepEqual(
    done.map(({ step, outcome, count, faces }) => [step, outcome, count, [...faces]]),
    [
      ['dropDegenerate', 'done', 1, [12]],
      ['dropDuplicates', 'done', 1, [11]],
      ['fillPlanarHoles', 'done', 1, done[2] && [...done[2].faces]],
    ],
  );
  assert.equal(done[2].faces.length, 3);
  assert.equal(sourceFace.at(-1), 0xffffffff);
  assert.equal(sourceVertex.length, 8);
  const turned = await mortise.repair(repaired, { flipInsideOut: true });
  assert.deepEqual([(await mortise.inspect(repaired)).volume, (await mortise.inspect(turned.mesh)).volume], [-1, 1]);
});

test('repair reports a one-sided surface', async () => {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1];
  const { done } = await mortise.repair({ positions, triangles: [0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1] }, { orient: true });
  assert.deepEqual(done.map(({ outcome, count }) => [outcome, count]), [['notOrientable', 1]]);
  await meshError('INVALID_ARGUMENT', () => mortise.repair(cube(), { weld: true }), mortise.MeshError);
  await meshError('INVALID_ARGUMENT', () => mortise.repair(cube(), { orient: 'yes' }), mortise.MeshError);
});

test('extrudeTo makes a solid of a heightfield', async () => {
  const sheet = await mortise.make('gridSheet', { width: 3, depth: 2 });
  const report = await mortise.inspect(await mortise.extrudeTo(sheet, { z: -2 }));
  assert.deepEqual([report.closed, report.oriented, report.selfIntersections, report.volume], [true, true, 0, 12]);
  const error = await meshError('INVALID_ARGUMENT', () => mortise.extrudeTo(cube(), { z: -2 }), mortise.MeshError);
  assert.equal(error.details.kind, 'faces');
  await meshError('INVALID_ARGUMENT', () => mortise.extrudeTo(sheet, { z: 0 }), mortise.MeshError);
  await meshError('INVALID_ARGUMENT', () => mortise.extrudeTo(sheet, {}), mortise.MeshError);
});

test('slice gives closed polygons with the inside on their left', async () => {
  const cavity = insideOut(await mortise.make('box', { lo: [0.25, 0.25, 0.25], hi: [0.75, 0.75, 0.75] }));
  const section = await mortise.slice(joined(cube(), cavity), { plane: [0, 0, 1, 0.5] });
  assert.deepEqual([section.polygons.length, [...section.areas], section.area], [2, [1, -0.25], 0.75]);
  const [outline] = section.polygons;
  let twiceArea = 0;
  for (let i = 0, j = outline.length - 3; i < outline.length; j = i, i += 3) {
    assert.equal(outline[i + 2], 0.5);
    twiceArea += outline[j] * outline[i + 1] - outline[i] * outline[j + 1];
  }
  assert.equal(twiceArea, 2);
  assert.equal((await mortise.slice(cube(), { plane: [0, 0, 1, 1] })).area, 1);
  assert.equal((await mortise.slice(cube(), { plane: [0, 0, 1, 0] })).area, 0);
});

test('slice refuses open meshes and planes that are none', async () => {
  const open = cube();
  open.triangles = open.triangles.subarray(3);
  await meshError('NOT_CLOSED', () => mortise.slice(open, { plane: [0, 0, 1, 0.5] }), mortise.MeshError);
  for (const plane of [undefined, [0, 0, 1], [0, 0, 0, 1], [0, 0, NaN, 1], [0, 0, '1', 1], '0,0,1,1']) {
    await meshError('INVALID_ARGUMENT', () => mortise.slice(cube(), { plane }), mortise.MeshError);
  }
});
