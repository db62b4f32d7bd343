// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizes from every kind of source, against numbers worked out; what is refused; whose sizings are, and when they go.

import assert from 'node:assert/strict';
import test from 'node:test';

import { load, make, MeshError, model, sizing, union } from 'mortise';

import { cube, meshError } from './support.mjs';

const close = (found, expected, within = 1e-12) => assert.ok(Math.abs(found - expected) <= within * Math.abs(expected), `${found} instead of ${expected}`);

/** The size at a point from one source, where 10 is the size without. */
async function sizeFrom(source, point, options) {
  const made = await sizing({ size: 10, sources: [source], ...options });
  const size = made.sizeAt(point);
  made.dispose();
  return size;
}

test('points, segments and triangles ask for S + D (growth - 1)', async () => {
  close(await sizeFrom({ type: 'point', at: [1, 2, 3], size: 0.5, growth: 1.5 }, [4, 6, 3]), 0.5 + 5 * 0.5);
  close(await sizeFrom({ type: 'segment', from: [0, 0, 0], to: [4, 0, 0], size: 0.25, growth: 1.25 }, [1, 3, 4]), 0.25 + 5 * 0.25);
  close(await sizeFrom({ type: 'segment', from: [0, 0, 0], to: [4, 0, 0], size: 0.25, growth: 1.25, radius: 2 }, [1, 3, 4]), 0.25 + 3 * 0.25);
  close(await sizeFrom({ type: 'triangle', corners: [[0, 0, 0], [4, 0, 0], [0, 4, 0]], size: 0.5, growth: 2 }, [-3, -4, 0]), 5.5);
  close(await sizeFrom({ type: 'point', at: [0, 0, 0], size: 1 }, [5, 0, 0]), 2);
  close(await sizeFrom({ type: 'point', at: [0, 0, 0], size: 1 }, [5, 0, 0], { growth: 1.4 }), 3);
  assert.equal(await sizeFrom({ type: 'point', at: [0, 0, 0], size: 1 }, [1000, 0, 0]), 10);
  assert.equal(await sizeFrom({ type: 'point', at: [0, 0, 0], size: 1 }, [0, 0, 0], { smallest: 3 }), 3);
});

test('sizes vary along segments and triangles', async () => {
  const segment = { type: 'segment', from: [0, 0, 0], to: [4, 0, 0], growth: 1.5 };
  close(await sizeFrom({ ...segment, size: [1, 3] }, [1, 0, 0]), 1.5);
  close(await sizeFrom({ ...segment, size: [1, 3, 1] }, [2, 0, 0]), 1);
  const triangle = { type: 'triangle', corners: [[0, 0, 0], [4, 0, 0], [0, 4, 0]], growth: 1.5 };
  close(await sizeFrom({ ...triangle, size: [1, 2, 3] }, [1, 1, 0]), 1.75);
  close(await sizeFrom({ ...triangle, size: Float64Array.of(1, 1, 1, 1, 1.25, 1) }, [1, 1, 0]), 1 + 1 / 16);
});

test('many points are answered at once, in the order given', async () => {
  const made = await sizing({ size: 10, growth: 1.5, sources: [{ type: 'point', at: [0, 0, 0], size: 1 }, { type: 'point', at: [8, 0, 0], size: 2 }] });
  assert.deepEqual(made.sizeAt(Float64Array.of(0, 0, 0, 2, 0, 0, 8, 0, 0)), Float64Array.of(1, 2, 2));
  assert.deepEqual(made.sizeAt(Float32Array.of(4, 0, 0)), Float64Array.of(3));
  assert.deepEqual(made.sizeAt(new Float64Array()), new Float64Array());
  made.dispose();
});

test('without sources there is one size', async () => {
  const made = await sizing({ size: 0.75 });
  assert.equal(made.sizeAt([1, 2, 3]), 0.75);
  made.dispose();
});

test('graphs of results are sources with their own spacing, or one size', async () => {
  // The six edges of length 1 where two boxes meet; each may be several mesh edges.
  const { graph } = await union(await make('box', { lo: [0, 0, 0], hi: [2, 2, 2] }), await make('box', { lo: [1, 1, 1], hi: [3, 3, 3] }));
  const spacing = 6 / (graph.edges.length / 2);
  for (const source of [{ graph }, { type: 'segments', from: graph }, { type: 'segments', from: { points: graph.points, edges: graph.edges } }]) {
    close(await sizeFrom({ ...source, growth: 1.2 }, [1, 2, 1.5]), spacing);
    close(await sizeFrom({ ...source, size: 0.01, growth: 1.2 }, [1, 2, 1.5]), 0.01);
    close(await sizeFrom({ ...source, size: 0.01, growth: 1.2 }, [1, 5, 1.5]), 0.01 + 3 * 0.2);
  }
});

test('entities of models are sources', async () => {
  const box = await model(await make('box', { lo: [0, 0, 0], hi: [1, 1, 1] }));
  const { start } = box.edge(0);
  const at = box.vertex(start).meshVertex;
  const corner = [...box.mesh.positions.subarray(3 * at, 3 * at + 3)];
  const away = corner.map((x) => (x === 0 ? -3 : 4));
  const distance = 3 * Math.sqrt(3);
  for (const entity of [{ dimension: 'vertex', id: start }, { dimension: 'edge', id: 0 }, { dimension: 'face', id: box.edge(0).faces[0].face }, { dimension: 'region', id: 1 }]) {
    close(await sizeFrom({ model: box, entity, size: 0.1, growth: 1.5 }, away), 0.1 + 0.5 * distance);
    close(await sizeFrom({ entity, size: 0.1, growth: 1.5 }, away, { model: box }), 0.1 + 0.5 * distance);
  }
});

test('curved models are followed by chord error or number of elements', async () => {
  // Equilateral triangles inside the circle whose plane is 0.1 from the pole; 16 elements per turn.
  const tube = await model(await make('cylinder', { radius: 2, height: 5, around: 48 }));
  const onSide = [2 * Math.cos(Math.PI / 48), 2 * Math.sin(Math.PI / 48), 2.5].map((x, i) => (i === 2 ? x : x * Math.cos(Math.PI / 48)));
  close(await sizeFrom({ model: tube, curvature: { chordError: 0.1 } }, onSide), Math.sqrt(6 * 0.1 * 2 - 3 * 0.01), 1e-9);
  close(await sizeFrom({ model: tube, curvature: { perTurn: 16 } }, onSide), Math.PI / 4, 1e-9);
  close(await sizeFrom({ model: tube, curvature: { chordError: 0.1, perTurn: 16 } }, onSide), Math.PI / 4, 1e-9);
  close(await sizeFrom({ model: tube, curvature: { perTurn: 16, smallest: 1 } }, onSide), 1, 1e-9);
  // The caps are flat, their circles are not.
  close(await sizeFrom({ model: tube, curvature: { perTurn: 16 }, growth: 1.5 }, [0, 0, 0]), Math.PI / 4 + 0.5 * 2 * Math.cos(Math.PI / 48), 1e-9);
});

test('model edges have a least number of elements', async () => {
  const box = await model(await make('box', { lo: [0, 0, 0], hi: [1, 2, 4] }));
  assert.equal(await sizeFrom({ model: box, edgeCount: 4 }, [0.5, 0, 0]), 0.25);
  assert.equal(await sizeFrom({ model: box, edgeCount: 4, growth: 1 }, [0, 0, 2]), 0.25);
  assert.equal(await sizeFrom({ model: box, edgeCount: 4, growth: 2 }, [0, 0, 2]), 1);
  assert.equal(await sizeFrom({ model: box, edgeCount: 4, smallest: 0.5 }, [0.5, 0, 0]), 0.5);
});

test('sizes at vertices are numbers or a function', async () => {
  const mesh = await make('gridSheet', { width: 2, depth: 2, cellsX: 4, cellsY: 4 });
  const wanted = (x, y) => 0.5 + 0.1 * x + 0.05 * y;
  const sizes = Array.from({ length: mesh.positions.length / 3 }, (_, i) => wanted(mesh.positions[3 * i], mesh.positions[3 * i + 1]));
  for (const source of [{ mesh, sizes: wanted }, { mesh, sizes }, { mesh, sizes: Float64Array.from(sizes) }]) close(await sizeFrom(source, [1.3, 0.2, 0]), wanted(1.3, 0.2));
  close(await sizeFrom({ sizes: wanted }, [0.2, 1.1, 0], { mesh }), wanted(0.2, 1.1));
  close(await sizeFrom({ sizes: wanted }, [0.2, 1.1, 0], { model: await model(mesh) }), wanted(0.2, 1.1));
  const thrown = new Error('mine');
  await assert.rejects(() => sizeFrom({ mesh, sizes: () => { throw thrown; } }, [0, 0, 0]), thrown);
});

test('attributes of kind size are sources', async () => {
  const box = await model(cube());
  box.attributes = [{ name: 'fine', kind: 'size', value: 0.05, targets: [{ dimension: 'region', id: 1 }] }, { name: 'steel', kind: 'material', targets: [{ dimension: 'face', id: 0 }] }];
  close(await sizeFrom({ model: box, attributes: true, growth: 1.5 }, [3, 1, 1]), 0.05 + 1);
  box.attributes[0].value = '0.05';
  const { message } = await meshError('INVALID_ARGUMENT', () => sizeFrom({ model: box, attributes: true }, [0, 0, 0]), MeshError);
  assert.equal(message, `sources[0]: attribute 'fine' has the size "0.05", which is not a positive number`);
});

test('the least of all sources counts, models are built once', async () => {
  const box = await model(await make('box', { lo: [0, 0, 0], hi: [1, 1, 1] }));
  const sources = Array.from({ length: 6 }, (_, id) => ({ entity: { dimension: 'face', id }, size: 0.1 * (id + 1), growth: 1 }));
  const made = await sizing({ size: 10, model: box, sources });
  close(made.sizeAt([0.3, 0.4, 0.5]), 0.1);
  made.dispose();
});

test('a view for Gmsh covers the mesh, the model or a box', async () => {
  const mesh = await make('box', { lo: [1, 2, 3], hi: [2, 3, 4] });
  const source = { type: 'point', at: [1.5, 2.5, 4], size: 0.1, growth: 1.5 };
  const made = [await sizing({ size: 0.5, sources: [source], mesh }), await sizing({ size: 0.5, sources: [source], model: await model(mesh) }), await sizing({ size: 0.5, sources: [source] })];
  const views = [made[0].toGmshView(), made[1].toGmshView(), made[2].toGmshView({ min: [1, 2, 3], max: [2, 3, 4] })];
  assert.equal(views[1], views[0]);
  assert.equal(views[2], views[0]);
  const lines = views[0].split('\n');
  assert.equal(lines[0], 'View "size" {');
  assert.deepEqual(lines.slice(-2), ['};', '']);
  for (const line of lines.slice(1, -2)) assert.match(line, /^SS\(([-0-9.e]+,){11}[-0-9.e]+\)\{([0-9.e-]+,){3}[0-9.e-]+\};$/);
  await meshError('INVALID_ARGUMENT', () => made[2].toGmshView(), MeshError);
  await meshError('INVALID_ARGUMENT', () => made[2].toGmshView({ min: [0, 0, 0] }), MeshError);
  await meshError('INVALID_ARGUMENT', () => made[2].toGmshView({ min: [1, 1, 1], max: [1, 1, 1] }), MeshError);
  await meshError('INVALID_ARGUMENT', () => made[2].toGmshView({ min: [0, 0, 1], max: [1, 1, 0] }), MeshError);
  made.forEach((each) => each.dispose());
});

test('what means nothing is refused by name', async () => {
  const box = await model(cube());
  const graph = { points: new Float64Array(6), edges: Uint32Array.of(0, 1) };
  const point = { type: 'point', at: [0, 0, 0], size: 1 };
  const refused = [
    [{}, /^size must be a positive number, not undefined/],
    [{ size: 1, smallest: 2 }, /smallest is 2, more than the size 1/],
    [{ size: 1, smallest: -1 }, /smallest must be a number, 0 or more/],
    [{ size: 1, growth: 0.9 }, /growth must be a number, 1 or more/],
    [{ size: 1, source: [] }, /unknown option 'source'/],
    [{ size: 1, sources: point }, /sources must be an array/],
    [{ size: 1, sources: [null] }, /sources\[0\] must be an object, not null/],
    [{ size: 1, sources: [{}] }, /sources\[0\] must have a type \(point, segment, segments, triangle\), or graph/],
    [{ size: 1, sources: [point, { ...point, type: 'sphere' }] }, /sources\[1\]\.type is one of point, segment, segments, triangle/],
    [{ size: 1, sources: [{ ...point, to: [1, 1, 1] }] }, /sources\[0\] has an unknown 'to'; known: type, at, size, growth, radius/],
    [{ size: 1, sources: [{ ...point, at: [0, NaN, 0] }] }, /sources\[0\]\.at must be three finite numbers/],
    [{ size: 1, sources: [{ ...point, size: [1, 2] }] }, /sources\[0\]\.size must be a number, not an array/],
    [{ size: 1, sources: [{ ...point, size: 0 }] }, /sources\[0\]\.size must be a positive number/],
    [{ size: 1, sources: [{ ...point, growth: 0 }] }, /sources\[0\]\.growth must be a number, 1 or more/],
    [{ size: 1, sources: [{ ...point, radius: -1 }] }, /sources\[0\]\.radius must be a number, 0 or more/],
    [{ size: 1, sources: [{ type: 'segment', from: [0, 0, 0], to: [1, 0, 0], size: [1, 0] }] }, /sources\[0\]\.size\[1\] must be a positive number/],
    [{ size: 1, sources: [{ type: 'segment', from: [0, 0, 0], to: [1, 0, 0], size: [1, 0.1, 0.1] }] }, /^sources\[0\]: source 0 has sizes that fall below zero/],
    [{ size: 1, sources: [{ type: 'triangle', corners: [[0, 0, 0]], size: 1 }] }, /sources\[0\]\.corners must be three points/],
    [{ size: 1, sources: [{ graph: {} }] }, /sources\[0\]\.graph must be the graph of a result/],
    [{ size: 1, sources: [{ type: 'segments', from: { graph } }] }, /sources\[0\]\.from is a result: pass its \.graph/],
    [{ size: 1, sources: [{ graph: { ...graph, edges: Uint32Array.of(0, 2) } }] }, /^sources\[0\]: an edge ends at a point that is not there/],
    [{ size: 1, sources: [{ entity: { dimension: 'face', id: 0 }, size: 1 }] }, /sources\[0\]\.model must be what model, resultModel or readModel gives/],
    [{ size: 1, model: box, sources: [{ entity: { dimension: 'face', id: 6 }, size: 1 }] }, /the model has no face 6/],
    [{ size: 1, model: cube() }, /model must be what model, resultModel or readModel gives/],
    [{ size: 1, model: box, sources: [{ curvature: {} }] }, /sources\[0\]\.curvature must be/],
    [{ size: 1, model: box, sources: [{ curvature: { chordError: 0 } }] }, /sources\[0\]\.curvature\.chordError must be a positive number/],
    [{ size: 1, model: box, sources: [{ edgeCount: 1.5 }] }, /sources\[0\]\.edgeCount must be a number of elements/],
    [{ size: 1, mesh: cube(), sources: [{ sizes: [1, 2] }] }, /sources\[0\]\.sizes must be 8 numbers/],
    [{ size: 1, mesh: cube(), sources: [{ sizes: () => 0 }] }, /sources\[0\]\.sizes of vertex 0 must be a positive number/],
    [{ size: 1, sources: [{ sizes: () => 1 }] }, /sources\[0\]\.mesh must be a mesh/],
  ];
  for (const [options, message] of refused) assert.match((await meshError('INVALID_ARGUMENT', () => sizing(options), MeshError)).message, message);
  const made = await sizing({ size: 1 });
  for (const points of [[1, 2], 5, undefined, new Float64Array(4), [1, 2, Infinity]]) await meshError('INVALID_ARGUMENT', () => made.sizeAt(points), MeshError);
  made.dispose();
});

test('a disposed sizing is refused, and disposing twice is fine', async () => {
  const m = await load();
  const made = m.sizing({ size: 1 });
  assert.equal(made.sizeAt([0, 0, 0]), 1);
  made.dispose();
  made.dispose();
  assert.match((await meshError('INVALID_ARGUMENT', () => made.sizeAt([0, 0, 0]), MeshError)).message, /the sizing was disposed of/);
  await meshError('INVALID_ARGUMENT', () => made.toGmshView({ min: [0, 0, 0], max: [1, 1, 1] }), MeshError);
  const other = m.sizing({ size: 1 });
  if (Symbol.dispose !== undefined) other[Symbol.dispose]();
  else other.dispose();
  await meshError('INVALID_ARGUMENT', () => other.sizeAt([0, 0, 0]), MeshError);
});
