// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Draws the picture of the README: generated parts before and after, lit faces, the intersection graph in red.
// Writes examples/node/out/picture.png; docs/picture.png is a copy of it.

import { mkdirSync, writeFileSync } from 'node:fs';
import { deflateSync, crc32 } from 'node:zlib';

import { make, subtract, transform, union } from 'mortise';

import { craneParts, gunParts } from './parts/equipment.mjs';
import { loftHull } from './parts/hull.mjs';

const width = 1200;
const height = 460;
const supersample = 2;
const ground = [250, 250, 248];
const colours = [[126, 152, 178], [214, 158, 84], [122, 170, 128], [178, 132, 168], [208, 190, 110]];

/** A picture of `w` x `h` pixels with depth. */
function makeCanvas(w, h) {
  const pixels = new Float64Array(3 * w * h);
  for (let i = 0; i < pixels.length; ++i) pixels[i] = ground[i % 3];
  return { w, h, pixels, depth: new Float64Array(w * h).fill(-Infinity) };
}

/** Isometric view: screen x and y in pixels, larger z is nearer. */
function makeCamera({ scale, x, y, turn = -32, tilt = 24 }) {
  const [a, b] = [(turn * Math.PI) / 180, (tilt * Math.PI) / 180];
  return ([px, py, pz]) => {
    const u = px * Math.cos(a) - py * Math.sin(a);
    const v = px * Math.sin(a) + py * Math.cos(a);
    return [x + scale * u, y - scale * (pz * Math.cos(b) + v * Math.sin(b)), pz * Math.sin(b) - v * Math.cos(b)];
  };
}

function fillTriangle(canvas, p, q, r, colour) {
  const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  if (area === 0) return;
  const [x0, x1] = [Math.max(0, Math.floor(Math.min(p[0], q[0], r[0]))), Math.min(canvas.w - 1, Math.ceil(Math.max(p[0], q[0], r[0])))];
  const [y0, y1] = [Math.max(0, Math.floor(Math.min(p[1], q[1], r[1]))), Math.min(canvas.h - 1, Math.ceil(Math.max(p[1], q[1], r[1])))];
  for (let y = y0; y <= y1; ++y) {
    for (let x = x0; x <= x1; ++x) {
      const w1 = ((x - p[0]) * (r[1] - p[1]) - (y - p[1]) * (r[0] - p[0])) / area;
      const w2 = ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area;
      const w0 = 1 - w1 - w2;
      if (w0 < 0 || w1 < 0 || w2 < 0) continue;
      setPixel(canvas, x, y, w0 * p[2] + w1 * q[2] + w2 * r[2], colour);
    }
  }
}

function setPixel(canvas, x, y, z, colour) {
  const at = y * canvas.w + x;
  if (x < 0 || y < 0 || x >= canvas.w || y >= canvas.h || z <= canvas.depth[at]) return;
  canvas.depth[at] = z;
  canvas.pixels.set(colour, 3 * at);
}

function drawLine(canvas, p, q, colour, nearer) {
  const steps = Math.ceil(Math.max(Math.abs(q[0] - p[0]), Math.abs(q[1] - p[1]), 1));
  for (let i = 0; i <= steps; ++i) {
    const t = i / steps;
    const [x, y, z] = [0, 1, 2].map((k) => p[k] + t * (q[k] - p[k]));
    for (const [dx, dy] of [[0, 0], [1, 0], [0, 1], [1, 1]]) setPixel(canvas, Math.round(x) + dx, Math.round(y) + dy, z + nearer, colour);
  }
}

/** Faces lit from above left, in the colour of their operand. */
function drawResult(canvas, camera, { mesh, provenance, graph }, nearer) {
  const point = (v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)];
  for (let t = 0; t < mesh.triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => point(mesh.triangles[t + i]));
    const [u, v] = [b.map((x, i) => x - a[i]), c.map((x, i) => x - a[i])];
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const light = 0.55 + (0.45 * (n[0] * -0.35 + n[1] * -0.5 + n[2] * 0.79)) / (Math.hypot(...n) || 1);
    const colour = colours[provenance.sourceOperand[t / 3] % colours.length].map((x) => x * Math.max(0.25, light));
    fillTriangle(canvas, ...[a, b, c].map(camera), colour);
  }
  const node = (i) => [...graph.points.subarray(3 * i, 3 * i + 3)];
  for (let e = 0; e < graph.edges.length; e += 2) {
    drawLine(canvas, camera(node(graph.edges[e])), camera(node(graph.edges[e + 1])), [200, 30, 40], nearer);
  }
}

/** The canvas at half its size as a PNG of 8-bit RGB. */
function encodePng(canvas) {
  const [w, h] = [canvas.w / supersample, canvas.h / supersample];
  const rows = Buffer.alloc(h * (3 * w + 1));
  for (let y = 0; y < h; ++y) {
    for (let x = 0; x < 3 * w; ++x) {
      let sum = 0;
      for (let i = 0; i < supersample ** 2; ++i) {
        const at = (supersample * y + Math.floor(i / supersample)) * canvas.w + supersample * Math.floor(x / 3) + (i % supersample);
        sum += canvas.pixels[3 * at + (x % 3)];
      }
      rows[y * (3 * w + 1) + 1 + x] = Math.min(255, Math.round(sum / supersample ** 2));
    }
  }
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name), data]);
    const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, check]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(w, 0);
  header.writeUInt32BE(h, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
  return Buffer.concat([signature, chunk('IHDR', header), chunk('IDAT', deflateSync(rows, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

const deck = 5;
const hull = loftHull({ length: 60, breadth: 9, depth: deck });
const gun = await union(await gunParts({ x: 44, deck }));
const crane = await union(await craneParts({ x: 18, deck }));
const ship = await union(hull, gun.mesh, crane.mesh);

const block = await make('box', { lo: [-1, -1, -1], hi: [1, 1, 1] });
const bore = await transform(await make('cylinder', { radius: 0.55, height: 4, around: 64 }), [{ translate: [0, 0, -2] }]);
const ring = await transform(await make('torus', { majorRadius: 1.05, minorRadius: 0.32, around: 96, across: 48 }), [{ translate: [0, 0, 1] }]);
const part = await subtract(block, bore, await transform(bore, [{ rotateX: 90 }]), await transform(bore, [{ rotateY: 90 }]), ring);

const canvas = makeCanvas(width * supersample, height * supersample);
drawResult(canvas, makeCamera({ scale: 25, x: 150, y: 560 }), ship, 0.3);
drawResult(canvas, makeCamera({ scale: 175, x: 2000, y: 480, turn: -32, tilt: 28 }), part, 0.02);

const out = new URL('./out/', import.meta.url);
mkdirSync(out, { recursive: true });
writeFileSync(new URL('picture.png', out), encodePng(canvas));
console.log(`picture.png: ship of ${ship.report.triangles} triangles, part of genus ${part.report.genus}`);
