// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The main job on real meshes: a scanned bunny and generated parts, a lofted ship with a gun and a crane; then the chain of the paper:
// boolean, remeshing round the intersection graph, export. Prints what came out and writes it to examples/node/out.

import { mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { inspect, intersect, make, subtract, transform, union, writeMesh, writeModel } from 'mortise';

import { craneParts, gunParts } from './parts/equipment.mjs';
import { loftHull } from './parts/hull.mjs';
import { comparisonOf, named, namedModel, remeshBoth } from './parts/remeshing.mjs';

const out = new URL('./out/', import.meta.url);
mkdirSync(out, { recursive: true });

/** Lines of the table of results; the first one is its head. */
const results = [['file', 'triangles', 'volume', 'genus', 'loops', 'closed', 'certified', 'ms']];
const failures = [];

/** @param {number} volume */
const shown = (volume) => String(Number(volume.toPrecision(9)));

async function keep(name, mesh, report) {
  await writeMesh(new URL(name, out), mesh);
  const { triangles, volume, genus, graph, closed, oriented, certified, milliseconds } = report;
  const yes = (value) => (value ? 'yes' : 'NO');
  results.push([name, triangles.toLocaleString('en-US'), shown(volume), genus, graph.closedLoops, yes(closed && oriented), yes(certified), milliseconds.toFixed(0)]);
  if (!(closed && oriented && certified)) failures.push(name);
  return mesh;
}

const keepOperand = async (name, mesh) => keep(name, mesh, await inspect(mesh));
const keepResult = (name, { mesh, report }) => keep(name, mesh, report);

/** What the volumes of a union and a difference must obey; the last digits are rounding. */
function checkSum(what, left, right) {
  const good = Math.abs(left - right) <= 1e-9 * Math.abs(right);
  console.log(`${good ? 'ok ' : 'NO '} ${what}: ${shown(left)} = ${shown(right)}`);
  if (!good) failures.push(what);
}

const volumeOf = async (mesh) => (await inspect(mesh)).volume;

async function bunnyScene() {
  const { positions, cells } = createRequire(import.meta.url)('bunny');
  const scan = { positions: positions.flat(), triangles: cells.flat() };
  const bunny = await keepOperand('bunny.ply', await transform(scan, [{ rotateX: 90 }]));
  const { bbox } = await inspect(bunny);
  const middle = [0, 1, 2].map((axis) => (bbox.min[axis] + bbox.max[axis]) / 2);
  const stand = await transform(await make('revolve', { profile: [[0, -1], [5, -1], [5, -0.5], [4, 0], [4, 0.6], [0, 0.6]], around: 96 }), [
    { translate: [middle[0], middle[1], bbox.min[2]] },
  ]);
  const rod = await transform(await make('cylinder', { radius: 0.8, height: 30, around: 64 }), [{ translate: [0, 0, -15] }, { rotateY: 90 }, { translate: middle }]);
  const parts = [named(bunny, 'bunny'), named(stand, 'stand')];
  const onStand = await union(parts);
  await keepResult('bunny-on-stand.ply', onStand);
  const drilled = await keepResult('bunny-drilled.ply', await subtract(onStand.mesh, rod));
  const plug = await keepResult('bunny-core.ply', await intersect(onStand.mesh, rod));
  return { volumes: { drilled: await volumeOf(drilled), core: await volumeOf(plug), whole: onStand.report.volume }, onStand, parts };
}

async function shipScene() {
  const size = { length: 60, breadth: 9, depth: 5 };
  const hull = await keepOperand('hull.ply', loftHull(size));
  const gun = await union(await gunParts({ x: 44, deck: size.depth }));
  await keepResult('gun.ply', gun);
  const crane = await union(await craneParts({ x: 18, deck: size.depth }));
  await keepResult('crane.ply', crane);
  const ship = await union(hull, gun.mesh, crane.mesh);
  await keepResult('ship.ply', ship);
  const thruster = await transform(await make('cylinder', { radius: 0.7, height: 20, around: 48 }), [{ rotateX: 90 }, { translate: [52, 10, 1.6] }]);
  const hold = await make('box', { lo: [24, -3, 1], hi: [38, 3, size.depth] });
  const cut = await subtract(ship.mesh, thruster, hold);
  await keepResult('ship-with-hold.ply', cut);
  await writeMesh(new URL('ship-with-hold.stl', out), cut.mesh);
  return { hull: await volumeOf(hull), gun: gun.report.volume, crane: crane.report.volume, ship: ship.report.volume };
}

/** Remeshes the bunny on its stand round the cut and as a whole. What is checked are the meshes themselves. */
async function remeshScene(onStand, parts) {
  const columns = await remeshBoth(onStand, parts);
  for (const { name, remeshed } of columns) {
    await writeModel(new URL(`${name}.msh`, out), await namedModel(remeshed.mesh, 'solid'));
    await writeMesh(new URL(`${name}.ply`, out), remeshed.mesh);
    await writeMesh(new URL(`${name}.stl`, out), remeshed.mesh);
    const { closed, selfIntersections } = await inspect(remeshed.mesh);
    if (!closed || selfIntersections > 0 || remeshed.newCrossings > 0) failures.push(name);
  }
  return comparisonOf(onStand, parts, columns);
}

function printTable(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => String(row[column]).length)));
  for (const row of rows) console.log(row.map((cell, i) => (i === 0 ? String(cell).padEnd(widths[i]) : String(cell).padStart(widths[i]))).join('   '));
}

console.log('Uniting and subtracting a scan, a hull and generated parts ...\n');
const { volumes, onStand, parts } = await bunnyScene();
const ship = await shipScene();
printTable(results);
console.log('\nRemeshing the bunny on its stand: small triangles along the cut, growing away from it ...\n');
printTable(await remeshScene(onStand, parts));
console.log('\nOutside the layers every triangle stays as it was.');
console.log(`\nFiles are in ${fileURLToPath(out)}\n`);
checkSum('drilled bunny + what was drilled out = bunny on its stand', volumes.drilled + volumes.core, volumes.whole);
checkSum('hull + gun + crane, which stand flush on the deck = ship', ship.hull + ship.gun + ship.crane, ship.ship);
console.log(failures.length === 0 ? '\nAll results are closed, oriented and certified; what is remeshed is closed and crosses itself nowhere.' : `\nFAILED: ${failures.join(', ')}`);
process.exitCode = failures.length === 0 ? 0 : 1;
