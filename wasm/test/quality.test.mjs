// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good triangles are for sizes: marks worked out by hand, remeshed results against what they came from, what is refused, the command.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import test from 'node:test';

import { load, make, MeshError, quality, remesh, sizing, transform, union } from 'mortise';

import { cube, meshError, run, soupOf, temporaryFolder } from './support.mjs';

const close = (found, expected, within = 1e-9) => assert.ok(Math.abs(found - expected) <= within * Math.max(1, Math.abs(expected)), `${found} instead of ${expected}`);

test('the triangles of a cube are half squares', async () => {
  const report = await quality(cube(), { size: 1 });
  const { all, free, edges, freeEdges, obstacles, valences, folds, deviation, table } = report;
  assert.deepEqual([all.count, all.below30, all.above115, free.count], [12, 0, 0, 12]);
  close(all.minAngleDeg, 45);
  close(all.maxAngleDeg, 90);
  close(all.medianAngleDeg, 45);
  close(all.minRadiusRatio, 2 * (Math.SQRT2 - 1));
  close(all.meanEdgeRatio, Math.SQRT2);
  close(all.maxGrowth, 1);
  assert.equal(edges.count, 18);
  close(edges.mean, (12 + 6 * Math.SQRT2) / 18);
  assert.deepEqual([edges.min, edges.bins.length, edges.bins[4], edges.bins.reduce((sum, n) => sum + n)], [1, 9, 12, 18]);
  assert.deepEqual([freeEdges, free], [edges, all]);
  assert.deepEqual([obstacles, valences, folds, deviation], [{ shortEdges: 0, sharpCorners: 0, closeFeatures: 0 }, new Array(13).fill(0), 0, null]);
  assert.match(table, /^largest angle, degrees +90\.00 +90\.00$/m);
  assert.deepEqual(await quality(soupOf(cube()), { size: 1 }), report, 'vertices at one place are one');
});

test('small features keep triangles from being free', async () => {
  const plate = await make('box', { lo: [0, 0, 0], hi: [4, 4, 0.5] });
  const { all, free, obstacles } = await quality(plate, { size: 1 });
  assert.deepEqual([all.count, free.count], [12, 0]);
  assert.ok(obstacles.shortEdges === 4 && obstacles.closeFeatures > 0, JSON.stringify(obstacles));
  assert.equal((await quality(plate, { size: 0.25 })).free.count, 12);
});

test('sizes are said in any way', async () => {
  const sources = [{ type: 'point', at: [0, 0, 0], size: 0.5, growth: 1.5 }];
  const made = await sizing({ size: 2, sources });
  assert.deepEqual(await quality(cube(), { sizing: made }), await quality(cube(), { size: 2, sources }));
  made.dispose();
});

test('a remeshed mesh is judged on its own model and against the mesh it came from', async () => {
  const tube = await make('cylinder', { radius: 1, height: 2, around: 64 });
  const fine = await remesh(tube, { size: 0.2 });
  const { all, free, edges, folds, deviation, table } = await quality(fine, { size: 0.2, reference: tube });
  assert.deepEqual([all.count, free.count, folds], [fine.after.triangles, fine.after.triangles, 0]);
  assert.deepEqual([all.minAngleDeg, all.maxAngleDeg], [fine.after.minAngleDeg, fine.after.maxAngleDeg]);
  assert.ok(all.minAngleDeg > 30 && edges.inBand > 0.98);
  assert.equal(deviation.byFace.length, 3);
  for (const { to, from } of deviation.byFace) assert.ok(to <= deviation.toReference.inSizes && from <= deviation.fromReference.inSizes);
  assert.ok(deviation.toReference.inSizes > 1e-4 && deviation.toReference.inSizes < 0.05, `${deviation.toReference.inSizes}`);
  close(deviation.toReference.max, 0.2 * deviation.toReference.inSizes);
  assert.ok(deviation.curvesToReference.inSizes < 1e-9);
  assert.match(table, /^ {2}model edges to the reference +/m);
  const byAngles = await quality(fine.mesh, { size: 0.2, reference: tube });
  assert.deepEqual([byAngles.all, byAngles.deviation.byFace], [all, null]);
});

test('a remeshed result is compared with the result, creases of its operands and all', async () => {
  const tube = await make('cylinder', { radius: 0.5, height: 2, around: 32 });
  const upright = await transform(tube, [{ translate: [0, 0, -1] }]);
  const operands = [upright, await transform(upright, [{ rotateX: 90 }])];
  const result = await union(operands, { inspect: false });
  const fine = await remesh(result, { operands, size: 0.12 });
  const { deviation, free } = await quality(fine, { size: 0.12, reference: result, operands });
  assert.equal(deviation.byFace.length, new Set(fine.modelFaces).size);
  // Where the two tubes touch their crease fades away below 40 degrees: it is no model edge there, and is cut off a little.
  assert.ok(free.minAngleDeg > 30 && deviation.toReference.inSizes < 0.2 && deviation.fromReference.inSizes < 0.2);
});

test('a plane moved along its normal is that far away, both ways', async () => {
  const sheet = await make('gridSheet', { width: 2, depth: 2, cellsX: 4, cellsY: 4 });
  const above = await transform(sheet, [{ translate: [0, 0, 0.25] }]);
  const { deviation } = await quality(sheet, { size: 0.5, reference: above });
  for (const way of ['toReference', 'fromReference', 'curvesToReference', 'curvesFromReference']) {
    close(deviation[way].max, 0.25);
    close(deviation[way].inSizes, 0.5);
    assert.equal(deviation[way].at.length, 3);
  }
});

test('meshes without triangles have empty reports', async () => {
  const { all, free, edges } = await quality({ positions: [], triangles: [] }, { size: 1 });
  assert.deepEqual([all, all.count, edges.count], [free, 0, 0]);
});

test('what means nothing is refused by name', async () => {
  const fine = await remesh(cube(), { size: 0.5 });
  const result = await union(cube(), cube(0.5));
  const refused = [
    [cube(), undefined, /^size must be a positive number/],
    [cube(), { size: 1, rounds: 3 }, /unknown option 'rounds'/],
    [cube(), { size: 1, curveAngle: 200 }, /curveAngle must be an angle/],
    [cube(), { size: 1, operands: [cube()] }, /operands are those of a reference that is a result/],
    [cube(), { size: 1, reference: result }, /mesh is a result: say what it was made from/],
    [cube(), { size: 1, reference: 5 }, /mesh must be/],
    [{ ...fine, modelFaces: new Uint32Array(3) }, { size: 1 }, /modelFaces must be those of a remeshed mesh of \d+ triangles/],
    [{ ...fine, modelEdges: [0] }, { size: 1 }, /userEdges must be pairs of vertices/],
    [{ ...fine, modelFaces: fine.modelFaces.map((face) => face + 1) }, { size: 1, reference: cube() }, /modelFaces are not faces of the model of the reference/],
  ];
  for (const [mesh, options, message] of refused) assert.match((await meshError('INVALID_ARGUMENT', () => quality(mesh, options), MeshError)).message, message);
  await meshError('BAD_INDEX', () => quality(cube(), { size: 1, reference: { positions: [0, 0, 0], triangles: [0, 0, 7] } }), MeshError);
});

test('the command prints the table, or the report as JSON', async (t) => {
  const cwd = temporaryFolder(t);
  const mortise = await load();
  const fine = mortise.remesh(cube(), { size: 0.25 });
  mortise.writeMesh(join(cwd, 'cube.ply'), cube());
  mortise.writeMesh(join(cwd, 'fine.ply'), fine.mesh);
  const { table, ...report } = mortise.quality(fine.mesh, { size: 0.25, featureAngle: 30, reference: cube() });
  const printed = run(['quality', 'fine.ply', '--size', '0.25', '--feature-angle', '30', '--reference', 'cube.ply'], { cwd });
  assert.deepEqual([printed.code, printed.out], [0, table]);
  const json = run(['quality', 'fine.ply', '--size', '0.25', '--feature-angle', '30', '--reference', 'cube.ply', '--json'], { cwd });
  assert.deepEqual(JSON.parse(json.out), report);
  assert.match(run(['quality', '-', '--size', '1', '--format', 'off'], { cwd, input: mortise.writeMesh(cube(), { format: 'off' }) }).out, /^triangles +12 +12$/m);
  const refused = [[['quality', 'cube.ply'], /quality needs --size/], [['quality', '--size', '1'], /quality needs one mesh file/], [['quality', 'cube.ply', '--size', '1', '--output', 'x.stl'], /output/]];
  for (const [words, message] of refused) {
    const done = run(words, { cwd });
    assert.equal(done.code, 2);
    assert.match(done.err, message);
  }
});
