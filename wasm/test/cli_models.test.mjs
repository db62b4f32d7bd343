// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The command keeps names: operations on files of models, models as files, projects for Gmsh.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { load } from 'mortise';

import { cube, run, temporaryFolder } from './support.mjs';

const { make, model, readMesh, readModel, writeMesh, writeModel } = await load();

const entity = (dimension, ...ids) => ids.map((id) => ({ dimension, id }));
const namesOf = (m) => m.attributes.map(({ name }) => name).filter((name) => !/^(face|region) \d+$/.test(name));

/** A folder with a named box in MSH, a cylinder through it in STL and a sheet in MSH. */
function files(t) {
  const cwd = temporaryFolder(t);
  const box = model(make('box', { lo: [0, 0, 0], hi: [4, 4, 1] }));
  box.attributes.push({ name: 'plate', targets: entity('region', 1) }, { name: 'sides', targets: entity('face', 2, 3) }, { name: 'rim', targets: entity('edge', 0) });
  writeFileSync(join(cwd, 'plate.msh'), writeModel(box, { format: 'msh' }));
  for (const args of [['cylinder', '-o', 'up.stl', '--around', '12', '--height', '3'], ['box', '-o', 'away.off']]) assert.equal(run(['make', ...args, '--quiet'], { cwd }).code, 0);
  assert.equal(run(['transform', 'up.stl', '-o', 'pin.stl', '--translate', '2,2,-1', '--quiet'], { cwd }).code, 0);
  return cwd;
}

/** Runs the command, which must succeed, and gives what it printed. */
function done(cwd, ...args) {
  const { code, out, err } = run(args, { cwd });
  assert.equal(code, 0, err);
  return out;
}

test('operations keep names end to end', (t) => {
  const cwd = files(t);
  const steps = [['union', ['plate', 'rim', 'sides']], ['subtract', ['plate', 'rim', 'sides']], ['partition', ['plate', 'rim', 'sides']], ['implant', ['plate', 'rim', 'sides']], ['intersect', ['plate']]];
  for (const [verb, names] of steps) {
    done(cwd, verb, 'plate.msh', 'pin.stl', '-o', `${verb}.msh`, '--quiet');
    assert.deepEqual(namesOf(readModel(join(cwd, `${verb}.msh`))), names, verb);
  }
  for (const ending of ['vtu', 'mesh', 'vtk']) {
    done(cwd, 'subtract', 'plate.msh', 'pin.stl', '-o', `out.${ending}`, '--quiet');
    done(cwd, 'union', `out.${ending}`, 'away.off', '-o', `next.${ending}`, '--quiet');
    assert.deepEqual(namesOf(readModel(join(cwd, `next.${ending}`))).slice(-2), ['rim', 'sides'], ending);
  }
  done(cwd, 'subtract', 'plate.msh', 'pin.stl', '-o', 'out.nas', '--quiet');
  assert.match(readFileSync(join(cwd, 'out.nas'), 'utf8'), /"sides"/);
  const hole = readModel(join(cwd, 'subtract.msh'));
  assert.equal(hole.counts.modelFaces, 7);
  assert.equal(hole.measures().find(({ name }) => name === 'plate').volume, hole.region(1).volume);
  assert.equal(run(['subtract', 'plate.msh', 'pin.stl', '-o', '-', '--format', 'msh', '--quiet'], { cwd }).out, readFileSync(join(cwd, 'subtract.msh'), 'utf8'));
  done(cwd, 'imprint', 'plate.msh', 'pin.stl', '-o', 'part-%d.msh', '--quiet');
  const part = readModel(join(cwd, 'part-1.msh'));
  assert.deepEqual([part.counts.modelFaces, ...namesOf(part)], [8, 'plate', 'rim', 'sides'], 'two faces are parted by the pin');
});

test('regions and interfaces are named on request', (t) => {
  const cwd = files(t);
  done(cwd, 'partition', 'plate.msh', 'pin.stl', '-o', 'out.geo', '--name-regions', '--interfaces', '--quiet');
  const script = readFileSync(join(cwd, 'out.geo'), 'utf8');
  assert.match(script, /^Merge "out\.msh";\n/);
  assert.equal(script.match(/^Volume\(/gm).length, 4);
  for (const name of ['plate', 'pin']) assert.match(script, new RegExp(`^Physical Volume\\("${name}", \\d\\)`, 'm'));
  const names = namesOf(readModel(join(cwd, 'out.msh')));
  assert.ok(names.some((name) => /^interface\(plate\.face \d+, pin\.face \d\)$/.test(name)), names.join());
  assert.deepEqual(readdirSync(cwd).filter((name) => /out|part$/.test(name)), ['out.geo', 'out.msh']);
  for (const [file, lo, hi] of [['left', [0, 0, 0], [1, 1, 1]], ['right', [1, 0, 0], [2, 1, 1]]]) writeFileSync(join(cwd, `${file}.ply`), writeMesh(make('box', { lo, hi }), { format: 'ply' }));
  done(cwd, 'partition', 'left.ply', 'right.ply', '-o', 'wall.msh', '--interfaces', '--quiet');
  const [wall, ...others] = readModel(join(cwd, 'wall.msh')).measures().filter(({ name }) => /^interface/.test(name));
  assert.deepEqual([wall.area, wall.length, others], [1, 0, []], 'no names for the rim of the wall');
  const coarse = ['union', 'plate.msh', 'pin.stl', '-o', 'coarse.msh', '--quiet'];
  done(cwd, ...coarse);
  const { modelFaces } = readModel(join(cwd, 'coarse.msh')).counts;
  done(cwd, ...coarse, '--face-angle', '20');
  assert.ok(readModel(join(cwd, 'coarse.msh')).counts.modelFaces > modelFaces, 'every side of the pin is a face');
});

test('an operand that has no model leaves labels, and the report says so', (t) => {
  const cwd = files(t);
  const box = cube();
  writeFileSync(join(cwd, 'bad.off'), `OFF\n8 13 0\n${Array.from({ length: 8 }, (_, v) => box.positions.subarray(3 * v, 3 * v + 3).join(' ')).join('\n')}\n${Array.from({ length: 12 }, (_, f) => `3 ${box.triangles.subarray(3 * f, 3 * f + 3).join(' ')}`).join('\n')}\n3 0 0 1\n`);
  const { notes } = JSON.parse(done(cwd, 'union', 'plate.msh', 'bad.off', '-o', 'out.msh', '--json'));
  assert.ok(notes.some((note) => /^names are those of faces only: operand 1: triangles repeat a vertex/.test(note)), notes.join());
  assert.deepEqual(namesOf(readModel(join(cwd, 'out.msh'))), ['sides']);
});

test('mortise model writes models, and prints counts and names', (t) => {
  const cwd = files(t);
  const printed = done(cwd, 'model', 'plate.msh', '-o', 'copy.vtu');
  assert.match(printed, /^faces {9}6\n/m);
  assert.match(printed, /^names {9}face 1 {2}area 16\n/m);
  assert.match(printed, /^ {14}plate {2}volume 16\n/m);
  const counts = { triangles: 12, modelFaces: 6, modelEdges: 12, modelVertices: 8, regions: 1, voids: 0, meshEdgesOnModelEdges: 12 };
  for (const file of ['plate.msh', 'copy.vtu']) {
    const json = JSON.parse(done(cwd, 'model', file, '--json'));
    assert.deepEqual(json.counts, counts);
    assert.ok(json.attributes.some(({ name, targets }) => name === 'sides' && targets.length === 2));
  }
  done(cwd, 'model', 'pin.stl', '-o', 'pin.geo', '--name-regions', '--quiet');
  assert.match(readFileSync(join(cwd, 'pin.geo'), 'utf8'), /^Physical Volume\("pin", 1\) = \{1\};$/m);
  assert.equal(existsSync(join(cwd, 'pin.msh')), true);
  const piped = run(['model', '-', '-o', '-', '--format', 'msh22'], { cwd, input: readFileSync(join(cwd, 'plate.msh')) });
  assert.deepEqual(namesOf(readModel(piped.bytes)), ['rim', 'sides']);
  assert.match(piped.err, /^faces {9}6\n/m);
  assert.equal(readMesh(piped.bytes).labelNames.includes('sides'), true);
});

test('exit codes of models', (t) => {
  const cwd = files(t);
  const refused = [
    [2, ['model', 'plate.msh', '-o', 'out.stl'], /a model is written as \.msh, \.vtk, .* not as stl/],
    [2, ['model', 'plate.msh', '-o', '-'], /-o - needs --format/],
    [2, ['model', 'plate.msh', '-o', '-', '--format', 'geo'], /two files/],
    [2, ['union', 'plate.msh', 'pin.stl', '--format', 'geo', '-o', '-'], /two files/],
    [2, ['union', 'plate.msh', 'pin.stl', '-o', 'out.ply', '--interfaces'], /--interfaces needs an output that keeps models/],
    [2, ['union', 'plate.msh', 'pin.stl', '-o', 'out.ply', '--face-angle', '30'], /--face-angle needs an output that keeps models/],
    [2, ['union', 'plate.msh', 'pin.stl', '-o', 'out.msh', '--face-angle', '300'], /between 0 and 180|0 .. 180/],
    [2, ['transform', 'plate.msh', '-o', 'out.geo'], /does not end in/],
    [3, ['model', 'nowhere.msh', '-o', 'out.msh'], /nowhere\.msh/],
  ];
  for (const [code, args, message] of refused) {
    const { code: actual, err } = run(args, { cwd });
    assert.equal(actual, code, `${args.join(' ')}: ${err}`);
    assert.match(err, message);
  }
  assert.deepEqual(readdirSync(cwd).filter((name) => /^out/.test(name)), []);
});
