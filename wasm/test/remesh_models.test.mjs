// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshed models: equal numbers, names that stay where they were, in further calls, in files and from the command.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { load, MeshError } from 'mortise';

import { cube, meshError, run, soupOf, temporaryFolder } from './support.mjs';

const { gmshProject, inspect, make, model, partition, predictTriangles, quality, readMesh, readModel, remesh, resultModel, sizing, subtract, transform, union, writeMesh, writeModel } = await load();

const close = (found, expected, within, what) => assert.ok(Math.abs(found - expected) <= within * Math.abs(expected), `${what ?? ''} ${found} instead of ${expected}`);
const entity = (dimension, ...ids) => ids.map((id) => ({ dimension, id }));
const named = (m) => m.measures().filter(({ name }) => !/^(face|region) \d+$/.test(name));
const notOfMesh = ['meshVertex', 'pathBegin', 'path', 'triangleFace', 'vertexDimension', 'vertexEntity', 'edgeLength', 'faceArea', 'regionVolume'];
const size = 0.3, radius = 1, around = 24;

/** What bounds what, without the mesh. */
const topologyOf = ({ tables }) => Object.fromEntries(Object.entries(tables).filter(([name]) => !notOfMesh.includes(name)));

/** A named plate and a named pin through it. */
function plateAndPin() {
  const plate = model(make('box', { lo: [0, 0, 0], hi: [4, 4, 1] }));
  plate.attributes.push(
    { name: 'plate', kind: 'material', value: { rho: 7850 }, targets: entity('region', 1) },
    { name: 'sides', targets: entity('face', 2, 3) },
    { name: 'deck', targets: entity('face', 1) },
    { name: 'rim', targets: entity('edge', 0) },
    { name: 'corner', targets: entity('vertex', 0) },
  );
  const pin = model(transform(make('cylinder', { radius, height: 3, around }), [{ translate: [2, 2, -1] }]));
  const side = [0, 1, 2].find((f) => pin.face(f).area > 4);
  pin.attributes.push({ name: 'hole', targets: entity('face', side) }, { name: 'pin', targets: entity('region', 1) });
  return [plate, pin];
}

/** The plate without the pin. */
function drilledPlate(options) {
  const operands = plateAndPin();
  return { operands, drilled: resultModel(subtract(...operands.map(({ mesh }) => mesh)), operands, options) };
}

/** Counts, lengths and areas within straight edges are those before, what ends at the hole is within what chords cut off. */
function checkNames(found, before) {
  assert.deepEqual(found.map(({ name }) => name), before.map(({ name }) => name));
  found.forEach(({ name, vertices, length, area, volume }, i) => {
    // Between a chord of length 0.3 and its arc is 1 % of the radius.
    const within = ['hole', 'plate', 'deck'].includes(name) ? 0.01 : 1e-12;
    assert.equal(vertices, before[i].vertices, name);
    close(length, before[i].length, 1e-12, name);
    close(area, before[i].area, within, name);
    close(volume, before[i].volume, within, name);
  });
}

test('a remeshed model has the same entities, numbers and attributes', () => {
  for (const seams of ['none', 'annulus', 'disc']) {
    const { drilled } = drilledPlate({ seams });
    const { model: fine, mesh, modelFaces, after } = remesh(drilled, { size });
    assert.deepEqual(topologyOf(fine), topologyOf(drilled), seams);
    assert.deepEqual(fine.attributes, drilled.attributes);
    assert.notEqual(fine.attributes, drilled.attributes, 'changes of one are none of the other');
    assert.equal(fine.mesh, mesh);
    assert.deepEqual(fine.triangleFace, modelFaces);
    assert.equal(fine.counts.triangles, after.triangles);
    checkNames(fine.measures(), drilled.measures());
    for (let v = 0; v < fine.counts.modelVertices; ++v) {
      const places = [fine, drilled].map((m) => [...m.mesh.positions.slice(3 * m.vertex(v).meshVertex, 3 * m.vertex(v).meshVertex + 3)]);
      assert.deepEqual(places[0], places[1]);
    }
    const { closed, selfIntersections } = inspect(mesh);
    assert.deepEqual([closed, selfIntersections], [true, 0]);
  }
});

test('files of it have the names with their measures', () => {
  const { drilled } = drilledPlate();
  const before = named(drilled);
  const { model: fine } = remesh(drilled, { size });
  for (const format of ['msh', 'msh22', 'mesh', 'vtu', 'vtk']) {
    const back = readModel(writeModel(fine, { format }), { format });
    // Only MSH 4.1 knows regions by their faces.
    checkNames(named(back), before.filter(({ volume }) => format === 'msh' || volume === 0));
    assert.equal(back.counts.modelFaces, fine.counts.modelFaces, format);
  }
  for (const format of ['inp', 'bdf']) assert.match(new TextDecoder().decode(writeModel(fine, { format })), /deck/);
  assert.match(gmshProject(fine, { meshFile: 'fine.msh' }).script, /"plate"/);
});

test('it goes into every call that takes models', () => {
  const { drilled } = drilledPlate();
  const { model: fine } = remesh(drilled, { size });
  const coarse = remesh(fine, { size: 0.6 });
  assert.deepEqual(topologyOf(coarse.model), topologyOf(drilled));
  assert.ok(coarse.after.triangles < fine.counts.triangles / 2);
  const straight = (m) => m.measures().filter(({ name }) => ['sides', 'rim', 'corner'].includes(name));
  checkNames(straight(coarse.model), straight(drilled));
  const box = make('box', { lo: [-1, -1, 0.5], hi: [5, 5, 3] });
  const halved = resultModel(subtract(fine.mesh, box), [fine, box]);
  const sides = halved.measures().find(({ name }) => name === 'sides');
  close(sides.area, 4, 1e-12);
  assert.ok(!halved.attributes.some(({ name }) => name === 'deck'), 'it was cut off');
  const deck = fine.attributes.find(({ name }) => name === 'deck').targets[0];
  assert.deepEqual(halved.partsOf(0, deck), []);
  const local = sizing({ size: 1, sources: [{ model: fine, entity: deck, size: 0.1 }], mesh: fine.mesh });
  assert.equal(local.sizeAt([0, 0, 1]), 0.1, 'at a corner of the deck');
  local.dispose();
  const { deviation } = quality({ ...coarse, refinement: undefined }, { size: 0.6, reference: fine });
  assert.equal(deviation.byFace.length, fine.counts.modelFaces);
  assert.ok(deviation.byFace.every(({ to, from }) => Math.max(to, from) < 0.2), 'faces are compared with those of their number');
});

test('the model of a result keeps its interfaces and lineage', () => {
  const [plate, pin] = plateAndPin();
  const divided = resultModel(partition(plate.mesh, pin.mesh), [plate, pin], { names: ['plate', 'pin'] });
  divided.attributes.push(...divided.interfaces);
  const { model: fine } = remesh(divided, { size });
  assert.deepEqual(topologyOf(fine), topologyOf(divided));
  assert.deepEqual(fine.interfaces, divided.interfaces);
  assert.ok(fine.interfaces.some(({ name }) => /^interface\(plate\.\w+, pin\.hole\)$/.test(name)), fine.interfaces.map(({ name }) => name).join(' '));
  for (let id = 0; id < fine.counts.modelFaces; ++id) assert.deepEqual(fine.sourcesOf(entity('face', id)[0]), divided.sourcesOf(entity('face', id)[0]));
  assert.deepEqual(fine.partsOf(0, entity('region', 1)[0]), divided.partsOf(0, entity('region', 1)[0]));
  const back = readModel(writeModel(fine, { format: 'msh' }), { format: 'msh' });
  const names = named(divided).map(({ name }) => name);
  assert.deepEqual(named(back).map(({ name }) => name), names);
  // All three regions together are the plate and what of the pin is outside it.
  const volume = (m) => m.tables.regionVolume.slice(1).reduce((sum, v) => sum + v, 0);
  close(volume(fine), volume(divided), 0.01);
  close(volume(back), volume(fine), 1e-12);
});

test('what made the model still holds: chosen edges, joined labels, soups', () => {
  const split = model(cube(), { userEdges: [[0, 3]] });
  assert.equal(split.counts.modelFaces, 7);
  const { model: fine } = remesh(split, { size: 0.2 });
  assert.deepEqual(topologyOf(fine), topologyOf(split));
  close(fine.face(0).area, 0.5, 1e-12);
  const labelled = { ...cube(), faceLabels: Uint32Array.of(0, 1, ...Array(10).fill(0)), labelNames: ['a', 'b'] };
  const joined = model(labelled, { splitAtLabels: false });
  const both = remesh(joined, { size: 0.2 });
  assert.equal(new Set(both.modelFaces).size, 6);
  assert.deepEqual(both.model.attributes.map(({ name, targets }) => [name, targets]), joined.attributes.map(({ name, targets }) => [name, targets]));
  const soup = model(soupOf(cube()));
  const open = remesh(soup, { size: 0.5 });
  assert.equal(open.model.counts.modelFaces, soup.counts.modelFaces);
  close(open.after.area, 6, 1e-12);
  const empty = remesh(model({ positions: [], triangles: [] }), { size: 1 });
  assert.deepEqual(empty.model.counts, model({ positions: [], triangles: [] }).counts);
});

test('sources, zones and layers are about the model', () => {
  const { drilled, operands } = drilledPlate({ seams: 'none' });
  const curved = { size: 0.6, sources: [{ curvature: { perTurn: 48 } }] };
  assert.equal(predictTriangles(drilled, curved), remesh(drilled, curved).predicted);
  assert.ok(predictTriangles(drilled, curved) > 1.2 * predictTriangles(drilled, { size: 0.6 }));
  const { model: layered, sources } = remesh(drilled, { size, layers: 1 });
  const result = subtract(...operands.map(({ mesh }) => mesh));
  const same = remesh(result, { operands: operands.map(({ mesh }) => mesh), size, layers: 1 });
  assert.deepEqual(layered.mesh, same.mesh, 'creases are those of the operands');
  assert.deepEqual(sources, same.sources);
  const { mesh } = remesh(drilled, { size, zone: new Uint8Array(drilled.counts.triangles) });
  assert.deepEqual(mesh.triangles.length, drilled.mesh.triangles.length);
});

test('with small features merged a model has other entities, and the same names', (t) => {
  const block = model(make('box', { lo: [0, 0, 0], hi: [2, 1, 1] }), { edgeAngle: 30 });
  const bottom = [0, 1, 2, 3, 4, 5].find((f) => Math.abs(block.face(f).area - 2) < 1e-9);
  block.attributes.push({ name: 'steel', kind: 'material', targets: entity('region', 1) }, { name: 'floor', targets: entity('face', bottom) });
  const slot = make('box', { lo: [1, -1, 0.5], hi: [1.001, 2, 2] });
  const slotted = resultModel(subtract(block.mesh, slot), [block, slot]);
  const { model: closed, merged, mesh } = remesh(slotted, { size: 0.3, features: 'merge', minFeature: 0.01 });
  assert.ok(slotted.counts.modelFaces > 6 && merged.gone.length > 0);
  assert.deepEqual([closed.counts.modelFaces, closed.counts.modelEdges, closed.counts.modelVertices], [6, 12, 8]);
  assert.equal(closed.mesh, mesh);
  const measured = (name) => named(closed).find((m) => m.name === name);
  close(measured('steel').volume, 2, 0.01);
  close(measured('floor').area, 2, 0.01);
  const cwd = temporaryFolder(t);
  writeModel(join(cwd, 'slotted.msh'), slotted);
  const { code, out, err } = run(['remesh', 'slotted.msh', '-o', 'closed.msh', '--size', '0.3', '--features', 'merge', '--min-feature', '0.01'], { cwd });
  assert.equal(code, 0, err);
  assert.match(out, /\d+ triangles had features below the least one and are gone/);
  const back = readModel(join(cwd, 'closed.msh'));
  assert.equal(back.counts.modelFaces, 7, 'in a file all faces have names, and the two on either side of the slot have two');
  assert.deepEqual(named(back).map(({ name }) => name).sort(), ['floor', 'steel']);
});

test('what does not go with a model is refused', async () => {
  const box = model(cube());
  const message = async (call) => (await meshError('INVALID_ARGUMENT', call, MeshError)).message;
  for (const [name, value] of [['featureAngle', 40], ['curveAngle', 45], ['operands', [cube()]]]) {
    assert.equal(await message(() => remesh(box, { size: 1, [name]: value })), `a model says itself what its faces and edges are: leave out ${name}`);
    assert.match(await message(() => predictTriangles(box, { size: 1, [name]: value })), /leave out/);
  }
  assert.match(await message(() => quality(cube(), { size: 1, reference: box, operands: [cube()] })), /operands are those of a reference that is a result/);
  assert.match(await message(() => remesh(box, { size: 1, layers: 2 })), /^layers are those round the graph of a result/);
  const { drilled } = drilledPlate();
  const { model: fine } = remesh(drilled, { size });
  assert.match(await message(() => remesh(fine, { size, layers: 2 })), /^layers are those round the graph of a result/, 'the triangles of the result are gone');
  box.attributes.push({ name: 'x', targets: entity('face', 6) });
  assert.match(await message(() => remesh(box, { size: 1 })), /model\.attributes\[0\]\.targets\[0\]: the model has no face 6/);
});

test('tables that were spoilt are refused by name', async () => {
  const spoilers = {
    edgeStart: (t) => t.fill(99),
    faceBehind: (t) => t.fill(9),
    loopStart: (t) => t.fill(99),
    loopsOfFaceBegin: (t) => t.reverse(),
    usesOfLoopBegin: (t) => t.fill(0),
    useEdge: (t) => t.fill(12),
    shellRegion: (t) => t.fill(2),
    sideFace: (t) => t.fill(6),
    shellsOfRegion: (t) => t.fill(2),
    edgesOfVertexBegin: (t) => t.set([5], 0),
    faceOfEdge: (t) => t.fill(6),
    meshVertex: (t) => t.fill(1e6),
    path: (t) => t.fill(1e6),
    pathBegin: (t) => t.fill(t.at(-1), 1),
    triangleFace: (t) => t.fill(6),
    vertexDimension: (t) => t.fill(3),
    vertexEntity: (t) => t.fill(1e6),
  };
  for (const [name, spoil] of Object.entries(spoilers)) {
    const { model: fine } = remesh(model(cube()), { size: 0.5 });
    spoil(fine.tables[name]);
    const { message } = await meshError('INVALID_ARGUMENT', () => writeModel(fine, { format: 'msh' }), MeshError);
    assert.match(message, /^the tables of the model are not those of its mesh: /, name);
  }
});

/** A folder with the named plate in several formats and a pin through it. */
function files(t) {
  const cwd = temporaryFolder(t);
  const [plate, pin] = plateAndPin();
  for (const format of ['msh', 'mesh', 'vtu']) writeFileSync(join(cwd, `plate.${format}`), writeModel(plate, { format }));
  writeFileSync(join(cwd, 'pin.msh'), writeModel(pin, { format: 'msh' }));
  writeFileSync(join(cwd, 'pin.stl'), writeMesh(pin.mesh, { format: 'stl' }));
  return cwd;
}

/** Runs the command, which must succeed, and gives what it printed. */
function done(cwd, ...args) {
  const { code, out, err } = run(args, { cwd });
  assert.equal(code, 0, err);
  return out;
}

test('the command keeps the names in a file it remeshes', (t) => {
  const cwd = files(t);
  const before = named(readModel(join(cwd, 'plate.msh')));
  for (const [from, to] of [['msh', 'msh'], ['msh', 'mesh'], ['mesh', 'msh'], ['vtu', 'vtu']]) {
    const report = JSON.parse(done(cwd, 'remesh', `plate.${from}`, '-o', `fine.${to}`, '--size', '0.4', '--json'));
    const fine = readModel(join(cwd, `fine.${to}`));
    assert.equal(fine.counts.triangles, report.triangles);
    assert.ok(report.triangles > 400 && report.after.minAngleDeg > 30);
    for (const row of named(fine)) {
      const { area, length, vertices } = before.find(({ name }) => name === row.name);
      assert.equal(row.vertices, vertices);
      close(row.area, area, 1e-12);
      close(row.length, length, 1e-12);
    }
    const kept = named(fine).map(({ name }) => name);
    for (const name of ['deck', 'rim', 'sides']) assert.ok(kept.includes(name), `${from} to ${to}: ${name} is not among ${kept.join(', ')}`);
  }
  assert.deepEqual(named(readModel(join(cwd, 'fine.msh'))).map(({ name }) => name), named(readModel(join(cwd, 'plate.mesh'))).map(({ name }) => name));
  done(cwd, 'remesh', 'plate.msh', '-o', 'fine.geo', '--size', '0.4', '-q');
  assert.ok(existsSync(join(cwd, 'fine.msh')) && /"plate"/.test(readFileSync(join(cwd, 'fine.geo'), 'utf8')));
  done(cwd, 'remesh', 'plate.msh', '-o', 'fine.nas', '--size', '0.4', '-q');
  assert.match(readFileSync(join(cwd, 'fine.nas'), 'utf8'), /"sides"/);
  done(cwd, 'remesh', 'plate.msh', '-o', 'fine.obj', '--size', '0.4', '-q');
  assert.ok(readMesh(join(cwd, 'fine.obj')).labelNames.includes('deck'));
  const piped = run(['remesh', '-', '-o', '-', '--format', 'msh', '--size', '0.4', '-q'], { cwd, input: readFileSync(join(cwd, 'plate.msh')) });
  done(cwd, 'remesh', 'plate.msh', '-o', 'again.msh', '--size', '0.4', '-q');
  assert.equal(piped.out, readFileSync(join(cwd, 'again.msh'), 'utf8'));
  assert.equal(run(['remesh', 'plate.msh', '-o', 'x.msh', '--size', '0.4', '--feature-angle', '200'], { cwd }).code, 2);
});

test('the command keeps names of results it remeshes, and cuts by planes', (t) => {
  const cwd = files(t);
  for (const [verb, ...more] of [['union'], ['subtract', '--interfaces'], ['partition', '--interfaces', '--name-regions']]) {
    done(cwd, verb, 'plate.msh', 'pin.msh', '-o', 'raw.msh', '-q', ...more);
    const out = done(cwd, verb, 'plate.msh', 'pin.msh', '-o', 'fine.msh', '--remesh', '0.3', ...more);
    assert.match(out, /after: .* triangles/);
    const [raw, fine] = ['raw.msh', 'fine.msh'].map((file) => readModel(join(cwd, file)));
    assert.ok(fine.counts.triangles > 2 * raw.counts.triangles);
    assert.deepEqual(named(fine).map(({ name }) => name), named(raw).map(({ name }) => name), verb);
    named(fine).forEach(({ name, area, length }, i) => {
      close(area, named(raw)[i].area, 0.01, name);
      close(length, named(raw)[i].length, 0.01, name);
    });
  }
  done(cwd, 'subtract', 'plate.msh', 'pin.stl', '-o', 'near.msh', '--remesh', '0.3', '--layers', '2', '-q');
  assert.ok(named(readModel(join(cwd, 'near.msh'))).some(({ name }) => name === 'sides'));
  done(cwd, 'intersect', 'plate.msh', '--plane', '0,0,1,0.5', '-o', 'low.msh', '--remesh', '0.3', '-q');
  close(named(readModel(join(cwd, 'low.msh'))).find(({ name }) => name === 'sides').area, 4, 1e-12);
  done(cwd, 'intersect', 'plate.msh', '--plane', '0,0,1,0.5', '-o', 'low.ply', '--remesh', '0.3', '-q');
  close(inspect(readMesh(join(cwd, 'low.ply'))).volume, 8, 1e-12);
  done(cwd, 'union', 'plate.msh', 'pin.stl', '-o', 'both.geo', '--remesh', '0.5', '-q');
  assert.match(readFileSync(join(cwd, 'both.geo'), 'utf8'), /"plate"/);
});

test('an operand without a model still has its names where it is remeshed: by labels', (t) => {
  const cwd = files(t);
  const flat = cube(10);
  const repeated = { positions: flat.positions, triangles: Uint32Array.of(...flat.triangles, 0, 0, 1) };
  writeMesh(join(cwd, 'flat.off'), repeated);
  const out = done(cwd, 'union', 'plate.msh', 'flat.off', '-o', 'both.msh', '--remesh', '0.5');
  assert.match(out, /names are those of faces only: operand 1/);
  assert.ok(named(readModel(join(cwd, 'both.msh'))).some(({ name }) => name === 'deck'));
});
