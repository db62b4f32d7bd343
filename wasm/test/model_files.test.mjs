// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models and their names in files of analysis programs.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import * as async from 'mortise';

import { cube, meshError, temporaryFolder } from './support.mjs';

const { load, MeshError } = async;
const { gmshProject, intersect, make, model, partition, readModel, resultModel, writeModel } = await load();

const entity = (dimension, ...ids) => ids.map((id) => ({ dimension, id }));
const text = (bytes) => new TextDecoder().decode(bytes);
const namesOf = (m) => m.attributes.map(({ name }) => name).filter((name) => !/^(face|region) \d+$/.test(name));
/** What the names of a model cover, those left out that were made up for what had none. */
const covered = (m) => m.measures().filter(({ name }) => !/^(face|region) \d+$/.test(name));

/** Two boxes that overlap, with names on entities of every dimension. */
function named() {
  const boxes = [make('box', { lo: [0, 0, 0], hi: [2, 2, 2] }), make('box', { lo: [1, 1, 1], hi: [3, 3, 3] })];
  const models = boxes.map((mesh) => model(mesh));
  models[0].attributes.push({ name: 'steel', targets: entity('region', 1) }, { name: 'wet', targets: entity('face', 0, 1, 2, 3, 4, 5) });
  models[1].attributes.push({ name: 'über rim', targets: entity('edge', 0, 1) }, { name: 'corner', targets: entity('vertex', 0, 7) });
  models[1].attributes.push({ name: 'hot', targets: entity('face', 5) }, { name: 'wet', targets: entity('face', 5) });
  return resultModel(partition(boxes), models);
}

test('models with their names come back from every format that is read', () => {
  const m = named(), { triangles, ...counts } = m.counts;
  assert.deepEqual([triangles, counts.modelFaces, counts.modelEdges, counts.modelVertices, counts.regions], [m.mesh.triangles.length / 3, 18, 36, 22, 3]);
  for (const format of ['msh', 'msh22', 'vtk', 'vtu', 'mesh']) {
    const back = readModel(writeModel(m, { format }), { format });
    assert.deepEqual(back.counts, m.counts, format);
    assert.deepEqual(back.mesh.positions, m.mesh.positions, format);
    const expected = covered(m).filter(({ name }) => format === 'msh' || name !== 'steel');
    assert.deepEqual(covered(back), expected, `${format}: only MSH 4.1 has regions`);
    assert.equal(back.attributes.every(({ kind, value }) => kind === 'user' && value === null), true);
    const again = readModel(writeModel(back, { format }), { format });
    assert.deepEqual(again.measures(), back.measures(), `${format} again`);
  }
});

test('Abaqus and Nastran decks have sets of the names', () => {
  const inp = text(writeModel(named(), { format: 'inp' })), bdf = text(writeModel(named(), { format: 'bdf' }));
  for (const set of [/^\*ELSET, ELSET=wet/m, /^\*ELSET, ELSET=hot/m, /^\*SURFACE, NAME=hot/m, /^\*NSET, NSET=corner/m]) assert.match(inp, set);
  assert.match(bdf, /^\$.*"hot"/m);
  assert.match(bdf, /^\$.*corner/m);
});

test('a project for Gmsh names regions in its script and the rest in its mesh', () => {
  const m = named();
  const { mesh, script } = gmshProject(m, { meshFile: 'two boxes.msh' });
  assert.match(script, /^Merge "two boxes\.msh";\n/);
  assert.equal(script.match(/^Volume\(\d\) = /gm).length, 3);
  assert.match(script, /^Physical Volume\("steel", 1\) = \{\d, \d\};$/m);
  assert.match(script, /^Physical Volume\("region \d", 2\) = \{\d\};$/m);
  assert.deepEqual(namesOf(readModel(mesh)), ['corner', 'hot', 'wet', 'über rim']);
  m.attributes = [{ name: 'two\n"lines"', targets: entity('region', 1) }];
  assert.match(gmshProject(m, { meshFile: 'x.msh' }).script, /^Physical Volume\("two 'lines'", 1\) = \{1\};$/m);
});

test('attributes are the only names: those taken away are gone, labels too', () => {
  const m = model({ ...cube(), faceLabels: new Uint32Array(12).map((_, t) => (t < 2 ? 1 : 0)), labelNames: ['wall', 'inlet'] });
  const written = () => namesOf(readModel(writeModel(m, { format: 'vtu' })));
  assert.deepEqual(written(), ['inlet', 'wall']);
  m.attributes = m.attributes.filter(({ name }) => name === 'inlet');
  assert.deepEqual(written(), ['inlet']);
  m.attributes[0].name = 'outlet';
  assert.deepEqual(written(), ['outlet']);
  m.attributes = [];
  const bare = readModel(writeModel(m, { format: 'msh' }));
  assert.deepEqual(bare.attributes.map(({ name }) => name), ['surface 1', 'surface 2', 'surface 3', 'surface 4', 'surface 5', 'surface 6'], 'faces of a file without names go by their numbers');
});

test('a partition in MSH 4.1 is an operand again, its regions and all', () => {
  const m = named();
  const back = readModel(writeModel(m, { format: 'msh' }));
  const tool = make('box', { lo: [-1, -1, -1], hi: [0.5, 0.5, 0.5] });
  const cut = partition(back.mesh, tool);
  assert.deepEqual(cut.report.operands.map(({ kind }) => kind), ['solid', 'solid']);
  assert.equal(cut.report.volume, 15 + 27 / 8 - 1 / 8);
  const steel = resultModel(cut, [back, tool]).measures().find(({ name }) => name === 'steel');
  assert.equal(steel.volume, 8);
});

test('names go from file to file through an operation', () => {
  const ball = model(make('icosphere', { levels: 2 }));
  ball.attributes.push({ name: 'skin', targets: entity('face', 0) }, { name: 'water', targets: entity('region', 1) });
  for (const [format, names] of [['msh', ['skin', 'water']], ['vtu', ['skin']], ['mesh', ['skin']]]) {
    const first = readModel(writeModel(ball, { format }), { format });
    assert.deepEqual(namesOf(first), names);
    const half = make('box', { lo: [0, -2, -2], hi: [2, 2, 2] });
    const result = intersect(first.mesh, half);
    const m = resultModel(result, [first, half]);
    const back = readModel(writeModel(m, { format }), { format });
    assert.deepEqual(covered(back), covered(m));
    assert.ok(Math.abs(back.measures()[back.measures().length - names.length].area / first.face(0).area - 0.5) < 1e-12);
  }
});

test('faces and lines of a file stay apart where there is no crease', () => {
  const nodes = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]].map(([x, y], i) => `${i + 1} ${x} ${y} 0`);
  const elements = ['1 2 2 5 1 1 2 5', '2 2 2 5 1 1 5 4', '3 2 2 5 1 2 3 6', '4 2 2 5 1 2 6 5', '5 1 2 7 1 2 5', '6 15 2 8 1 1'];
  const file = (names, rows) => `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n${names.length}\n${names.join('\n')}\n$EndPhysicalNames\n$Nodes\n6\n${nodes.join('\n')}\n$EndNodes\n$Elements\n${rows.length}\n${rows.join('\n')}\n$EndElements\n`;
  const bytes = new TextEncoder().encode(file(['2 5 "sheet"', '1 7 "cut"', '0 8 "origin"'], elements));
  const cut = readModel(bytes);
  assert.equal(cut.counts.modelFaces, 2);
  assert.deepEqual(cut.measures(), [{ name: 'cut', vertices: 0, length: 1, area: 0, volume: 0 }, { name: 'origin', vertices: 1, length: 0, area: 0, volume: 0 }, { name: 'sheet', vertices: 0, length: 0, area: 2, volume: 0 }]);
  const whole = readModel(new TextEncoder().encode(file(['2 5 "sheet"'], elements.slice(0, 4))));
  assert.deepEqual([whole.counts.modelFaces, ...namesOf(whole)], [1, 'sheet']);
});

test('any mesh file is read as a model, by path, bytes or Blob, with options of models', async (t) => {
  const folder = temporaryFolder(t);
  const mortise = await load();
  const box = { ...cube(), faceLabels: new Uint32Array(12), labelNames: ['all'] };
  await async.writeMesh(join(folder, 'box.ply'), box);
  const m = readModel(join(folder, 'box.ply'));
  assert.deepEqual([m.counts.modelFaces, m.measures()[0].area, m.mesh.faceLabels.length], [6, 6, 12]);
  assert.equal(readModel(join(folder, 'box.ply'), { faceAngle: 100 }).counts.modelFaces, 1);
  await async.writeModel(join(folder, 'box.msh'), await async.model(box));
  const bytes = readFileSync(join(folder, 'box.msh'));
  assert.equal((await async.readModel(new File([bytes], 'box.msh'))).measures()[0].area, 6);
  assert.equal((await async.readModel(bytes, { seams: 'disc' })).counts.modelFaces, 6);
  assert.equal(text(writeModel(m, { format: 'msh22' })).startsWith('$MeshFormat\n2.2'), true);
  mortise.writeModel(join(folder, 'box.vtk'), m, { format: 'vtu' });
  assert.match(readFileSync(join(folder, 'box.vtk'), 'utf8'), /^<\?xml/);
  assert.deepEqual((await async.gmshProject(m, { meshFile: 'x.msh' })).script.split('\n')[0], 'Merge "x.msh";');
});

test('wrong calls are refused and say what to do', async () => {
  const m = model(cube());
  m.attributes.push({ name: 'x', targets: entity('face', 7) });
  const calls = [
    ['INVALID_ARGUMENT', () => writeModel(cube(), { format: 'msh' }), /writeModel takes what model, resultModel or readModel gives/],
    ['INVALID_ARGUMENT', () => writeModel(async.model(cube()), { format: 'msh' }), /await it first/],
    ['INVALID_ARGUMENT', () => writeModel(model(cube())), /writeModel needs the format/],
    ['INVALID_ARGUMENT', () => writeModel(m, { format: 'msh' }), /model\.attributes\[0\]\.targets\[0\]: the model has no face 7/],
    ['UNKNOWN_FORMAT', () => writeModel(model(cube()), { format: 'stl' }), /the formats are msh, msh22, vtk, vtu, mesh, inp, bdf, not the string "stl"/],
    ['UNKNOWN_FORMAT', () => writeModel('out.ply', model(cube())), /the formats are msh/],
    ['UNKNOWN_FORMAT', () => writeModel('out.step', model(cube())), /does not end in/],
    ['INVALID_ARGUMENT', () => gmshProject(model(cube()), {}), /needs the name of the mesh's file/],
    ['INVALID_ARGUMENT', () => readModel(5), /readModel takes a file name, a Uint8Array/],
    ['INVALID_ARGUMENT', () => readModel(new Uint8Array(), { faceAngel: 3 }), /unknown option 'faceAngel'; known: format, name, faceAngle/],
    ['UNKNOWN_FORMAT', () => readModel(new Uint8Array(), { format: 'inp' }), /the formats are stl/],
    ['PARSE_FAILED', () => readModel(new TextEncoder().encode('$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1\n')), /./],
    ['FILE_FAILED', () => readModel('nowhere.msh'), /cannot read nowhere\.msh/],
  ];
  for (const [code, call, message] of calls) assert.match((await meshError(code, call, MeshError)).message, message);
});
