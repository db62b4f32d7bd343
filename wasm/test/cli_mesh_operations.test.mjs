// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The verbs split, repair, extrude and slice.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { load } from 'mortise';

import { cube, run, temporaryFolder } from './support.mjs';

const mortise = await load();

/** A folder with two cubes that touch along an edge, in one file, and an open cube. */
function files(t) {
  const cwd = temporaryFolder(t);
  mortise.writeMesh(join(cwd, 'pair.obj'), mortise.union(cube(), cube(1, 1, 0)).mesh);
  mortise.writeMesh(join(cwd, 'apart.ply'), mortise.union(cube(), cube(3)).mesh);
  const open = cube();
  open.triangles = open.triangles.subarray(6);
  mortise.writeMesh(join(cwd, 'open.obj'), open);
  mortise.writeMesh(join(cwd, 'sheet.off'), mortise.make('gridSheet', { width: 2 }));
  return cwd;
}

/** Runs, expects success, gives what was printed. */
function out(cwd, ...args) {
  const done = run(args, { cwd });
  assert.equal(done.code, 0, done.err);
  return done.out;
}

test('split writes a file for every part and lists them', (t) => {
  const cwd = files(t);
  assert.equal(out(cwd, 'split', 'apart.ply', '-o', 'part-%d.stl'), 'part-1.stl  12 triangles, volume 1, area 6\npart-2.stl  12 triangles, volume 1, area 6\n');
  assert.equal(mortise.inspect(mortise.readMesh(join(cwd, 'part-2.stl'))).volume, 1);
  const { parts } = JSON.parse(out(cwd, 'split', 'pair.obj', '-o', 'solid%d.off', '--by', 'regions', '--json'));
  assert.deepEqual(parts, [1, 2].map((i) => ({ name: `solid${i}.off`, triangles: 12, volume: 1, area: 6 })));
  assert.equal(out(cwd, 'split', 'pair.obj', '-o', 'one%d.off', '--quiet'), '');
  assert.deepEqual(readdirSync(cwd).filter((name) => name.startsWith('one')), ['one1.off'], 'an edge joins components');
  assert.match(out(cwd, 'split', 'open.obj', '-o', 'p%d.obj'), /^p1\.obj {2}10 triangles, open, area 5\n$/);
});

test('repair says what it did', (t) => {
  const cwd = files(t);
  const report = JSON.parse(out(cwd, 'repair', 'open.obj', '-o', 'out.ply', '--fill-planar-holes', '--orient', '--json'));
  assert.deepEqual([report.closed, report.volume, report.notes], [true, 1, ['--fill-planar-holes: 1 hole']]);
  assert.match(out(cwd, 'repair', 'sheet.off', '-o', 'same.off', '--fill-planar-holes'), /^notes +--fill-planar-holes: 1 hole left open: the filling would lie/m);
  assert.match(out(cwd, 'repair', 'pair.obj', '-o', 'pinch.obj', '--split-pinches'), /^notes +--split-pinches: 2 copied corners$/m);
  assert.equal(readFileSync(join(cwd, 'pinch.obj'), 'utf8').match(/^v /gm).length, 16);
});

test('extrude makes a solid', (t) => {
  const cwd = files(t);
  assert.equal(JSON.parse(out(cwd, 'extrude', 'sheet.off', '-o', 'out.ply', '--to-z', '-1.5', '--json')).volume, 3);
  const refused = run(['extrude', 'open.obj', '-o', 'no.ply', '--to-z', '-1'], { cwd });
  assert.match(refused.err, /^mortise: open\.obj: .*\n {2}faces: /);
  assert.equal(existsSync(join(cwd, 'no.ply')), false);
});

test('slice writes closed polylines or JSON', (t) => {
  const cwd = files(t);
  assert.equal(out(cwd, 'slice', 'apart.ply', '-o', 'cut.obj', '--plane', '0,0,1,0.5'), 'slice         cut.obj\npolygons      2\narea          2\n');
  const obj = readFileSync(join(cwd, 'cut.obj'), 'utf8').trim().split('\n');
  const lines = obj.filter((line) => line.startsWith('l ')).map((line) => line.split(' ').slice(1).map(Number));
  assert.equal(lines.length, 2);
  for (const line of lines) assert.equal(line[0], line.at(-1));
  assert.equal(obj.filter((line) => line.startsWith('v ')).length, lines.flat().length - 2);
  const done = run(['slice', 'apart.ply', '-o', '-', '--format', 'json', '--plane', '-1,0,0,-3.5', '--quiet'], { cwd });
  const section = JSON.parse(done.out);
  assert.deepEqual([section.plane, section.area, section.polygons.length], [[-1, 0, 0, -3.5], 1, 1]);
  for (const [x] of section.polygons[0]) assert.equal(x, 3.5);
  const said = JSON.parse(out(cwd, 'slice', 'apart.ply', '-o', 'cut.json', '--plane', '0,0,2,1', '--json'));
  assert.deepEqual(said, { plane: [0, 0, 2, 1], polygons: 2, area: 2, areas: [1, 1] });
});

test('exit code 2 for what is typed wrong, 3 for open meshes', (t) => {
  const cwd = files(t);
  const typed = [
    ['split', 'pair.obj', '-o', 'out.stl'],
    ['split', 'pair.obj', '-o', '%d.stl', '--by', 'colour'],
    ['split', '-o', '%d.stl'],
    ['repair', 'pair.obj', '-o', 'out.stl'],
    ['repair', '-o', 'out.stl', '--orient'],
    ['extrude', 'sheet.off', '-o', 'out.stl'],
    ['extrude', 'sheet.off', '-o', 'out.stl', '--to-z', 'down'],
    ['slice', 'pair.obj', '-o', 'out.obj'],
    ['slice', 'pair.obj', '-o', 'out.stl', '--plane', '0,0,1,0'],
    ['slice', 'pair.obj', '-o', 'out.obj', '--plane', '0,0,1'],
    ['slice', 'pair.obj', '-o', 'out.obj', '--plane', '0,0,0,1'],
    ['slice', '-o', 'out.obj', '--plane', '0,0,1,0'],
  ];
  for (const words of typed) {
    const { code, err } = run(words, { cwd });
    assert.equal(code, 2, `mortise ${words.join(' ')}: ${err}`);
  }
  assert.match(run(['slice', 'open.obj', '-o', 'out.obj', '--plane', '0,0,1,0.5'], { cwd }).err, /^mortise: open\.obj: .*\[NOT_CLOSED\]/);
  assert.equal(run(['split', 'open.obj', '-o', '%d.obj', '--by', 'regions'], { cwd }).code, 3);
  assert.deepEqual(readdirSync(cwd).sort(), ['apart.ply', 'open.obj', 'pair.obj', 'sheet.off']);
});
