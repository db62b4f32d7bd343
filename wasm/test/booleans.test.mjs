// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The booleans as a program calls them: kinds of operands, ways of calling, what comes back.

import assert from 'node:assert/strict';
import process from 'node:process';
import test from 'node:test';

import { inspect, intersect, load, make, MeshError, partition, subtract, symmetricDifference, transform, union } from 'mortise';

import { cube, meshError, soupOf } from './support.mjs';

test('two cubes that overlap in an eighth have the volumes of arithmetic', async () => {
  const [a, b] = [cube(), cube(0.5, 0.5, 0.5)];
  assert.equal((await union(a, b)).report.volume, 1.875);
  assert.equal((await intersect(a, b)).report.volume, 0.125);
  assert.equal((await subtract(a, b)).report.volume, 0.875);
});

test('subtract takes all others from the first', async () => {
  const { report } = await subtract(cube(), cube(0.5), cube(0, 0.5), cube(0, 0, 0.5));
  assert.equal(report.volume, 0.125);
  assert.equal(report.operands.length, 4);
});

test('operands may be an array, with and without options', async () => {
  const row = Array.from({ length: 6 }, (_, i) => cube(0.5 * i));
  assert.equal((await union(row)).report.volume, 3.5);
  assert.equal((await union(row, {})).report.volume, 3.5);
  assert.equal((await union(row, undefined)).report.volume, 3.5);
  assert.equal((await union(row[0], row[1], undefined)).report.volume, 1.5);
});

test('one operand resolves itself', async () => {
  const [a, b] = [cube(), cube(0.5)];
  const both = {
    positions: [...a.positions, ...b.positions],
    triangles: [...a.triangles, ...b.triangles.map((v) => v + 8)],
  };
  const { report } = await union(both);
  assert.equal(report.volume, 1.5);
  assert.equal(report.operands[0].selfContacts, true);
});

test('plain arrays, Float32Array and triangle soups give what typed meshes give', async () => {
  const [a, b] = [cube(), cube(0.5, 0.25, 0.125)];
  const { mesh } = await union(a, b);
  const plain = await union({ positions: [...a.positions], triangles: [...a.triangles] }, b);
  const single = await union({ positions: Float32Array.from(a.positions), triangles: Uint16Array.from(a.triangles) }, b);
  assert.deepEqual(plain.mesh, mesh);
  assert.deepEqual(single.mesh, mesh);
  const soups = await union(soupOf(a), { ...soupOf(b), triangles: null });
  assert.equal(soups.report.triangles, mesh.triangles.length / 3);
  assert.equal(soups.report.closed, true);
});

test('operands stay as they were', async () => {
  const [a, b] = [cube(), cube(0.5, 0.5, 0.5)];
  await subtract(a, b);
  assert.deepEqual([a, b], [cube(), cube(0.5, 0.5, 0.5)]);
});

test('results belong to JavaScript: a later call does not change them', async () => {
  const mortise = await load();
  const first = mortise.union(cube(), cube(0.5));
  const copy = structuredClone(first);
  mortise.union(mortise.make('icosphere', { levels: 5 }), cube());
  assert.deepEqual(first.mesh, copy.mesh);
  assert.notEqual(first.mesh.positions.buffer.byteLength, 0);
  assert.equal(first.mesh.positions.byteLength, first.mesh.positions.buffer.byteLength);
});

test('the result says where every triangle and vertex comes from', async () => {
  const operands = [cube(), cube(0.5, 0.5, 0.5)];
  const { mesh, provenance } = await subtract(...operands);
  const count = mesh.triangles.length / 3;
  for (const name of ['sourceOperand', 'sourceFace', 'flipped']) assert.equal(provenance[name].length, count, name);
  assert.equal(provenance.otherSourceBegin.length, count + 1);
  const fromTool = [...provenance.sourceOperand].map((operand) => operand === 1);
  assert.deepEqual([...provenance.flipped].map(Boolean), fromTool, 'exactly the faces of the tool are turned over');
  for (let v = 0; v < mesh.positions.length / 3; ++v) {
    if (provenance.vertexOperand[v] === 0xffffffff) continue;
    const source = operands[provenance.vertexOperand[v]].positions.subarray(3 * provenance.vertexSource[v], 3 * provenance.vertexSource[v] + 3);
    assert.deepEqual(mesh.positions.subarray(3 * v, 3 * v + 3), source);
  }
});

test('faces that coincide name both their sources', async () => {
  const { provenance, report } = await union(cube(), cube(0, 0.5));
  assert.equal(report.volume, 1.5);
  assert.ok(provenance.otherSourceOperand.length > 0);
  assert.equal(provenance.otherSourceBegin.at(-1), provenance.otherSourceOperand.length);
});

test('every triangle knows how it lies to the other operands', async () => {
  const { provenance } = await union(cube(), cube(0.5, 0.5, 0.5));
  assert.equal(provenance.category.length, provenance.sourceFace.length);
  const named = new Set([...provenance.category].map((code) => provenance.categoryNames[code]));
  assert.deepEqual([...named], ['outside'], 'a union of solids in general position keeps what lies outside');
  const common = await intersect(cube(), cube(0.5, 0.5, 0.5));
  assert.deepEqual(new Set([...common.provenance.category].map((code) => common.provenance.categoryNames[code])), new Set(['inside']));
  const sets = [...common.provenance.covering].map((set) => [...common.provenance.coveringSets[set]].join());
  assert.deepEqual(new Set(sets), new Set(['0,1']));
  const flush = await union(cube(), cube(0, 0.5));
  assert.ok([...flush.provenance.category].some((code) => flush.provenance.categoryNames[code] === 'onSame'));
});

test('regions have ids, operands, volume and area, and triangles know theirs', async () => {
  const { provenance, report } = await union(cube(), cube(0.5), cube(9));
  assert.deepEqual(report.regions, [
    { id: 1, operands: [0, 1], volume: 1.5, area: 8 },
    { id: 2, operands: [2], volume: 1, area: 6 },
  ]);
  assert.deepEqual([...new Set(provenance.regionLeft)], [1, 2]);
  assert.deepEqual([...new Set(provenance.regionRight)], [0]);
  assert.equal(provenance.regionLeft.length, provenance.sourceFace.length);
  const bars = await subtract(cube(), await transform(cube(), [{ scale: 0.5 }, { translate: [0.5, 0.5, 0.5] }]));
  assert.deepEqual(bars.report.regions.map(({ operands, volume }) => ({ operands, volume })), [{ operands: [0], volume: 0.875 }]);
});

test('the graph of two overlapping cubes is one closed loop of six edges', async () => {
  const { graph, report } = await union(cube(), cube(0.5, 0.5, 0.5));
  assert.equal(graph.points.length, 18);
  assert.equal(graph.edges.length, 12);
  assert.equal(graph.chains.length, 1);
  assert.equal(graph.chains[0][0], graph.chains[0].at(-1));
  assert.deepEqual(report.graph, { vertices: 6, edges: 6, closedLoops: 1, openChains: 0 });
});

test('cubes that share a face meet in area one and have no volume in common', async () => {
  const { mesh, report } = await intersect(cube(), cube(1));
  assert.equal(mesh.triangles.length, 0);
  assert.equal(report.closed, true);
  assert.equal(report.bbox, null);
  assert.equal(report.minAngleDeg, null);
  assert.equal(report.contact.area, 1);
});

test('labels of the operands reach the result, equal names as one', async () => {
  const faceLabels = new Uint32Array(12).fill(1);
  const a = { ...cube(), faceLabels, labelNames: ['unused', 'steel'] };
  const b = { ...cube(0.5, 0.5, 0.5), faceLabels: [...faceLabels], labelNames: ['paint', 'steel'] };
  const { mesh } = await union(a, b);
  const names = new Set([...mesh.faceLabels].map((label) => mesh.labelNames[label]));
  assert.deepEqual([...names], ['steel']);
});

test('labels without names are named by their numbers', async () => {
  const { mesh } = await union({ ...cube(), faceLabels: new Uint8Array(12).fill(3) }, cube(0.5));
  const first = mesh.faceLabels[0];
  assert.equal(mesh.labelNames[first], '3');
});

test('the report has exactly the documented fields, in their order', async () => {
  const { report } = await union(cube(), cube(0.5));
  const fields =
    'vertices triangles closed oriented manifold boundaryEdges nonManifoldEdges components genus volume area bbox minAngleDeg maxAngleDeg ' +
    'selfIntersections certified certificate tolerance operands stages milliseconds regions graph contact notes';
  assert.deepEqual(Object.keys(report), fields.split(' '));
  assert.deepEqual(Object.keys(await inspect(cube())), fields.split(' '));
  assert.equal(report.certified, true);
  assert.ok(report.milliseconds > 0);
  assert.ok(report.stages.some(({ stage }) => stage === 'find_contacts'));
});

/** A prism over a five-pointed star drawn in one line, whose walls cross each other, and a slanted wedge that cuts one of its tips off. */
function selfCrossing() {
  const outline = [[0, 10], [-6, -8], [9, 3], [-9, 3], [6, -8], [0, 0]];
  const star = { positions: [0, 2].flatMap((z) => outline.flatMap(([x, y]) => [x, y, z])), triangles: [] };
  for (let i = 0; i < 5; ++i) {
    const j = (i + 1) % 5;
    star.triangles.push(5, j, i, 11, 6 + i, 6 + j, i, j, 6 + j, i, 6 + j, 6 + i);
  }
  const wedge = { positions: [-3, 8.3, -3, 3, 8.7, -3, 0.1, 8.1, 9, 0.2, 15, 0.3], triangles: [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0] };
  return [star, wedge];
}

test('without inspection self-intersections are not looked for, and nothing else is different', async () => {
  const timeless = ({ mesh, graph, provenance, report: { milliseconds: _, stages, ...report } }) => {
    return { mesh, graph, provenance, report, stages: stages.map(({ stage }) => stage) };
  };
  const scene = [cube(), cube(0.5, 0.25, 0.125)];
  const full = timeless(await union(...scene));
  assert.equal(full.report.selfIntersections, 0);
  assert.deepEqual(timeless(await union(...scene, { inspect: true })), full);
  assert.deepEqual(timeless(await union(scene, { inspect: false })), { ...full, report: { ...full.report, selfIntersections: null } });
});

test('what the result has of crossings is left out of the notes when not looked for', async () => {
  const crossing = /^\d+ pairs of triangles (cross|overlap|touch)/;
  const inspected = await subtract(...selfCrossing());
  assert.ok(inspected.report.selfIntersections > 0);
  const brief = await subtract(...selfCrossing(), { inspect: false });
  assert.equal(brief.report.selfIntersections, null);
  assert.ok(brief.report.notes.length < inspected.report.notes.length);
  assert.deepEqual(brief.report.notes, inspected.report.notes.filter((note) => !crossing.test(note)));
});

test('crossings near the cut that an operand brought along are noted, others are not', async () => {
  const inherited = /^\d+ crossings near the cut were brought along by an operand$/;
  const { report } = await subtract(...selfCrossing());
  assert.equal(report.certified, true, 'certified relative to what the operands had');
  assert.equal(report.notes.filter((note) => inherited.test(note)).length, 1, report.notes.join());
  const { report: clean } = await subtract(cube(), cube(0.5, 0.25, 0.125));
  assert.deepEqual(clean.notes.filter((note) => inherited.test(note)), []);
});

test('load gives the same functions without promises, one core for all', async () => {
  const mortise = await load();
  assert.equal(await load(), mortise);
  const now = mortise.subtract(cube(), cube(0.5, 0.5, 0.5));
  const later = await subtract(cube(), cube(0.5, 0.5, 0.5));
  assert.deepEqual(now.mesh, later.mesh);
  assert.deepEqual(now.provenance, later.provenance);
});

test('progress rises to one and names stages', async () => {
  const seen = [];
  await union(cube(), cube(0.5), { onProgress: (progress) => void seen.push(progress) });
  const fractions = seen.map(({ fraction }) => fraction);
  assert.ok(seen.length > 3);
  assert.deepEqual(fractions, [...fractions].sort((a, b) => a - b));
  assert.equal(fractions.at(-1), 1);
  assert.ok(seen.every(({ stage }) => /^[a-z_]+$/.test(stage)));
});

test('false from onProgress cancels, and the next call works', async () => {
  const error = await meshError('CANCELLED', () => union(cube(), cube(0.5), { onProgress: ({ fraction }) => fraction < 0.5 }), MeshError);
  assert.equal(typeof error.details.stage, 'string');
  assert.equal((await union(cube(), cube(0.5))).report.volume, 1.5);
});

test('an aborted signal cancels before and during the call', async () => {
  const reason = new Error('the user left');
  const before = await meshError('CANCELLED', () => union([cube()], { signal: AbortSignal.abort(reason) }), MeshError);
  assert.equal(before.cause, reason);
  const controller = new AbortController();
  const during = () => union(cube(), cube(0.5), { signal: controller.signal, onProgress: () => controller.abort(reason) });
  assert.equal((await meshError('CANCELLED', during, MeshError)).cause, reason);
});

test('what onProgress throws comes out unchanged, and the next call works', async () => {
  const thrown = new TypeError('a bug of the caller');
  const call = union(cube(), cube(0.5), {
    onProgress: () => {
      throw thrown;
    },
  });
  await assert.rejects(call, (error) => error === thrown);
  assert.equal((await union(cube(), cube(0.5))).report.volume, 1.5);
});

test('two hundred calls do not make the core grow', async () => {
  const mortise = await load();
  const [a, b] = [mortise.make('icosphere', { levels: 3 }), mortise.make('torus', { around: 24, across: 12 })];
  const first = mortise.union(a, b).mesh;
  // Node counts the core's memory as external, but not among the array buffers.
  const coreMemory = () => process.memoryUsage().external - process.memoryUsage().arrayBuffers;
  const before = coreMemory();
  for (let i = 0; i < 200; ++i) assert.equal(mortise.union(a, b).mesh.triangles.length, first.triangles.length);
  const grown = coreMemory() - before;
  assert.ok(grown < 4e6, `${grown} bytes`);
});

test('a sphere cut out of a turned box keeps its measure', async () => {
  const box = await transform(await make('box', { lo: [-1, -1, -1], hi: [1, 1, 1] }), [{ rotateX: 30 }, { rotateZ: 17 }]);
  const ball = await make('icosphere', { radius: 1.2, levels: 4 });
  const [inside, outside, whole] = [await intersect(box, ball), await subtract(box, ball), await inspect(box)];
  assert.ok(Math.abs(inside.report.volume + outside.report.volume - whole.volume) < 1e-12);
  assert.equal(outside.report.certified, true);
});

test('an absolute certificate counts crossings an operand brought along', async () => {
  const torus = await make('torus', { majorRadius: 3, minorRadius: 1, around: 24, across: 12 });
  const positions = torus.positions.map((x, i) => (i % 3 === 0 && x > 3.9 ? x - 3 : x));
  const crossed = { positions, triangles: torus.triangles };
  const beside = await make('box', { lo: [-4.5, -0.5, -0.5], hi: [-3.5, 0.5, 2] });
  const relative = await union(crossed, beside);
  assert.equal(relative.report.certified, true);
  assert.ok(relative.report.selfIntersections > 0);
  const absolute = await union(crossed, beside, { certify: 'absolute' });
  assert.equal(absolute.report.certified, false);
  assert.ok(absolute.report.notes.some((note) => note.startsWith('absolute certificate: ')));
  assert.equal((await union(torus, beside, { certify: 'absolute' })).report.certified, true);
  await assert.rejects(union(torus, beside, { certify: true }), { code: 'INVALID_ARGUMENT' });
});

test('copies turned too little for doubles are snapped; the certificate says how, and which vertices moved', async () => {
  const torus = await make('torus', { majorRadius: 1, minorRadius: 0.375, around: 12, across: 8 });
  const ring = await transform(torus, [{ rotateX: 20 }, { rotateY: 31 }]);
  const copy = await transform(ring, [{ rotateZ: 1e-10 }]);
  const { mesh, report } = await symmetricDifference(ring, copy);
  assert.equal(report.certified, true);
  assert.equal(report.selfIntersections, 0);
  const { certificate } = report;
  assert.equal(certificate.level, 'relative');
  assert.ok(certificate.snapRounds > 0 && certificate.trianglesTested > 0 && certificate.failedTriangles.length === 0);
  assert.ok(certificate.repairDisplacement > 0 && certificate.repairDisplacement <= certificate.largestDisplacement);
  assert.ok(certificate.largestDisplacement < 2 ** -22);
  const places = new Set();
  for (let v = 0; v < mesh.positions.length; v += 3) places.add(mesh.positions.slice(v, v + 3).join());
  assert.ok(certificate.movedInputVertices.length > 0);
  for (const { operand, vertex } of certificate.movedInputVertices) {
    assert.ok(!places.has([ring, copy][operand].positions.slice(3 * vertex, 3 * vertex + 3).join()), 'it is where it was');
  }
  assert.ok(report.notes.some((note) => note.includes('rounds of snapping, which moved')));
  assert.equal((await inspect(mesh)).certificate, null);
});

test('float32 coordinates are certified as such, and repaired where doubles need no repair', async () => {
  const ball = await make('icosphere', { levels: 4 });
  const near = await transform(ball, [{ rotateX: 1e-6 }, { rotateZ: 2e-6 }]);
  for (const operation of [union, subtract, partition]) {
    const { mesh, report } = await operation(ball, near, { coordinates: 'float32' });
    assert.ok(mesh.positions.every((x) => x === Math.fround(x)));
    assert.equal(report.certified, true);
    const { mergeRounds, swapRounds, snapRounds, largestDisplacement } = report.certificate;
    assert.ok(mergeRounds + swapRounds + snapRounds > 0);
    assert.ok(largestDisplacement >= 2 ** -25 && largestDisplacement < 2 ** -12);
    assert.ok(report.notes.some((note) => note.startsWith('relative certificate of float32 coordinates: ')));
    if (operation !== partition) assert.equal((await inspect({ ...mesh, positions: Float32Array.from(mesh.positions) })).certified, true);
  }
  await assert.rejects(union(ball, near, { coordinates: 'float16' }), { code: 'INVALID_ARGUMENT' });
  const huge = await transform(ball, [{ scale: 1e39 }]);
  await assert.rejects(union(huge, huge, { coordinates: 'float32' }), { code: 'OUT_OF_RANGE' });
});

test('coordinates that are not proven come with the places they stand for, by points of the operands', async () => {
  const far = await make('icosphere', { radius: 1, levels: 5 });
  const sphere = await transform(far, [{ translate: [1e8, 0, 0] }]);
  const other = await transform(far, [{ translate: [1e8 + 0.5, 0.3, 0.2] }]);
  const { mesh, report } = await union(sphere, other, { coordinates: 'float32' });
  assert.equal(report.certified, false);
  const { failedTriangles, exactPlaces } = report.certificate;
  const corners = new Set([...failedTriangles].flatMap((t) => [...mesh.triangles.subarray(3 * t, 3 * t + 3)]));
  assert.deepEqual([...exactPlaces.vertices], [...corners].sort((a, b) => a - b));
  assert.equal(exactPlaces.begin.length, exactPlaces.vertices.length + 1);
  assert.equal(exactPlaces.points.length, 3 * exactPlaces.begin.at(-1));
  for (let i = 0; i < exactPlaces.vertices.length; ++i) assert.ok([1, 4, 5, 9].includes(exactPlaces.begin[i + 1] - exactPlaces.begin[i]));
});
