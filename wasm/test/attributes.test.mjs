// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Attributes of models through operations (Fig. 18), policies, lineage, interfaces.

import assert from 'node:assert/strict';
import test from 'node:test';

import { load, MeshError } from 'mortise';

import { cube, meshError } from './support.mjs';

const mortise = await load();
const { make, model, resultModel, transform, partition, subtract, union, imprint } = mortise;

const face = (id) => ({ dimension: 'face', id });
const region = (id) => ({ dimension: 'region', id });
const box = (lo, hi) => make('box', { lo, hi });
const coordinate = (mesh, v, axis) => mesh.positions[3 * v + axis];

/** Asserts that two numbers agree to 1e-12 of the larger. */
function assertNear(actual, expected, text) {
  assert.ok(Math.abs(actual - expected) <= 1e-12 * Math.max(Math.abs(actual), Math.abs(expected)), `${text}: ${actual} is not ${expected}`);
}

function areaOf({ positions, triangles }, t) {
  const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * triangles[3 * t + k], 3 * triangles[3 * t + k] + 3));
  const [u, v] = [b, c].map((p) => [0, 1, 2].map((i) => p[i] - a[i]));
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

/** The faces of a model whose vertices all satisfy a condition on (x, y, z). */
function facesWhere(m, holds) {
  const { mesh } = m;
  const isThere = (f) => [...m.trianglesOf(f)].every((t) => [0, 1, 2].every((k) => holds(...[0, 1, 2].map((axis) => coordinate(mesh, mesh.triangles[3 * t + k], axis)))));
  return Array.from({ length: m.counts.modelFaces }, (_, f) => f).filter(isThere).map(face);
}

/** The measures of a model by name. */
const measured = (m) => Object.fromEntries(m.measures().map(({ name, ...measures }) => [name, measures]));

const frustum = make('revolve', { profile: [[0, -1], [2, -1], [1, 1], [0, 1]], around: 48 });
const ball = transform(make('icosphere', { radius: 1.4, levels: 3 }), [{ translate: [1, 0.25, 0.5] }]);

/** A load on the top of the frustum, paint on its side, pressure on the sphere, matter in both. */
function scene() {
  const a = model(frustum), b = model(ball);
  const top = facesWhere(a, (x, y, z) => z === 1), bottom = facesWhere(a, (x, y, z) => z === -1);
  const ends = [...top, ...bottom].map(({ id }) => id);
  assert.deepEqual([a.counts.modelFaces, ends.length, b.counts.modelFaces], [3, 2, 1]);
  a.attributes.push({ name: 'load', kind: 'load', value: { newton: [0, 0, -9.5] }, targets: top });
  a.attributes.push({ name: 'paint', targets: [0, 1, 2].filter((id) => !ends.includes(id)).map(face) });
  a.attributes.push({ name: 'matter', kind: 'material', value: 'steel', targets: [region(1)] });
  b.attributes.push({ name: 'pressure', kind: 'boundaryCondition', value: 1e5, targets: [face(0)] });
  b.attributes.push({ name: 'matter', kind: 'material', value: 'oil', targets: [region(1)] });
  return [a, b];
}

/** Areas by attribute as provenance has them: each triangle has those of the faces of its sources. */
function areasByProvenance({ mesh, provenance: p }, operands) {
  const areas = {};
  for (let t = 0; t < p.sourceOperand.length; ++t) {
    const sources = [[p.sourceOperand[t], p.sourceFace[t]]];
    for (let i = p.otherSourceBegin[t]; i < p.otherSourceBegin[t + 1]; ++i) sources.push([p.otherSourceOperand[i], p.otherSourceFace[i]]);
    const names = new Set(sources.flatMap(([k, f]) => operands[k].attributes.filter(({ targets }) => targets.some(({ dimension, id }) => dimension === 'face' && id === operands[k].triangleFace[f])).map(({ name }) => name)));
    for (const name of names) areas[name] = (areas[name] ?? 0) + areaOf(mesh, t);
  }
  return areas;
}

test('frustum and sphere: every attribute covers what is left of its parent (Fig. 18)', () => {
  const operands = scene();
  const before = { ...measured(operands[0]), ...measured(operands[1]) };
  const after = {};
  for (const operation of ['union', 'intersect', 'subtract', 'imprint', 'partition', 'symmetricDifference']) {
    const result = mortise[operation](frustum, ball);
    const m = resultModel(result, operands);
    after[operation] = measured(m);
    assert.deepEqual(Object.keys(after[operation]), ['load', 'matter', 'paint', 'pressure'], `${operation}: none lost, none invented`);
    const expected = areasByProvenance(result, operands);
    for (const name of ['load', 'paint', 'pressure']) assertNear(after[operation][name].area, expected[name], `${operation} ${name}`);
    assert.deepEqual(m.attributes.find(({ name }) => name === 'load'), { name: 'load', kind: 'load', value: { newton: [0, 0, -9.5] }, targets: m.attributes.find(({ name }) => name === 'load').targets, policy: { split: 'copy', merge: 'union', delete: 'drop' } });
    assert.equal(m.mesh, result.mesh);
  }
  for (const name of ['load', 'paint', 'pressure']) {
    const area = (operation) => after[operation][name].area;
    assert.ok(area('intersect') > 0.1 && area('union') > 0.1, name);
    assertNear(area('intersect') + area('union'), before[name].area, name);
    for (const operation of ['imprint', 'partition', 'symmetricDifference']) assertNear(area(operation), before[name].area, `${operation} ${name}`);
    assertNear(area('subtract'), area(name === 'pressure' ? 'intersect' : 'union'), `subtract ${name}`);
  }
  const volume = (operation) => after[operation].matter.volume;
  assertNear(volume('union'), volume('subtract') + volume('intersect') + (model(ball).region(1).volume - volume('intersect')), 'union');
  assertNear(volume('partition'), volume('union'), 'partition');
  assertNear(volume('symmetricDifference'), volume('union') - volume('intersect'), 'the hole has no matter');
});

test('an operand of an imprint has its own attributes, split but all there', () => {
  const operands = scene();
  imprint(frustum, ball).operands.forEach((operand, k) => {
    const before = measured(operands[k]), m = resultModel(operand, [operands[k]]), after = measured(m);
    assert.equal(m.mesh, operand);
    assert.ok(m.counts.modelFaces > operands[k].counts.modelFaces);
    assert.deepEqual(Object.keys(after), Object.keys(before));
    for (const [name, { area, volume }] of Object.entries(before)) {
      assertNear(after[name].area, area, name);
      assertNear(after[name].volume, volume, name);
    }
  });
});

/** A wall through a plate: two pieces of its top, of areas 3 and 6. */
function plate(policy, value = null) {
  const mesh = box([0, 0, 0], [10, 1, 1]);
  const m = model(mesh);
  m.attributes.push({ name: 'top', value, targets: facesWhere(m, (x, y, z) => z === 1), policy });
  return { operands: [m, box([3, -1, -1], [4, 2, 2])], result: subtract(mesh, box([3, -1, -1], [4, 2, 2])) };
}

test('a split attribute is copied, kept by the largest piece, dropped, or named by its pieces', () => {
  const areas = (policy) => {
    const { operands, result } = plate(policy);
    return resultModel(result, operands).measures().map(({ name, area }) => [name, area]);
  };
  assert.deepEqual(areas(undefined), [['top', 9]]);
  assert.deepEqual(areas({ split: 'copy' }), [['top', 9]]);
  assert.deepEqual(areas({ split: 'largest' }), [['top', 6]]);
  assert.deepEqual(areas({ split: 'drop' }), []);
  assert.deepEqual(areas({ pieceName: '{name} piece {piece}' }).map(([name]) => name), ['top piece 1', 'top piece 2']);
  assert.deepEqual(areas({ pieceName: '{name} piece {piece}' }).map(([, area]) => area).sort(), [3, 6]);
});

test('values that meet are kept together, one of them, none, or refused', async () => {
  const meshes = [box([0, 0, 0], [2, 2, 2]), box([1, 1, 1], [3, 3, 3])];
  const result = partition(meshes);
  const volumes = (merge, values = ['steel', 'oil']) => {
    const operands = meshes.map((mesh, k) => {
      const m = model(mesh);
      m.attributes.push({ name: 'material', value: values[k], targets: [region(1)], policy: { merge } });
      return m;
    });
    const m = resultModel(result, operands);
    return m.attributes.map(({ value, targets }) => [value, targets.reduce((sum, { id }) => sum + m.region(id).volume, 0)]);
  };
  assert.deepEqual(volumes('union'), [['oil', 8], ['steel', 8]]);
  assert.deepEqual(volumes('first'), [['oil', 7], ['steel', 8]]);
  assert.deepEqual(volumes('second'), [['oil', 8], ['steel', 7]]);
  assert.deepEqual(volumes('drop'), [['oil', 7], ['steel', 7]]);
  const error = await meshError('INVALID_ARGUMENT', () => volumes('error'), MeshError);
  assert.match(error.message, /attribute 'material' has several values on region \d/);
  const same = volumes('error', [{ e: 210, nu: { x: 0.25 } }, { nu: { x: 0.25 }, e: 210 }]);
  assert.deepEqual(same, [[{ e: 210, nu: { x: 0.25 } }, 15]], 'the order of keys is no difference');
});

test('what is cut away goes with its attribute, or gives it to its neighbours', () => {
  const mesh = box([0, 0, 0], [2, 2, 2]), tool = box([-1, -1, 1], [3, 3, 3]);
  const areas = (policy) => {
    const m = model(mesh);
    m.attributes.push({ name: 'top', targets: facesWhere(m, (x, y, z) => z === 2), policy });
    return resultModel(subtract(mesh, tool), [m, tool]).measures().map(({ area }) => area);
  };
  assert.deepEqual(areas({ delete: 'drop' }), []);
  assert.deepEqual(areas({ delete: 'toNeighbours' }), [8], 'four sides, half of each is left');
});

test('values go through as they are', () => {
  const values = [null, true, -0.1, 1e300, 'größe "m"\n', [], {}, [1, [2, { a: null }]], { b: [1, 2, 3], a: { 'ü': 'x' } }];
  for (const value of values) {
    const { operands, result } = plate({}, value);
    assert.deepEqual(resultModel(result, operands).attributes[0].value, value);
  }
});

test('lineage says the same both ways, and shares add up', () => {
  const operands = scene();
  const result = partition(frustum, ball);
  const m = resultModel(result, operands);
  const all = ({ counts: c }) => Object.entries({ vertex: c.modelVertices, edge: c.modelEdges, face: c.modelFaces, region: c.regions + c.voids + 1 }).flatMap(([dimension, count]) => Array.from({ length: count }, (_, id) => ({ dimension, id })));
  const forward = operands.flatMap((operand, k) => all(operand).flatMap((source) => m.partsOf(k, source).map((part) => [k, source.dimension, source.id, part.id, part.measure].join())));
  const back = all(m).flatMap((entity) => m.sourcesOf(entity).map((source) => [source.operand, source.dimension, source.id, entity.id, source.measure].join()));
  assert.ok(forward.length > 10);
  assert.deepEqual(forward.sort(), back.sort());
  operands.forEach((operand, k) => {
    const sum = (entity) => m.partsOf(k, entity).reduce((total, { measure }) => total + measure, 0);
    for (let f = 0; f < operand.counts.modelFaces; ++f) assertNear(sum(face(f)), operand.face(f).area, `face ${f}`);
    assertNear(sum(region(1)), operand.region(1).volume, `region of ${k}`);
    assert.deepEqual(m.partsOf(k, region(0)), []);
  });
  assert.equal(m.partsOf(0, face(2)).every(({ dimension }) => dimension === 'face'), true);
  const top = operands[0].attributes.find(({ name }) => name === 'load').targets[0];
  assert.equal(m.partsOf(0, top).length, 2, 'inside and outside of the sphere');
  assert.deepEqual(resultModel(union(frustum, ball), operands).partsOf(0, top).length, 1);
});

test('interfaces are named by both sides', () => {
  const meshes = [box([0, 0, 0], [2, 2, 2]), box([2, 0.5, 0.5], [3, 1, 1])];
  const operands = meshes.map((mesh) => model(mesh));
  operands[0].attributes.push({ name: 'deck', targets: facesWhere(operands[0], (x) => x === 2) });
  const m = resultModel(partition(meshes), operands, { names: ['hull', 'gun'] });
  const shared = m.interfaces.filter(({ targets }) => targets.some(({ dimension }) => dimension === 'face'));
  const base = facesWhere(operands[1], (x) => x === 2)[0].id;
  assert.deepEqual(shared.map(({ name }) => name), [`interface(hull.deck, gun.face ${base})`]);
  assert.equal(shared[0].targets.filter(({ dimension }) => dimension === 'face').reduce((sum, { id }) => sum + m.face(id).area, 0), 0.25);
  assert.deepEqual(m.measures(), [{ name: 'deck', vertices: 0, length: 0, area: 4, volume: 0 }], 'no attribute of its own');
  m.attributes.push(...m.interfaces);
  assert.equal(measured(m)[shared[0].name].area, 0.25);
  const unnamed = resultModel(partition(meshes), meshes).interfaces.map(({ name }) => name);
  assert.ok(unnamed.every((name) => /^interface\(a\.face \d(, [ab]\.face \d)+\)$/.test(name)), unnamed.join());
});

test('the result gets attributes of the operands asked for, and faces end where these do or not', () => {
  const meshes = [box([0, 0, 0], [1, 1, 1]), box([1, 0, 0], [3, 1, 1])];
  const operands = meshes.map((mesh, k) => {
    const m = model(mesh);
    m.attributes.push({ name: `top ${k}`, targets: facesWhere(m, (x, y, z) => z === 1) });
    return m;
  });
  const result = union(meshes);
  const seen = (options) => {
    const m = resultModel(result, operands, options);
    return [m.counts.modelFaces, ...m.measures().map(({ name, area }) => `${name}: ${area}`)];
  };
  assert.deepEqual(seen(), [7, 'top 0: 1', 'top 1: 2']);
  assert.deepEqual(seen({ attributesOf: [1] }), [7, 'top 1: 2']);
  assert.deepEqual(seen({ attributesOf: [] }), [6]);
  assert.deepEqual(seen({ splitAtAttributes: false }), [6, 'top 0: 3', 'top 1: 3'], 'on the whole of a face that is partly theirs');
  assert.deepEqual(seen({ graphEdges: true }), [10, 'top 0: 1', 'top 1: 2'], 'four faces of both operands in two');
});

test('labels are attributes, of meshes, results and operands that are given as meshes', () => {
  const labelled = { ...cube(), faceLabels: Uint32Array.from({ length: 12 }, (_, t) => (t < 4 ? t >> 1 : 2)), labelNames: ['low', 'high', '', 'unused'] };
  assert.deepEqual(model(labelled).attributes, [{ name: 'low', targets: [face(0)] }, { name: 'high', targets: [face(1)] }]);
  assert.deepEqual(model({ ...labelled, labelNames: undefined }).attributes.map(({ name }) => name), ['0', '1', '2']);
  const tool = box([0.25, 0.25, 0.5], [0.75, 0.75, 2]);
  const m = resultModel(subtract(labelled, tool), [labelled, tool]);
  assert.deepEqual(m.measures().map(({ name, area }) => [name, area]), [['high', 0.75], ['low', 1]]);
});

test('half-spaces, sheets and results are operands of models', () => {
  const mesh = box([0, 0, 0], [2, 2, 2]), plane = { plane: [0, 0, 1, 0.5] };
  const m = model(mesh);
  m.attributes.push({ name: 'floor', targets: facesWhere(m, (x, y, z) => z === 0) }, { name: 'all', targets: [region(1)] });
  const low = resultModel(mortise.intersect(mesh, plane), [m, plane]);
  assert.deepEqual(low.measures().map(({ name, area, volume }) => [name, area, volume]), [['all', 0, 2], ['floor', 4, 0]]);
  const cut = facesWhere(low, (x, y, z) => z === 0.5)[0];
  assert.deepEqual(low.sourcesOf(cut), [{ operand: 1, dimension: 'face', id: 0, measure: 4 }]);

  const tool = box([-1, -1, -1], [1, 1, 1]);
  const again = resultModel(subtract(low.mesh, tool), [low, tool]);
  assert.deepEqual(again.measures().map(({ name, area, volume }) => [name, area, volume]), [['all', 0, 1.5], ['floor', 3, 0]]);

  const sheet = make('gridSheet', { width: 4, depth: 4, cellsX: 2, cellsY: 2 });
  const deck = model(sheet);
  deck.attributes.push({ name: 'deck', targets: [face(0)] });
  assert.deepEqual(resultModel(subtract(sheet, mesh), [deck, mesh]).measures().map(({ name }) => name), ['deck']);
});

test('creases of a result of a result are those of the first operands', () => {
  // Thin slices of a ball's triangles have normals of their own only by rounding.
  const first = make('icosphere', { radius: 1, levels: 2 });
  const meshes = [first, transform(first, [{ rotateX: 1e-7 }, { rotateY: 2e-7 }])];
  const once = resultModel(union(meshes), meshes);
  const twice = resultModel(mortise.resolve(once.mesh), [once]);
  assert.deepEqual([once.counts.modelFaces, twice.counts.modelFaces], [1, 1]);
});

test('what has no meaning is refused, and says where', async () => {
  const mesh = cube(), other = box([0.5, 0.5, 0.5], [2, 2, 2]);
  const result = union(mesh, other);
  const withAttribute = (attribute) => {
    const m = model(mesh);
    m.attributes.push(attribute);
    return m;
  };
  const good = { name: 'x', targets: [face(0)] };
  const circular = {};
  circular.self = circular;
  const attributes = [
    [5, /operands\[0\]\.attributes\[0\] must be \{name, targets\}, not number 5/],
    [{ ...good, name: '' }, /attributes\[0\]\.name must be a string that is not empty/],
    [{ name: 'x' }, /attributes\[0\]\.targets must be an array/],
    [{ ...good, targets: [3] }, /targets\[0\] must be \{dimension, id\} with one of vertex, edge, face, region, not number 3/],
    [{ ...good, targets: [{ dimension: 'solid', id: 1 }] }, /the string "solid"/],
    [{ ...good, targets: [face(0), face(6)] }, /targets\[1\]: the model has no face 6: there are 6/],
    [{ ...good, targets: [face(-1)] }, /targets\[0\]\.id must be a number of a face, not number -1/],
    [{ ...good, kind: 'colour' }, /\.kind is one of material, boundaryCondition, load, size, user/],
    [{ ...good, value: NaN }, /\.value must be a value JSON can hold: NaN/],
    [{ ...good, value: [1, { x: Infinity }] }, /Infinity/],
    [{ ...good, value: () => 1 }, /\.value must be a value JSON can hold, not function/],
    [{ ...good, value: 1n }, /\.value must be a value JSON can hold/],
    [{ ...good, value: circular }, /\.value must be a value JSON can hold/],
    [{ ...good, policy: 'copy' }, /\.policy must be an object/],
    [{ ...good, policy: { onSplit: 'copy' } }, /policy has no 'onSplit'; known: split, merge, delete, pieceName/],
    [{ ...good, policy: { merge: 'both' } }, /policy\.merge is one of union, first, second, error, drop/],
    [{ ...good, policy: { pieceName: 1 } }, /pieceName must be a string/],
  ];
  for (const [attribute, message] of attributes) {
    const error = await meshError('INVALID_ARGUMENT', () => resultModel(result, [withAttribute(attribute), other]), MeshError);
    assert.match(error.message, message);
  }
  const { measures } = await meshError('INVALID_ARGUMENT', () => withAttribute({ name: 'x', targets: [face(9)] }).measures(), MeshError);
  assert.equal(measures, undefined);

  const part = mortise.prepare(other);
  const calls = [
    [() => resultModel(mesh, [mesh]), /takes what an operation answered/],
    [() => resultModel(result, mesh), /an array of the operands second/],
    [() => resultModel(result, [mesh]), /the provenance is not that of this mesh made from these operands/],
    [() => resultModel(result, [other, { ...mesh, triangles: mesh.triangles.subarray(0, 6) }]), /the provenance is not that/],
    [() => resultModel({ ...result, provenance: { ...result.provenance, flipped: new Uint8Array(3) } }, [mesh, other]), /about \d+ triangles, but there are/],
    [() => resultModel({ ...result, provenance: { ...result.provenance, otherSourceBegin: new Uint32Array(2) } }, [mesh, other]), /the provenance is not that/],
    [() => resultModel({ ...result, provenance: { ...result.provenance, coveringSets: [] } }, [mesh, other]), /the provenance is not that/],
    [() => resultModel({ ...result, provenance: {} }, [mesh, other]), /must be the provenance of a result/],
    [() => resultModel(imprint(mesh, other).operands[0], [mesh, other]), /give its model only, not 2/],
    [() => resultModel(result, [mesh, part]), /operands\[1\] is a prepared operand/],
    [() => resultModel(result, [mesh, part.at([])]), /operands\[1\] is a prepared operand/],
    [() => resultModel(result, [mesh, other], { names: ['a'] }), /names must be 2 strings/],
    [() => resultModel(result, [mesh, other], { attributesOf: [2] }), /attributesOf must be an array of operands 0 to 1/],
    [() => resultModel(result, [mesh, other], { splitAtAttributes: 1 }), /splitAtAttributes must be true or false/],
    [() => resultModel(result, [mesh, other], { graphEdges: 'yes' }), /graphEdges must be true or false/],
    [() => resultModel(result, [mesh, other], { sources: {} }), /unknown option 'sources'/],
    [() => resultModel(result, [mesh, other]).sourcesOf(face(99)), /the model has no face 99/],
    [() => resultModel(result, [mesh, other]).partsOf(2, face(0)), /operand must be a number below 2, not number 2/],
    [() => resultModel(result, [mesh, other]).partsOf(0, face(6)), /the model has no face 6: there are 6/],
    [() => union(model(mesh), other), /pass its \.mesh/],
  ];
  for (const [call, message] of calls) assert.match((await meshError('INVALID_ARGUMENT', call, MeshError)).message, message);
  part.dispose();
  const bad = { positions: mesh.positions, triangles: Uint32Array.from([...mesh.triangles, 0, 0, 1]) };
  const error = await meshError('INVALID_ARGUMENT', () => resultModel(union(mesh, bad), [mesh, bad]), MeshError);
  assert.deepEqual([error.details.operand, error.details.kind, error.details.ids], [1, 'faces', [12]]);
});
