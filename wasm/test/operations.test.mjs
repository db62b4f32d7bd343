// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Symmetric differences, partitions, expressions and tags as a program calls them.

import assert from 'node:assert/strict';
import test from 'node:test';

import { combine, implant, imprint, inspect, keep, load, MeshError, partition, resolve, symmetricDifference, union } from 'mortise';

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

/** Triples of an array as texts. */
const triples = (array) => Array.from({ length: array.length / 3 }, (_, i) => [...array.subarray(3 * i, 3 * i + 3)].join());

test('imprinted operands stay whole and share ids', async () => {
  const labelled = { ...cube(1), faceLabels: new Uint32Array(12).map((_, f) => f % 2), labelNames: ['even', 'odd'] };
  const { mesh, operands, graph, report, provenance } = await imprint(cube(), labelled);
  assert.equal(report.certified, true);
  assert.equal(report.contact.area, 1);
  assert.equal(graph.closedLoops, 1);
  assert.equal(report.regions.length, 2);
  for (const operand of operands) {
    const { volume, area, closed } = await inspect(operand);
    assert.deepEqual([volume, area, closed], [1, 6, true]);
    const corners = triples(operand.positions);
    const all = triples(mesh.positions);
    assert.deepEqual(corners, [...operand.vertexIds].map((id) => all[id]));
    for (let t = 0; t < operand.facetIds.length; ++t) {
      const common = [...operand.triangles.subarray(3 * t, 3 * t + 3)].map((v) => operand.vertexIds[v]);
      const facet = mesh.triangles.subarray(3 * operand.facetIds[t], 3 * operand.facetIds[t] + 3);
      assert.deepEqual(common.sort(), [...facet].sort());
    }
  }
  const [a, b] = operands;
  const shared = [...a.facetIds].filter((id) => b.facetIds.includes(id));
  assert.ok(shared.length >= 2);
  assert.equal(mesh.triangles.length / 3, a.facetIds.length + b.facetIds.length - shared.length);
  for (const id of shared) {
    assert.equal(provenance.otherSourceBegin[id + 1] - provenance.otherSourceBegin[id], 1);
    assert.equal(provenance.otherSourceFlipped[provenance.otherSourceBegin[id]], 1);
    assert.equal(provenance.categoryNames[b.category[b.facetIds.indexOf(id)]], 'onOpposite');
  }
  assert.deepEqual(b.labelNames, ['even', 'odd']);
  assert.ok(b.faceLabels.every((label, t) => label === labelled.faceLabels[b.sourceFace[t]]));
  assert.equal(a.faceLabels, undefined);
  assert.ok(b.sourceVertex.every((v, i) => v === 0xffffffff || triples(labelled.positions)[v] === triples(b.positions)[i]));
});

test('an imprint of imprinted operands adds nothing', async () => {
  const once = await imprint(cube(), cube(0.5, 0.5, 0.5), { inspect: false });
  const twice = await imprint(once.operands);
  assert.equal(twice.mesh.triangles.length, once.mesh.triangles.length);
  assert.deepEqual(twice.operands.map(({ positions }) => positions.length), once.operands.map(({ positions }) => positions.length));
  const mortise = await load();
  assert.deepEqual(mortise.imprint([cube(), cube(0.5, 0.5, 0.5)]).operands, once.operands);
  await assert.rejects(imprint([]), refused('at least one mesh'));
});

test('a component implanted in a host is a region of its own, or one body with it', async () => {
  const flush = await implant(cube(), cube(1));
  assert.deepEqual(flush.report.regions.map(({ operands, volume }) => [operands.join(), volume]).sort(), [['0', 1], ['1', 1]]);
  assert.equal(flush.report.area, 11);
  const sunk = await implant([cube(), cube(0.5)], { inspect: false });
  assert.deepEqual(sunk.report.regions.map(({ operands, volume }) => [operands.join(), volume]).sort(), [['0', 0.5], ['1', 1]]);
  assert.equal(sunk.report.certified, true);
  const one = await implant(cube(), cube(1), { contact: 'drop' });
  assert.deepEqual(one.mesh, (await union(cube(), cube(1))).mesh);
  await assert.rejects(implant(cube()), refused('a host and a component'));
  await assert.rejects(implant(cube(), cube(1), { contact: 'glue' }), refused("'keep' or 'drop'"));
  await assert.rejects(implant(cube(), cube(1), { touch: 'keep' }), refused("unknown option 'touch'"));
});

test('a mesh that overlaps itself is resolved', async () => {
  const [a, b] = [cube(), cube(0.5)];
  const overlapping = { positions: Float64Array.of(...a.positions, ...b.positions), triangles: Uint32Array.of(...a.triangles, ...b.triangles.map((v) => v + 8)) };
  assert.equal((await inspect(overlapping)).volume, 2);
  const { report } = await resolve(overlapping);
  assert.deepEqual([report.volume, report.selfIntersections, report.operands[0].selfContacts], [1.5, 0, true]);
  assert.equal((await load()).resolve(overlapping, { inspect: false }).report.selfIntersections, null);
  await assert.rejects(resolve([overlapping]), refused('operand 0'));
});
