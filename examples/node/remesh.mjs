// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Two crossing pipes as one mesh for a finite element program: no slivers, small triangles where the pipes meet. Writes out/pipes.msh.

import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { make, predictTriangles, remesh, transform, union, writeMesh } from 'mortise';

const out = new URL('./out/', import.meta.url);
mkdirSync(out, { recursive: true });

const upright = await transform(await make('cylinder', { radius: 0.5, height: 3, around: 48 }), [{ translate: [0, 0, -1.5] }]);
const level = await transform(upright, [{ rotateX: 90 }]);
const pipes = await union(upright, level);

// Edges of 0.15 far away and of 0.05 along the cut, each at most a quarter longer than the one before.
const sizes = { size: 0.15, sources: [{ graph: pipes.graph, size: 0.05, growth: 1.25 }] };
console.log(`about ${Math.round(await predictTriangles(pipes.mesh, sizes))} triangles are asked for`);

const { mesh, before, after } = await remesh(pipes, { operands: [upright, level], ...sizes });
for (const [when, { triangles, minAngleDeg, maxAngleDeg }] of Object.entries({ before, after })) {
  console.log(`${when}: ${triangles} triangles, angles ${minAngleDeg.toFixed(2)} to ${maxAngleDeg.toFixed(1)} degrees`);
}
await writeMesh(fileURLToPath(new URL('pipes.msh', out)), mesh);
console.log('wrote pipes.msh');
