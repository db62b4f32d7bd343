// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Times our unions in WebAssembly beside manifold-3d's, on the operands that `speed` wrote: node speed.mjs FOLDER PREFIX [RUNS]
// PREFIX: where npm installed manifold-3d. Each side of a row is a process of its own, so that each has its own peak of memory.
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { argv, execPath, resourceUsage } from 'node:process';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { load } from '../../wasm/src/node.js';

const script = fileURLToPath(import.meta.url);

/** The operands of a scene, in order. */
function readOperands(mortise, folder, scene) {
  const files = readdirSync(join(folder, scene)).sort((a, b) => Number.parseInt(a) - Number.parseInt(b));
  return files.map((file) => mortise.readMesh(join(folder, scene, file)));
}

/** @returns {number} milliseconds */
function timed(call) {
  const start = performance.now();
  call();
  return performance.now() - start;
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** Arrays in, arrays and the whole report out; beside it, what of that the boolean alone took. */
function timeOurs(mortise, operands, runs) {
  const whole = [];
  const boolean = [];
  let result;
  for (let i = 0; i < runs; ++i) {
    whole.push(timed(() => (result = mortise.union(operands))));
    boolean.push(result.report.stages.reduce((sum, stage) => (stage.stage === 'inspect' ? sum : sum + stage.milliseconds), 0));
  }
  return { whole: median(whole), alone: median(boolean), volume: result.report.volume };
}

/** Arrays in, arrays out; beside it, the time without building its solids from the arrays. */
async function timeManifold(operands, runs, prefix) {
  const { default: instantiate } = await import(pathToFileURL(resolve(prefix, 'node_modules/manifold-3d/manifold.js')).href);
  const manifold = await instantiate();
  manifold.setup();
  const meshes = operands.map((o) => ({ numProp: 3, vertProperties: Float32Array.from(o.positions), triVerts: o.triangles }));
  const whole = [];
  const alone = [];
  let volume = 0;
  for (let i = 0; i < runs; ++i) {
    let solids;
    let union;
    const built = timed(() => (solids = meshes.map((mesh) => new manifold.Manifold(new manifold.Mesh(mesh)))));
    const united = timed(() => {
      union = manifold.Manifold.union(solids);
      union.getMesh();
    });
    whole.push(built + united);
    alone.push(united);
    volume = union.volume();
    for (const solid of [...solids, union]) solid.delete();
  }
  return { whole: median(whole), alone: median(alone), volume };
}

async function runSide([side, folder, scene, prefix, runs]) {
  const mortise = await load();
  const operands = readOperands(mortise, folder, scene);
  globalThis.gc?.();
  const before = resourceUsage().maxRSS;
  const time = side === 'ours' ? timeOurs(mortise, operands, Number(runs)) : await timeManifold(operands, Number(runs), prefix);
  console.log(JSON.stringify({ ...time, megabytes: (resourceUsage().maxRSS - before) / 1024 }));
}

function compareSides([folder, prefix, runs = '7']) {
  console.log(`WebAssembly in Node ${process.version}, medians of ${runs} runs in ms; a ratio above 1: manifold-3d takes longer`);
  console.log('whole: arrays to arrays, ours with the whole report; alone: without report, without building solids');
  console.log('union of     ours whole  manifold whole  ratio   ours alone  manifold alone  ratio   peak MB  peak MB   volumes');
  for (const scene of readdirSync(folder).sort()) {
    const [ours, theirs] = ['ours', 'theirs'].map((side) => {
      const child = spawnSync(execPath, ['--expose-gc', script, '--side', side, folder, scene, prefix, runs], { encoding: 'utf8' });
      if (child.status !== 0) throw new Error(`${scene}, ${side}: ${child.stderr}`);
      return JSON.parse(child.stdout);
    });
    const column = (value, width, digits = 1) => value.toFixed(digits).padStart(width);
    console.log(
      scene.padEnd(10) + column(ours.whole, 13) + column(theirs.whole, 16) + column(theirs.whole / ours.whole, 7, 2) +
        column(ours.alone, 13) + column(theirs.alone, 16) + column(theirs.alone / ours.alone, 7, 2) +
        column(ours.megabytes, 10, 0) + column(theirs.megabytes, 9, 0) + `   ${ours.volume} ${theirs.volume}`,
    );
  }
}

const words = argv.slice(2);
if (words[0] === '--side') {
  await runSide(words.slice(1));
} else if (words.length >= 2) {
  compareSides(words);
} else {
  console.error('usage: node speed.mjs FOLDER PREFIX [RUNS]');
  process.exitCode = 2;
}
