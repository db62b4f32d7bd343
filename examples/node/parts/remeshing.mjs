// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A result with triangles for analysis: small along the intersection graph, in some layers round it or everywhere, and how good they are.

import { model, quality, remesh } from 'mortise';

/** Edges of 0.3; along the graph as long as those of the graph, and from one to the next a quarter longer. */
const sizesOf = (result) => ({ size: 0.3, sources: [{ graph: result.graph, growth: 1.25 }] });

const layers = 4;

/** A mesh all of whose triangles have this name: it becomes a group of the file. */
export function named(mesh, name) {
  return { ...mesh, faceLabels: new Uint32Array(mesh.triangles.length / 3), labelNames: [name] };
}

/** A mesh as a model whose faces keep the names they have, and whose solid gets one. */
export async function namedModel(mesh, name) {
  const solid = await model(mesh);
  solid.attributes.push({ name, kind: 'material', targets: [{ dimension: 'region', id: 1 }] });
  return solid;
}

/** The result remeshed round its intersection graph, and everywhere. */
export async function remeshBoth(result, operands) {
  const wanted = { operands, ...sizesOf(result) };
  return [
    { name: 'bunny-remeshed-locally', title: `${layers} layers`, remeshed: await remesh(result, { ...wanted, layers }) },
    { name: 'bunny-remeshed', title: 'everywhere', remeshed: await remesh(result, wanted) },
  ];
}

const short = (x, digits = 3) => String(Number(x.toPrecision(digits)));
const percent = (part) => `${(100 * part).toFixed(1)} %`;

/** What is compared, in words. */
const lines = {
  triangles: ({ all }) => all.count.toLocaleString('en-US'),
  'with an angle below 30°': ({ all }) => percent(all.below30 / all.count),
  'smallest angle': ({ all }) => `${short(all.minAngleDeg)}°`,
  'smallest angle, median': ({ all }) => `${short(all.medianAngleDeg)}°`,
  'largest angle': ({ all }) => `${short(all.maxAngleDeg, 4)}°`,
  'mean 2r/R': ({ all }) => all.meanRadiusRatio.toFixed(3),
  'edges about as long as wanted': ({ edges }) => percent(edges.inBand),
  'farthest from the result': ({ deviation }) => (deviation === null ? '' : short(Math.max(deviation.toReference.max, deviation.fromReference.max))),
};

/** A table of the result before and after; the first line is its head. */
export async function comparisonOf(result, operands, columns) {
  const sizes = sizesOf(result);
  const reports = [await quality(result.mesh, sizes)];
  for (const { remeshed } of columns) reports.push(await quality(remeshed, { ...sizes, reference: result, operands }));
  const head = ['', 'before', ...columns.map(({ title }) => title)];
  return [head, ...Object.entries(lines).map(([name, textOf]) => [name, ...reports.map(textOf)])];
}
