// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The command: every verb, pipes, order of steps, negative values, exit codes.

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { load } from 'mortise';

import { cube, run, start, temporaryFolder } from './support.mjs';

const mortise = await load();
const version = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8')).version;

/** A folder with the unit cube in a.ply and one moved by a half in b.obj. */
function cubes(t) {
  const folder = temporaryFolder(t);
  mortise.writeMesh(join(folder, 'a.ply'), cube());
  mortise.writeMesh(join(folder, 'b.obj'), cube(0.5, 0.5, 0.5));
  return folder;
}

/** Runs in a folder, expects success, gives the report. */
function report(cwd, ...args) {
  const done = run([...args, '--json'], { cwd });
  assert.equal(done.code, 0, done.err);
  return JSON.parse(done.out);
}

/** The box of a mesh, without signs of zeros. */
function box(mesh) {
  const { min, max } = mortise.inspect(mesh).bbox;
  return { min: min.map((x) => x + 0), max: max.map((x) => x + 0) };
}

test('union, intersect and subtract write a file and a report', (t) => {
  const cwd = cubes(t);
  for (const [verb, volume] of [['union', 1.875], ['intersect', 0.125], ['subtract', 0.875]]) {
    const json = report(cwd, verb, 'a.ply', 'b.obj', '-o', 'out.off');
    assert.equal(json.volume, volume);
    assert.equal(json.certified, true);
    assert.deepEqual(json.operands.map(({ name }) => name), ['a.ply', 'b.obj']);
    assert.equal(mortise.inspect(mortise.readMesh(join(cwd, 'out.off'))).volume, volume);
  }
});

test('xor, partition, combine and keep write a file and a report', (t) => {
  const cwd = cubes(t);
  assert.equal(report(cwd, 'xor', 'a.ply', 'b.obj', '-o', 'out.off').volume, 1.75);
  for (const verb of ['partition', 'nru']) {
    const json = report(cwd, verb, 'a.ply', 'b.obj', '-o', 'out.off');
    assert.deepEqual([json.volume, json.closed, json.certified, json.regions.length], [1.875, true, true, 3]);
  }
  assert.equal(report(cwd, 'combine', '(a|b) & !a', 'a.ply', 'b.obj', '-o', 'out.off').volume, 0.875);
  const kept = report(cwd, 'keep', '10,21', 'a.ply', 'b.obj', '-o', 'out.off');
  assert.deepEqual([kept.area, kept.closed, kept.operands.map(({ name }) => name)], [6, false, ['a.ply', 'b.obj']]);
  assert.equal(run(['combine', 'a | | b', 'a.ply', 'b.obj', '-o', 'out.off'], { cwd }).code, 2);
  assert.equal(run(['keep', '12', 'a.ply', '-o', 'out.off'], { cwd }).code, 2);
  assert.equal(run(['combine', 'a', '-o', 'out.off'], { cwd }).code, 2);
});

test('imprint writes a file for every mesh, with the same vertices on both sides', (t) => {
  const cwd = cubes(t);
  const json = report(cwd, 'imprint', 'a.ply', 'b.obj', '-o', 'part-%d.off');
  assert.deepEqual([json.certified, json.regions.length, json.graph.closedLoops], [true, 3, 1]);
  assert.deepEqual(json.operands.map(({ name }) => name), ['a.ply', 'b.obj']);
  const [a, b] = [1, 2].map((i) => mortise.readMesh(join(cwd, `part-${i}.off`)));
  for (const mesh of [a, b]) assert.deepEqual([mortise.inspect(mesh).volume, mortise.inspect(mesh).closed], [1, true]);
  const { operands } = mortise.imprint([cube(), cube(0.5, 0.5, 0.5)]);
  assert.deepEqual([a.positions.length, b.positions.length], operands.map(({ positions }) => positions.length));
  assert.equal(mortise.imprint([a, b]).mesh.triangles.length, mortise.imprint([cube(), cube(0.5, 0.5, 0.5)]).mesh.triangles.length);
  assert.equal(report(cwd, 'imprint', 'a.ply', 'b.obj', '-o', 'part-%d.stl').certified, true);
  assert.equal(run(['imprint', 'a.ply', 'b.obj', '-o', 'out.off'], { cwd }).code, 2);
  assert.equal(run(['imprint', '-o', 'out-%d.off'], { cwd }).code, 2);
});

test('implant sets a part into a host, with its contact faces or without', (t) => {
  const cwd = cubes(t);
  const kept = report(cwd, 'implant', 'a.ply', 'b.obj', '-o', 'out.off');
  assert.deepEqual(kept.regions.map(({ operands, volume }) => [operands.join(), volume]).sort(), [['0', 0.875], ['1', 1]]);
  assert.deepEqual([kept.volume, kept.closed], [1.875, true]);
  const one = report(cwd, 'implant', 'a.ply', 'b.obj', '-o', 'out.off', '--contact', 'drop');
  assert.deepEqual([one.volume, one.regions.length], [1.875, 1]);
  assert.equal(run(['implant', 'a.ply', '-o', 'out.off'], { cwd }).code, 2);
  assert.equal(run(['implant', 'a.ply', 'b.obj', '-o', 'out.off', '--contact', 'glue'], { cwd }).code, 2);
});

test('resolve writes what a mesh that overlaps itself covers', (t) => {
  const cwd = cubes(t);
  const [a, b] = [cube(), cube(0.5, 0.5, 0.5)];
  const both = { positions: [...a.positions, ...b.positions], triangles: [...a.triangles, ...b.triangles.map((v) => v + 8)] };
  mortise.writeMesh(join(cwd, 'both.ply'), both);
  assert.equal(report(cwd, 'resolve', 'both.ply', '-o', 'out.off').volume, 1.875);
  assert.equal(run(['resolve', 'a.ply', 'b.obj', '-o', 'out.off'], { cwd }).code, 2);
});

test('a partition may be stored as float32 when it keeps its faces', (t) => {
  const cwd = cubes(t);
  mortise.writeMesh(join(cwd, 'c.ply'), cube(1 / 3, 1 / 3, 1 / 3));
  const json = report(cwd, 'partition', 'a.ply', 'c.ply', '-o', 'out.stl');
  assert.equal(json.certified, true);
  assert.equal(json.regions.length, 3);
});

test('any number of operands, options anywhere', (t) => {
  const cwd = cubes(t);
  mortise.writeMesh(join(cwd, 'c.stl'), cube(0.75));
  const json = report(cwd, 'subtract', '--output', 'out.stl', 'a.ply', 'b.obj', 'c.stl');
  assert.equal(json.operands.length, 3);
  assert.equal(json.volume, 0.875 - 0.25 + 0.0625);
});

test('the JSON report has exactly the documented fields', (t) => {
  const cwd = cubes(t);
  const json = report(cwd, 'union', 'a.ply', 'b.obj', '-o', 'out.ply');
  const fields =
    'vertices triangles closed oriented manifold boundaryEdges nonManifoldEdges components genus volume area bbox minAngleDeg maxAngleDeg ' +
    'selfIntersections certified certificate tolerance operands stages milliseconds regions graph contact notes';
  assert.deepEqual(Object.keys(json), fields.split(' '));
  assert.deepEqual(json.regions, [{ id: 1, operands: [0, 1], volume: 1.875, area: 10.5 }]);
  mortise.writeMesh(join(cwd, 'c.ply'), cube(1 / 3, 1 / 3, 1 / 3));
  assert.deepEqual(Object.keys(report(cwd, 'union', 'a.ply', 'c.ply', '-o', 'out.stl')), fields.split(' '), 'of float32 files too');
  assert.deepEqual(Object.keys(json.graph), ['vertices', 'edges', 'closedLoops', 'openChains']);
  assert.deepEqual(Object.keys(json.contact), ['points', 'length', 'area']);
  assert.deepEqual(json.certificate.failedTriangles, [], 'a list, as all typed arrays');
});

test('people get a table', (t) => {
  const { out } = run(['union', 'a.ply', 'b.obj', '-o', 'out.ply'], { cwd: cubes(t) });
  assert.match(out, /^union +out\.ply \(ply\)$/m);
  assert.match(out, /^surface +closed, oriented, manifold$/m);
  assert.match(out, /^volume +1\.875$/m);
  assert.match(out, /^graph +6 vertices, 6 edges, 1 closed loop, 0 open chains$/m);
});

test('--quiet prints nothing', (t) => {
  const cwd = cubes(t);
  assert.deepEqual([run(['union', 'a.ply', 'b.obj', '-o', 'out.ply', '--quiet'], { cwd }).out, existsSync(join(cwd, 'out.ply'))], ['', true]);
});

test('- reads the standard input and writes the standard output', (t) => {
  const cwd = cubes(t);
  const input = readFileSync(join(cwd, 'a.ply'));
  const done = run(['union', '-', 'b.obj', '-o', '-', '--format', 'stl'], { cwd, input });
  assert.equal(done.code, 0, done.err);
  assert.equal(mortise.inspect(mortise.readMesh(new Uint8Array(done.bytes))).volume, 1.875);
  assert.match(done.err, /^volume +1\.875$/m, 'the report goes to the standard error');
  const piped = run(['transform', '-', '-o', '-', '--format', 'obj', '--scale', '2', '--json'], { input: done.bytes });
  assert.equal(JSON.parse(piped.err).volume, 15);
  assert.match(piped.out, /^v /m);
  assert.equal(JSON.parse(run(['inspect', '-', '--json'], { input: piped.bytes }).out).volume, 15);
});

test('the ending chooses a format of analysis programs, and one that is written only is no format of the standard input', (t) => {
  const cwd = cubes(t);
  report(cwd, 'union', 'a.ply', 'b.obj', '-o', 'out.msh');
  assert.match(readFileSync(join(cwd, 'out.msh'), 'utf8'), /^\$MeshFormat\n4\.1 0 8\n/);
  report(cwd, 'transform', 'out.msh', '-o', 'out.nas', '--scale', '2');
  assert.match(readFileSync(join(cwd, 'out.nas'), 'utf8'), /^BEGIN BULK$/m);
  const done = run(['transform', '-', '-o', '-', '--format', 'inp', '--scale', '2', '--quiet'], { cwd, input: readFileSync(join(cwd, 'out.msh')) });
  assert.equal(done.code, 0);
  assert.match(done.out, /^\*ELEMENT, TYPE=S3/m);
});

test('--format decides over the ending', (t) => {
  const cwd = cubes(t);
  report(cwd, 'union', 'a.ply', 'b.obj', '-o', 'out.stl', '--format', 'stl-ascii');
  assert.match(readFileSync(join(cwd, 'out.stl'), 'utf8'), /^solid/);
});

test('steps are done in the order typed, as often as typed', (t) => {
  const cwd = cubes(t);
  const moved = (...steps) => {
    report(cwd, 'transform', 'a.ply', '-o', 'm.ply', ...steps);
    return box(mortise.readMesh(join(cwd, 'm.ply')));
  };
  assert.deepEqual(moved('--translate', '1,0,0', '--scale', '2'), { min: [2, 0, 0], max: [4, 2, 2] });
  assert.deepEqual(moved('--scale', '2', '--translate', '1,0,0'), { min: [1, 0, 0], max: [3, 2, 2] });
  assert.deepEqual(moved('--translate', '1,0,0', '--rotate-z', '90', '--translate', '0,0,5'), { min: [-1, 1, 5], max: [0, 2, 6] });
  assert.deepEqual(moved('--rotate-x', '90', '--rotate-y', '-90'), { min: [-1, -1, 0], max: [0, 0, 1] });
  assert.deepEqual(moved('--scale', '1,2,3', '--mirror', 'y'), { min: [0, -2, 0], max: [1, 0, 3] });
});

test('values may begin with a minus sign', (t) => {
  const cwd = cubes(t);
  for (const words of [['--translate', '-1,2,3'], ['--translate=-1,2,3'], ['--translate', '-1.0,+2,3e0']]) {
    report(cwd, 'transform', 'a.ply', '-o', 'm.ply', ...words);
    assert.deepEqual(box(mortise.readMesh(join(cwd, 'm.ply'))).min, [-1, 2, 3]);
  }
  report(cwd, 'transform', 'a.ply', '-o', 'm.ply', '--rotate-z', '-90', '--translate', '-.5,-.5,-.5');
  assert.deepEqual(box(mortise.readMesh(join(cwd, 'm.ply'))), { min: [-0.5, -1.5, -0.5], max: [0.5, -0.5, 0.5] });
  report(cwd, 'make', 'box', '-o', 'm.ply', '--lo', '-1,-2,-3', '--hi', '1,2,3');
  assert.deepEqual(box(mortise.readMesh(join(cwd, 'm.ply'))), { min: [-1, -2, -3], max: [1, 2, 3] });
});

test('make knows every shape', (t) => {
  const cwd = temporaryFolder(t);
  const volume = (...words) => report(cwd, 'make', ...words, '-o', 'm.ply').volume;
  assert.equal(volume('box', '--hi', '1,2,3'), 6);
  assert.ok(Math.abs(volume('icosphere', '--radius', '2', '--levels', '5') - (32 * Math.PI) / 3) < 0.05);
  assert.ok(Math.abs(volume('sphere', '--around', '200', '--rings', '100') - (4 * Math.PI) / 3) < 0.01);
  assert.ok(Math.abs(volume('cylinder', '--height', '2') - 2 * Math.PI) < 0.02);
  assert.ok(Math.abs(volume('cone', '--height', '3') - Math.PI) < 0.01);
  assert.ok(Math.abs(volume('torus', '--major-radius', '2', '--minor-radius', '0.5') - Math.PI ** 2) < 0.1);
  assert.equal(volume('grid-sheet', '--cells-x', '3', '--cells-y', '2'), null);
  assert.equal(volume('extrude', '--outline', '0,0,1,0,0,1', '--height', '4'), 2);
  assert.equal(volume('revolve', '--profile', '1,0,2,0,2,1,1,1', '--around', '4'), 6);
});

test('inspect describes a file; --check makes its state the exit code', (t) => {
  const cwd = cubes(t);
  const open = cube();
  open.triangles = open.triangles.subarray(3);
  mortise.writeMesh(join(cwd, 'open.obj'), open);
  assert.equal(report(cwd, 'inspect', 'a.ply').volume, 1);
  assert.equal(report(cwd, 'inspect', 'open.obj').boundaryEdges, 3);
  assert.match(run(['inspect', 'open.obj'], { cwd }).out, /^surface +open \(3 boundary edges\)/m);
  assert.equal(run(['inspect', 'a.ply', '--check'], { cwd }).code, 0);
  assert.equal(run(['inspect', 'open.obj', '--check'], { cwd }).code, 1);
});

test('help and version', () => {
  const general = run(['--help']);
  assert.equal(general.code, 0);
  assert.equal(run(['--version']).out, `${version}\n`);
  for (const verb of ['union', 'intersect', 'subtract', 'xor', 'partition', 'combine', 'keep', 'imprint', 'implant', 'resolve', 'split', 'repair', 'remesh', 'extrude', 'slice', 'transform', 'make', 'inspect']) {
    assert.match(general.out, new RegExp(`mortise ${verb} `));
    const { code, out } = run([verb, '--help']);
    assert.equal(code, 0);
    assert.ok(out.startsWith(`mortise ${verb} `), verb);
  }
});

test('exit code 2: how the command was typed', (t) => {
  const cwd = cubes(t);
  const typed = [
    [],
    ['weld', 'a.ply'],
    ['toString'],
    ['union', '-o', 'out.ply'],
    ['union', 'a.ply', 'b.obj'],
    ['union', 'a.ply', 'b.obj', '-o', '-'],
    ['union', 'a.ply', 'b.obj', '-o', 'out.step'],
    ['union', 'a.ply', 'b.obj', '-o', 'out.ply', '--format', 'step'],
    ['union', 'a.ply', 'b.obj', '-o', 'out.ply', '--speed', '5'],
    ['union', '-', '-', '-o', 'out.ply'],
    ['transform', 'a.ply', 'b.obj', '-o', 'out.ply'],
    ['transform', 'a.ply', '-o', 'out.ply', '--scale', 'two'],
    ['transform', 'a.ply', '-o', 'out.ply', '--scale', '0'],
    ['transform', 'a.ply', '-o', 'out.ply', '--translate', '1,2'],
    ['transform', 'a.ply', '-o', 'out.ply', '--mirror', 'w'],
    ['transform', 'a.ply', '-o', 'out.ply', '--rotate-x', ''],
    ['make', 'teapot', '-o', 'out.ply'],
    ['make', 'box', '--radius', '1', '-o', 'out.ply'],
    ['make', 'extrude', '-o', 'out.ply'],
    ['make', 'extrude', '--outline', '0,0,1', '-o', 'out.ply'],
    ['inspect'],
  ];
  for (const words of typed) {
    const { code, err } = run(words, { cwd, input: '' });
    assert.equal(code, 2, `mortise ${words.join(' ')}: ${err}`);
    assert.match(err, /^mortise: .+\n {2}mortise .*--help tells more\n$/);
  }
  assert.equal(existsSync(join(cwd, 'out.ply')), false);
});

test('exit code 3: input no operation can work on, with file and place', (t) => {
  const cwd = cubes(t);
  const open = cube();
  open.triangles = open.triangles.subarray(3);
  mortise.writeMesh(join(cwd, 'open.obj'), open);
  writeFileSync(join(cwd, 'bad.obj'), 'v 0 0 0\nv 1 0 zero\n');
  writeFileSync(join(cwd, 'bad.xyz'), 'nothing known');
  const said = (...words) => {
    const { code, err } = run(words, { cwd });
    assert.equal(code, 3, err);
    return err;
  };
  assert.match(said('union', 'a.ply', 'open.obj', '-o', 'out.ply', '--kind', 'solid'), /^mortise: open\.obj: .*open edges.*\[NOT_CLOSED\]\n {2}vertexPairs: .* at \(.*\)/);
  assert.match(said('inspect', 'bad.obj'), /^mortise: bad\.obj: .*\[PARSE_FAILED\]\n {2}line: 2\n/);
  assert.match(said('inspect', 'missing.stl'), /cannot read missing\.stl: ENOENT.*\[FILE_FAILED\]/);
  assert.match(said('inspect', 'bad.xyz'), /\[UNKNOWN_FORMAT\]/);
  assert.match(said('transform', 'a.ply', '-o', 'no/such/folder/out.ply'), /cannot write .*\[FILE_FAILED\]/);
  assert.deepEqual(readdirSync(cwd).sort(), ['a.ply', 'b.obj', 'bad.obj', 'bad.xyz', 'open.obj']);
});

test('a plane is one more operand, a sheet is trimmed', (t) => {
  const cwd = cubes(t);
  assert.equal(report(cwd, 'intersect', 'a.ply', '--plane', '0,0,1,0.25', '-o', 'low.ply').volume, 0.25);
  const slab = report(cwd, 'subtract', 'a.ply', '--plane', '0,0,1,0.25', '--plane', '0,0,-1,-0.75', '-o', 'slab.ply');
  assert.equal(slab.volume, 0.5);
  assert.deepEqual(slab.operands.map(({ name }) => name), ['a.ply', '--plane', '--plane']);
  mortise.writeMesh(join(cwd, 'sheet.off'), mortise.transform(mortise.make('gridSheet', { width: 3, depth: 3 }), [{ translate: [-1, -1, 0.5] }]));
  const inside = report(cwd, 'intersect', 'a.ply', 'sheet.off', '-o', 'inside.ply');
  assert.deepEqual([inside.area, inside.closed, inside.volume, inside.operands[1].kind], [1, false, null, 'sheet']);
  assert.equal(report(cwd, 'nru', 'a.ply', 'sheet.off', '-o', 'halves.ply').regions.length, 2);
  assert.equal(report(cwd, 'nru', 'halves.ply', 'b.obj', '-o', 'more.ply').regions.length, 4);
  assert.match(run(['union', 'a.ply', '--plane', '0,0,1,0.5', '-o', 'no.ply'], { cwd }).err, /infinity.*\[INVALID_ARGUMENT\]/);
  assert.match(run(['intersect', 'a.ply', '--plane', '0,0,1', '-o', 'no.ply'], { cwd }).err, /--plane needs 4 numbers/);
});

test('exit code 4: what float32 cannot hold is not written', (t) => {
  const cwd = cubes(t);
  const { code, err } = run(['transform', 'a.ply', '-o', 'out.stl', '--scale', '1e60'], { cwd });
  assert.equal(code, 4);
  assert.match(err, /\[OUT_OF_RANGE\]/);
  assert.equal(existsSync(join(cwd, 'out.stl')), false);
});

test('exit code 4: a float32 file that would cross itself is refused, unless allowed', (t) => {
  const cwd = temporaryFolder(t);
  // The slab is thinner than the distance of float32 numbers at its height: its sides fall onto each other.
  mortise.writeMesh(join(cwd, 'thin.ply'), mortise.make('box', { lo: [0, 0, 1000], hi: [1, 1, 1000.00001] }));
  mortise.writeMesh(join(cwd, 'cut.ply'), mortise.make('box', { lo: [0.25, 0.25, 999], hi: [0.75, 2, 1001] }));
  const words = ['subtract', 'thin.ply', 'cut.ply', '--json', '-o'];
  assert.equal(report(cwd, ...words, 'out.ply').certified, true);

  const refused = run([...words, 'out.stl'], { cwd });
  assert.equal(refused.code, 4);
  assert.match(refused.err, /not certified and was not written/);
  assert.equal(existsSync(join(cwd, 'out.stl')), false);
  const json = JSON.parse(refused.out);
  assert.equal(json.certified, false);
  assert.ok(json.notes.some((note) => /float32 coordinates are too coarse/.test(note)));

  assert.equal(run([...words, 'out.stl', '--allow-uncertified'], { cwd }).code, 0);
  assert.equal(existsSync(join(cwd, 'out.stl')), true);
});

test('the certificate of a float32 file is about what it stores', (t) => {
  const cwd = temporaryFolder(t);
  mortise.writeMesh(join(cwd, 'ball.ply'), mortise.make('icosphere', { levels: 3 }));
  mortise.writeMesh(join(cwd, 'cube.ply'), cube(0.1, 0.2, 0.3));
  const json = report(cwd, 'subtract', 'ball.ply', 'cube.ply', '-o', 'out.stl');
  assert.equal(json.certified, true);
  assert.ok(json.notes.some((note) => /^relative certificate of float32 coordinates/.test(note)));
});

test('a pipe whose reader has gone is no failure', async (t) => {
  const cwd = temporaryFolder(t);
  mortise.writeMesh(join(cwd, 'ball.ply'), mortise.make('icosphere', { levels: 5 }));
  const child = start(['transform', 'ball.ply', '-o', '-', '--format', 'obj', '--quiet'], { cwd });
  child.stdout.destroy();
  const errors = [];
  child.stderr.on('data', (text) => errors.push(text));
  const [code] = await once(child, 'close');
  assert.deepEqual([code, errors.join('')], [0, '']);
});

test('an interrupt ends the command, and no half-written file has the name', async (t) => {
  const cwd = temporaryFolder(t);
  mortise.writeMesh(join(cwd, 'ball.ply'), mortise.make('icosphere', { levels: 7 }));
  const child = start(['union', 'ball.ply', 'ball.ply', '-o', 'out.ply'], { cwd });
  setTimeout(() => child.kill('SIGINT'), 300);
  const [code, signal] = await once(child, 'close');
  assert.ok(code === 130 || signal === 'SIGINT', `${code} ${signal}`);
  assert.deepEqual(readdirSync(cwd), ['ball.ply']);
});
