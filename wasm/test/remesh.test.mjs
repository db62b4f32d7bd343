// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes of the sizes wanted: angles, areas, labels and sources; creases of operands; what is refused; the command.

import assert from 'node:assert/strict';
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { inspect, load, make, MeshError, model, predictTriangles, quality, remesh, resultModel, sizing, subtract, transform, union } from 'mortise';

import { cube, meshError, run, soupOf, temporaryFolder } from './support.mjs';

const close = (found, expected, within = 1e-9) => assert.ok(Math.abs(found - expected) <= within * Math.abs(expected), `${found} instead of ${expected}`);

/** The unit cube with a name for each of two sides. */
function labelled() {
  return { ...cube(), faceLabels: Uint32Array.of(1, 1, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0), labelNames: ['sides', 'floor', 'roof'] };
}

const corner = ({ positions }, v) => [...positions.subarray(3 * v, 3 * v + 3)];
const middle = (mesh, t) => [0, 1, 2].map((axis) => [0, 1, 2].reduce((sum, k) => sum + corner(mesh, mesh.triangles[3 * t + k])[axis] / 3, 0));

/** Two cylinders along y and z that cross, and their union. */
async function crossing() {
  const tube = await make('cylinder', { radius: 0.5, height: 2, around: 32 });
  const upright = await transform(tube, [{ translate: [0, 0, -1] }]);
  const operands = [upright, await transform(upright, [{ rotateX: 90 }])];
  return { operands, result: await union(operands, { inspect: false }) };
}

test('a box gets good triangles of the size wanted, with its labels', async () => {
  const { mesh, sources, modelFaces, modelEdges, predicted, before, after } = await remesh(labelled(), { size: 0.2 });
  assert.deepEqual(before, { triangles: 12, area: 6, minAngleDeg: 45, maxAngleDeg: 90 });
  assert.equal(after.triangles, mesh.triangles.length / 3);
  close(after.area, 6);
  assert.ok(after.minAngleDeg >= 30 && after.maxAngleDeg < 115, `${after.minAngleDeg} to ${after.maxAngleDeg}`);
  close(predicted, (6 * 4) / Math.sqrt(3) / 0.2 ** 2, 1e-12);
  close(after.triangles, predicted, 0.15);
  assert.deepEqual(mesh.labelNames, ['sides', 'floor', 'roof']);
  for (let t = 0; t < sources.length; ++t) {
    const z = middle(mesh, t)[2];
    assert.equal(mesh.faceLabels[t], z === 0 ? 1 : z === 1 ? 2 : 0);
    assert.equal(labelled().faceLabels[sources[t]], mesh.faceLabels[t]);
    assert.equal(modelFaces[t], sources[t] >> 1, 'the cube has two triangles on each face');
  }
  // Twelve edges of five pieces each, all on edges of the cube: two coordinates of both ends are 0 or 1.
  assert.equal(modelEdges.length, 2 * 12 * 5);
  for (const v of modelEdges) assert.ok(corner(mesh, v).filter((x) => x === 0 || x === 1).length >= 2);
  assert.equal((await inspect(mesh)).volume, 1);
});

test('a union of crossing cylinders loses its slivers and keeps the creases of its operands', async () => {
  const { operands, result } = await crossing();
  const { mesh, modelFaces, before, after, predicted } = await remesh(result, { operands, size: 0.12, featureAngle: 40 });
  assert.ok(before.minAngleDeg < 5, 'slivers beside the cut');
  assert.ok(after.minAngleDeg >= 30, `${after.minAngleDeg}`);
  close(after.triangles, predicted, 0.15);
  close(after.area, before.area, 5e-3);
  const { closed, volume, selfIntersections } = await inspect(mesh);
  assert.deepEqual([closed, selfIntersections], [true, 0]);
  close(volume, result.report.volume, 1e-2);
  const { counts } = await resultModel(result, operands, { seams: 'none' });
  assert.deepEqual([...new Set(modelFaces)].sort((a, b) => a - b), Array.from({ length: counts.modelFaces }, (_, i) => i));
});

test('a segment makes triangles small near it', async () => {
  const source = { type: 'segment', from: [0, 0, 1], to: [1, 0, 1], size: 0.05, growth: 1.5 };
  const { mesh, after, predicted } = await remesh(cube(), { size: 0.4, sources: [source] });
  assert.ok(after.minAngleDeg >= 25, `${after.minAngleDeg}`);
  close(after.triangles, predicted, 0.15);
  const lengths = { near: [], far: [] };
  for (let i = 0; i < mesh.triangles.length; ++i) {
    const [p, q] = [mesh.triangles[i], mesh.triangles[i % 3 === 2 ? i - 2 : i + 1]].map((v) => corner(mesh, v));
    const distance = Math.hypot((p[1] + q[1]) / 2, (p[2] + q[2]) / 2 - 1);
    if (distance < 0.05) lengths.near.push(Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    if (distance > 0.8) lengths.far.push(Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  const mean = (list) => list.reduce((sum, x) => sum + x, 0) / list.length;
  assert.ok(mean(lengths.near) < 0.075 && mean(lengths.far) > 0.25, `${mean(lengths.near)} near, ${mean(lengths.far)} far`);
});

test('sizes are said in any way, with the same bits each time', async () => {
  const sources = [{ type: 'point', at: [0, 0, 0], size: 0.1 }];
  const made = await sizing({ size: 0.3, growth: 1.4, sources });
  const first = await remesh(cube(), { size: 0.3, growth: 1.4, sources });
  assert.deepEqual(await remesh(cube(), { size: 0.3, growth: 1.4, sources }), first);
  assert.deepEqual(await remesh(cube(), { sizing: made }), first);
  assert.equal(made.sizeAt([0, 0, 0]), 0.1, 'it is not disposed of');
  assert.equal(await predictTriangles(cube(), { sizing: made }), first.predicted);
  const soup = await remesh(soupOf(cube()), { sizing: made });
  assert.deepEqual(soup.before, first.before);
  assert.ok(soup.after.minAngleDeg >= 30 && (await inspect(soup.mesh)).closed);
  made.dispose();
  const byFunction = await remesh(cube(), { size: 1, growth: 1, sources: [{ sizes: () => 0.25 }] });
  assert.deepEqual(byFunction.mesh, (await remesh(cube(), { size: 0.25 })).mesh);
});

test('sheets are remeshed, data are left out, and what has no triangles stays empty', async () => {
  const sheet = await make('gridSheet', { width: 2, depth: 1, cellsX: 2, cellsY: 1 });
  const given = { ...sheet, vertexData: { t: { components: 1, values: new Float64Array(sheet.positions.length / 3) } } };
  const { mesh, after, modelEdges } = await remesh(given, { size: 0.25 });
  close(after.area, 2);
  assert.equal(modelEdges.length, 2 * 24, 'the border');
  assert.deepEqual([mesh.vertexData, mesh.cornerData], [undefined, undefined]);
  const empty = await remesh({ positions: [], triangles: [] }, { size: 1 });
  assert.deepEqual([empty.after, empty.predicted], [{ triangles: 0, area: 0, minAngleDeg: null, maxAngleDeg: null }, 0]);
});

test('the preset of the paper makes longer edges, rounds of the size alone take no coarse steps', async () => {
  const given = await make('cylinder', { radius: 1, height: 4, around: 48 });
  const counts = [];
  for (const options of [{}, { preset: 'paper' }, { rounds: [1, 1, 1] }]) {
    const { after, kept, newCrossings } = await remesh(given, { size: 0.2, ...options });
    assert.ok(after.minAngleDeg > 30);
    assert.deepEqual([kept.length, newCrossings], [0, 0]);
    counts.push(after.triangles);
  }
  assert.ok(counts[1] < 0.6 * counts[0] && Math.abs(counts[2] / counts[0] - 1) < 0.1, String(counts));
});

test('the frontal mesher makes new triangles in planes, of the same sizes and on the same model', async () => {
  const options = { size: 0.1, sources: [{ type: 'point', at: [0, 0, 1], size: 0.02 }] };
  const [local, frontal] = [await remesh(cube(), options), await remesh(cube(), { ...options, mesher: 'frontal' })];
  assert.deepEqual(await remesh(cube(), { ...options, mesher: 'local' }), local);
  assert.notDeepEqual(frontal.mesh, local.mesh);
  assert.ok(frontal.after.minAngleDeg > 30 && Math.abs(frontal.after.triangles / frontal.predicted - 1) < 0.15, `${frontal.after.triangles} of ${frontal.predicted}`);
  close(frontal.after.area, 6);
  assert.equal(new Set(frontal.modelFaces).size, 6);
  assert.deepEqual([frontal.kept.length, frontal.newCrossings], [0, 0]);
  const { closed, selfIntersections } = await inspect(frontal.mesh);
  assert.deepEqual([closed, selfIntersections], [true, 0]);
  assert.deepEqual(await remesh(cube(), { ...options, mesher: 'frontal' }), frontal);
});

test('features smaller than the size get triangles that fit them, unless they are to be kept', async () => {
  const plate = await make('box', { lo: [0, 0, 0], hi: [10, 10, 0.3] });
  const [kept, refined] = [await remesh(plate, { size: 1, features: 'keep' }), await remesh(plate, { size: 1 })];
  assert.deepEqual(await remesh(plate, { size: 1, features: 'refine' }), refined);
  assert.equal(kept.refinement.length, 0);
  assert.deepEqual([...refined.refinement.subarray(6, 9)], [0.3, 1.2, 0], 'size, growth and radius of the first');
  assert.ok(kept.after.minAngleDeg < 30 && refined.after.minAngleDeg > 30, `${kept.after.minAngleDeg}, ${refined.after.minAngleDeg}`);
  assert.ok(refined.predicted > 3 * kept.predicted && refined.after.triangles > refined.predicted, `${refined.after.triangles} of ${refined.predicted}`);
  assert.deepEqual(await remesh(plate, { size: 1, minFeature: 0.4 }), kept);
  for (const features of ['keep', 'refine']) {
    const { predicted } = features === 'keep' ? kept : refined;
    assert.equal(await predictTriangles(plate, { size: 1, features }), predicted);
  }
  const [asRefined, asKept] = [await quality(refined, { size: 1 }), await quality({ ...refined, refinement: undefined }, { size: 1 })];
  assert.ok(asRefined.edges.inBand > 0.97 && asKept.edges.inBand < 0.5, `${asRefined.edges.inBand}, ${asKept.edges.inBand}`);
  assert.equal(asRefined.all.below30, 0);
  const { message } = await meshError('RESULT_TOO_LARGE', () => remesh(plate, { size: 1, mostTriangles: 1000 }), MeshError);
  assert.match(message, /more than 1000; some for small features: features 'keep' leaves these as they are, minFeature those below it/);
});

test('small features merged before are gone, and what they were is told', async () => {
  const [block, slot] = [await make('box', { lo: [0, 0, 0], hi: [2, 1, 1] }), await make('box', { lo: [1, -1, 0.5], hi: [1.001, 2, 2] })];
  const result = await subtract(block, slot);
  const options = { size: 0.3, features: 'merge', minFeature: 0.01 };
  const closed = await remesh(result.mesh, options);
  const { merged, sources, after, predicted } = closed;
  const slotted = result.mesh.triangles.length / 3;
  assert.ok(merged.gone.length >= 6 && merged.gone.length < slotted && merged.gone.every((t) => t < slotted), `${merged.gone}`);
  assert.deepEqual([merged.unresolved.length, merged.movedVertices > 0, merged.largestMove <= 0.01], [0, true, true]);
  assert.ok(sources.every((t) => t < slotted && !merged.gone.includes(t)));
  assert.equal(new Set(closed.modelFaces).size, 6);
  close((await inspect(closed.mesh)).volume, 2, 0.01);
  assert.ok(after.minAngleDeg > 30 && after.triangles < 1.3 * predicted, `${after.minAngleDeg}, ${after.triangles} of ${predicted}`);
  assert.equal(await predictTriangles(result.mesh, options), predicted);
  const open = await remesh(result.mesh, { size: 0.3 });
  assert.equal(open.merged, undefined);
  assert.ok(open.after.triangles > 2 * after.triangles, 'refined, the slot takes many triangles');
  const ofResult = await remesh(result, { ...options, operands: [block, slot], zone: new Uint8Array(slotted).fill(1) });
  assert.equal(new Set(ofResult.modelFaces).size, 6);
  assert.deepEqual(ofResult.merged, merged);
  const none = await remesh(block, options);
  assert.deepEqual([none.merged.gone.length, none.merged.movedVertices], [0, 0]);
  close(none.after.triangles, (await remesh(block, { size: 0.3 })).after.triangles, 0.1);
  assert.equal((await remesh({ positions: [], triangles: [] }, options)).after.triangles, 0);
});

test('no point is farther from the mesh given than the deviation allows', async () => {
  const ball = await make('icosphere', { radius: 1, levels: 4 });
  const [free, bound] = [await remesh(ball, { size: 0.3 }), await remesh(ball, { size: 0.3, maxDeviation: 0.01 })];
  const farthest = async (fine) => {
    const { deviation, all } = await quality(fine, { size: 0.3, reference: ball });
    assert.equal(all.below30, 0);
    return Math.max(deviation.toReference.max, deviation.fromReference.max);
  };
  assert.ok((await farthest(free)) > 0.01 && (await farthest(bound)) <= 0.01);
  assert.ok(free.refinement.length === 0 && bound.refinement.length > 0 && bound.predicted > free.predicted);
  assert.equal(bound.kept.length, 0);
  assert.ok((await quality(bound, { size: 0.3 })).edges.inBand > 0.97);
});

test('where faces would come to cross, triangles stay', async () => {
  const thin = { positions: [0, 2, 2, 3, 4, 2, 3, 4, 4, 0, 3, 4], triangles: [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0] };
  const size = 0.411;
  assert.ok((await inspect((await remesh(thin, { size, audits: 0 })).mesh)).selfIntersections > 0);
  const { mesh, kept, newCrossings } = await remesh(thin, { size });
  assert.equal((await inspect(mesh)).selfIntersections, 0);
  assert.deepEqual([[...kept], newCrossings], [[0, 1, 2, 3], 0]);
});

test('angles decide what is an edge and what is a corner', async () => {
  const round = await make('cylinder', { radius: 1, height: 1, around: 12 });
  const pieces = async (options) => new Set((await remesh(round, { size: 0.5, ...options })).modelFaces).size;
  assert.equal(await pieces({}), 3);
  assert.equal(await pieces({ featureAngle: 20 }), 14);
  const rimCorners = async (curveAngle) => {
    const { mesh } = await remesh(round, { size: 0.9, curveAngle });
    const has = new Set(Array.from({ length: mesh.positions.length / 3 }, (_, v) => String(corner(mesh, v))));
    const corners = Array.from({ length: round.positions.length / 3 }, (_, v) => corner(round, v));
    return corners.filter(([x, y]) => Math.hypot(x, y) > 0.5).filter((place) => has.has(String(place))).length;
  };
  assert.equal(await rimCorners(20), 24, 'every corner of the two rims stays');
  assert.ok((await rimCorners(45)) < 24);
});

test('half-spaces are operands', async (t) => {
  const plane = { plane: [0, 0, 1, 0.45] };
  const ball = await make('icosphere', { radius: 1, levels: 3 });
  const result = await subtract(ball, plane);
  const cap = await model(result.mesh, { sources: { provenance: result.provenance, operands: [ball, plane] } });
  assert.deepEqual([cap.counts.modelFaces, cap.counts.modelEdges], [2, 1]);
  const { mesh, modelFaces, after } = await remesh(result, { operands: [ball, plane], size: 0.15 });
  assert.equal(new Set(modelFaces).size, 2);
  assert.ok(after.minAngleDeg > 25, `${after.minAngleDeg}`);
  close((await inspect(mesh)).volume, result.report.volume, 0.02);
  const cwd = temporaryFolder(t);
  const mortise = await load();
  mortise.writeMesh(join(cwd, 'cube.off'), cube());
  assert.equal(run(['intersect', 'cube.off', '--plane', '0,0,1,0.5', '-o', 'low.off', '--remesh', '0.2', '-q'], { cwd }).code, 0);
  const low = mortise.readMesh(join(cwd, 'low.off'));
  assert.ok(low.triangles.length > 300);
  close(mortise.inspect(low).volume, 0.5);
});

test('progress is reported, and stops the call', async () => {
  const seen = [];
  await remesh(cube(), { size: 0.3, onProgress: ({ stage, fraction }) => void seen.push([stage, fraction]) });
  assert.equal(seen.length, 8, 'seven rounds and the worst triangles');
  assert.ok(seen.every(([stage, fraction], i) => stage === 'remesh' && fraction >= 0 && fraction <= 1 && (i === 0 || fraction > seen[i - 1][1])));
  await meshError('CANCELLED', () => remesh(cube(), { size: 0.3, onProgress: () => false }), MeshError);
  const thrown = new Error('mine');
  await assert.rejects(() => remesh(cube(), { size: 0.3, onProgress: () => { throw thrown; } }), thrown);
  await meshError('CANCELLED', () => remesh(cube(), { size: 0.3, signal: AbortSignal.abort() }), MeshError);
  const made = await sizing({ size: 0.3 });
  const { after } = await remesh(cube(), { sizing: made, onProgress: () => made.dispose() });
  assert.ok(after.minAngleDeg >= 30, 'a sizing stays for the call');
});

test('more triangles than allowed are refused with the count', async () => {
  const tooMany = async (options) => (await meshError('RESULT_TOO_LARGE', () => remesh(cube(), options), MeshError)).message;
  assert.match(await tooMany({ size: 1e-4 }), /ask for about 138564\d{4} triangles, more than 20000000$/);
  assert.match(await tooMany({ size: 0.1, mostTriangles: 1000 }), /ask for about 1385 triangles, more than 1000$/);
  close(await predictTriangles(cube(), { size: 1e-4 }), 6 * 4e8 / Math.sqrt(3), 1e-9);
});

test('what means nothing is refused by name', async () => {
  const { operands, result } = { operands: [cube(), cube(0.5)], result: await union(cube(), cube(0.5)) };
  const made = await sizing({ size: 1 });
  const gone = await sizing({ size: 1 });
  gone.dispose();
  const refused = [
    [cube(), undefined, /^size must be a positive number, not undefined/],
    [cube(), { size: 0 }, /^size must be a positive number, not number 0/],
    [cube(), { size: 1, smallest: 2 }, /smallest is 2, more than the size 1/],
    [cube(), { size: 1, sources: [{ type: 'point', at: [0, 0], size: 1 }] }, /sources\[0\]\.at must be three finite numbers/],
    [cube(), { size: 1, sources: [{ curvature: { perTurn: 8 } }] }, /sources\[0\]\.model must be what model/],
    [cube(), { size: 1, faceAngle: 40 }, /unknown option 'faceAngle'; known: size, smallest, growth, sources, sizing, operands, featureAngle/],
    [cube(), { size: 1, featureAngle: 181 }, /featureAngle must be an angle in degrees, 0 to 180, not number 181/],
    [cube(), { size: 1, curveAngle: '45' }, /curveAngle must be an angle in degrees/],
    [cube(), { size: 1, rounds: 3 }, /rounds must be an array of at most 1000 numbers, 1 to 64, not number 3/],
    [cube(), { size: 1, rounds: [2, 0.5] }, /rounds must be an array of at most 1000 numbers, 1 to 64/],
    [cube(), { size: 1, lastRounds: -1 }, /lastRounds must be a whole number, 0 to 1000/],
    [cube(), { size: 1, audits: 1.5 }, /audits must be a whole number/],
    [cube(), { size: 1, preset: 'botsch' }, /preset must be 'default' or 'paper', not /],
    [cube(), { size: 1, mesher: 'front' }, /mesher must be 'local' or 'frontal', not /],
    [cube(), { size: 1, features: 'drop' }, /features must be 'keep' or 'merge' or 'refine', not /],
    [cube(), { size: 1, features: 'merge', minFeature: 0 }, /minFeature must be a positive length, not number 0/],
    [cube(), { size: 1, features: 'keep', minFeature: 0.1 }, /minFeature does not go with features: 'keep'/],
    [cube(), { size: 1, minFeature: -1 }, /minFeature must be a length, not number -1/],
    [cube(), { size: 1, maxDeviation: 0 }, /maxDeviation must be a positive length, not number 0/],
    [cube(), { size: 1, mostTriangles: 0 }, /mostTriangles must be a number, 1 to/],
    [cube(), { size: 1, onProgress: 5 }, /onProgress must be a function/],
    [cube(), { sizing: made, size: 1 }, /a sizing says all about sizes: leave out size/],
    [cube(), { sizing: { size: 1 } }, /sizing must be what sizing\(\) gives/],
    [cube(), { sizing: sizing({ size: 1 }) }, /sizing is a promise: await it first/],
    [cube(), { sizing: gone }, /sizing was disposed of/],
    [result, { size: 1 }, /mesh is a result: say what it was made from with operands: \[a, b\], or pass its \.mesh/],
    [cube(), { size: 1, operands }, /operands are those of a result/],
    [result, { size: 1, operands: cube() }, /operands must be an array of the meshes/],
    [result, { size: 1, operands: [cube(), {}] }, /operands\[1\] has no positions/],
    [result, { size: 1, operands: [cube()] }, /./],
  ];
  for (const [mesh, options, message] of refused) assert.match((await meshError('INVALID_ARGUMENT', () => remesh(mesh, options), MeshError)).message, message);
  await meshError('INVALID_ARGUMENT', () => predictTriangles(cube(), { size: 1, rounds: [1] }), MeshError);
  made.dispose();
});

test('curvature of the model is a source like any other', async () => {
  const tube = await make('cylinder', { radius: 1, height: 1, around: 24 });
  const { after, predicted } = await remesh(tube, { size: 0.6, sources: [{ model: await model(tube), curvature: { perTurn: 24 }, growth: 1.5 }] });
  assert.ok(after.triangles > 1.3 * (await predictTriangles(tube, { size: 0.6 })));
  close(after.triangles, predicted, 0.2);
});

test('the command remeshes files and says what it did', async (t) => {
  const cwd = temporaryFolder(t);
  const mortise = await load();
  mortise.writeMesh(join(cwd, 'in.stl'), cube());
  const options = { size: 0.25, sources: [{ type: 'point', at: [0, 0, 0], size: 0.1 }, { type: 'segments', from: { points: Float64Array.of(0, 0, 1, 1, 0, 1), edges: Uint32Array.of(0, 1) }, size: 0.2 }] };
  writeFileSync(join(cwd, 'sizes.json'), JSON.stringify([options.sources[0], { ...options.sources[1], from: { points: [0, 0, 1, 1, 0, 1], edges: [0, 1] } }]));
  const done = run(['remesh', 'in.stl', '-o', 'out.ply', '--size', '0.25', '--sources', 'sizes.json', '--feature-angle', '30', '--curve-angle', '30', '--json'], { cwd });
  assert.equal(done.code, 0, done.err);
  const report = JSON.parse(done.out);
  const { mesh, predicted, before, after } = mortise.remesh(mortise.readMesh(join(cwd, 'in.stl')), { ...options, featureAngle: 30, curveAngle: 30 });
  assert.deepEqual([report.predicted, report.before, report.after], [predicted, before, after]);
  assert.deepEqual([report.triangles, report.volume, report.certified], [after.triangles, 1, true]);
  assert.deepEqual(mortise.readMesh(join(cwd, 'out.ply')), mortise.readMesh(mortise.writeMesh(mesh, { format: 'ply' }), { format: 'ply' }));
  const piped = run(['remesh', '-', '-o', '-', '--format', 'off', '--size', '0.5'], { cwd, input: mortise.writeMesh(cube(), { format: 'off' }) });
  assert.match(piped.err, /^notes +before: 12 triangles, angles 45 to 90 degrees$/m);
  assert.match(piped.err, /^ +55 triangles predicted$/m);
  assert.equal(mortise.inspect(mortise.readMesh(piped.bytes, { format: 'off' })).volume, 1);
});

test('the command refuses with words and exit codes', async (t) => {
  const cwd = temporaryFolder(t);
  (await load()).writeMesh(join(cwd, 'in.off'), cube());
  const files = { 'no.json': '[{', 'object.json': '{}', 'entity.json': '[{"entity": {}}]', 'point.json': '[{"type": "point", "at": [0, 0, 0]}]' };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(cwd, name), text);
  const refused = [
    [2, /remesh needs --size/],
    [2, /--size needs a number, not 'x'/, '--size', 'x'],
    [2, /size must be a positive number/, '--size', '-1'],
    [2, /featureAngle must be an angle/, '--size', '1', '--feature-angle', '200'],
    [2, /features must be 'keep' or 'merge' or 'refine'/, '--size', '1', '--features', 'drop'],
    [2, /mesher must be 'local' or 'frontal'/, '--size', '1', '--mesher', 'gmsh'],
    [3, /no\.json: this is no JSON: .*\[PARSE_FAILED\]/, '--size', '1', '--sources', 'no.json'],
    [2, /object\.json: sources must be a JSON array/, '--size', '1', '--sources', 'object.json'],
    [2, /entity\.json: sources\[0\] must have a type: point, segment, segments, triangle/, '--size', '1', '--sources', 'entity.json'],
    [2, /sources\[0\]\.size must be a positive number|sources\[0\]\.size must be a number/, '--size', '1', '--sources', 'point.json'],
    [3, /cannot read none\.json/, '--size', '1', '--sources', 'none.json'],
    [4, /more than 100 \[RESULT_TOO_LARGE\]/, '--size', '0.1', '--most-triangles', '100'],
  ];
  for (const [code, message, ...words] of refused) {
    const done = run(['remesh', 'in.off', '-o', 'out.off', ...words], { cwd });
    assert.match(done.err, message);
    assert.equal(done.code, code, done.err);
  }
  assert.equal(existsSync(join(cwd, 'out.off')), false);
});

test('of a result only layers round the graph change, of a mesh only what is marked', async () => {
  const operands = [await make('icosphere', { radius: 1, levels: 4 }), await transform(await make('icosphere', { radius: 1, levels: 4 }), [{ translate: [1.1, 0.1, 0.2] }])];
  const result = await union(...operands);
  const { mesh, after } = await remesh(result, { operands, size: 0.05, layers: 3 });
  const facesOf = ({ positions, triangles }) => new Set(Array.from({ length: triangles.length / 3 }, (_, t) => String([0, 1, 2].map((k) => [...positions.slice(3 * triangles[3 * t + k], 3 * triangles[3 * t + k] + 3)]))));
  const [before, now] = [facesOf(result.mesh), facesOf(mesh)];
  const kept = [...before].filter((face) => now.has(face)).length;
  assert.ok(kept > 0.6 * before.size && kept < before.size, `${kept} of ${before.size} stay`);
  assert.ok(after.minAngleDeg > 15 && (await inspect(result.mesh)).minAngleDeg < 5);
  const given = cube();
  const zone = Array.from({ length: given.triangles.length / 3 }, (_, t) => Number(t > 1));
  const marked = await remesh(given, { size: 0.2, zone });
  const stay = facesOf({ positions: Float64Array.from(given.positions), triangles: given.triangles.slice(0, 6) });
  assert.deepEqual([...stay].filter((face) => !facesOf(marked.mesh).has(face)), []);
  assert.ok(marked.after.triangles > 100);
  await meshError('INVALID_ARGUMENT', () => remesh(given, { size: 0.2, zone: [1] }), MeshError);
  await meshError('INVALID_ARGUMENT', () => remesh(given, { size: 0.2, zone: [2] }), MeshError);
  await meshError('INVALID_ARGUMENT', () => remesh(given, { size: 0.2, layers: 2 }), MeshError);
});

test('the command writes results with triangles of the size wanted', (t) => {
  const folder = temporaryFolder(t);
  const [a, b, out] = ['a.ply', 'b.ply', 'out.ply'].map((name) => `${folder}/${name}`);
  run(['make', 'icosphere', '--radius', '1', '--levels', '3', '-o', a]);
  run(['transform', a, '--translate', '1,0.1,0.2', '-o', b]);
  const report = JSON.parse(run(['union', a, b, '-o', out, '--remesh', '0.1', '--json']).out);
  assert.ok(report.notes.some((note) => /^after: [\d,]+ triangles, angles 3\d/.test(note)), report.notes.join('\n'));
  assert.ok(JSON.parse(run(['union', a, b, '-o', out, '--remesh', '0.1', '--layers', '2', '--json']).out).notes.some((note) => note.startsWith('before: ')));
  assert.match(run(['union', a, b, '-o', out, '--layers', '2']).err, /--layers needs --remesh/);
});
