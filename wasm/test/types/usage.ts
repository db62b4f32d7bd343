// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How a TypeScript program uses the package; it is compiled, never run. A wrong use must be an error.

import { combine, cornersToVertices, extrudeTo, groupByLabel, implant, imprint, inspect, intersect, keep, load, make, MeshError, partition, prepare, readMesh, repair } from 'mortise';
import { resolve, slice, split, splitPinches, subtract, symmetricDifference, transform, union, writeMesh } from 'mortise';
import type { BooleanResult, DataChannel, ImprintResult, Mesh, MeshErrorCode, MeshInput, Mortise, PreparedOperand, Report, TransformStep } from 'mortise';

const box: Mesh = await make('box', { lo: [0, 0, 0], hi: [1, 1, 1] });
const prism: Mesh = await make('extrude', { outline: [[0, 0], [1, 0], [0, 1]], height: 2 });
const soup: MeshInput = { positions: new Float32Array(9) };
const steps: TransformStep[] = [{ scale: 2 }, { rotateX: 90 }, { translate: [1, 2, 3] }, { mirror: 'x' }];
const moved: Mesh = await transform(box, steps);

const pair: BooleanResult = await union(box, moved);
await union(box, moved, prism);
await union([box, soup], { signal: new AbortController().signal });
await intersect(box, moved, { onProgress: ({ stage, fraction }) => stage.length > 0 && fraction < 1 });
await subtract({ positions: [0, 0, 0], triangles: [] }, box, { onProgress: () => {} });

{
  using part: PreparedOperand = await prepare(box);
  await subtract(moved, part.at([{ matrix: new Float64Array(16) }]));
  await imprint([part, part.at(steps), prism]);
  // @ts-expect-error: a prepared operand is no mesh
  await inspect(part);
}
const kept: PreparedOperand = (await load()).prepare(soup);
kept.dispose();

const divided: BooleanResult = await partition(box, moved);
const inFront: Uint32Array | undefined = divided.provenance.coveringFront;
await symmetricDifference([box, moved], { inspect: false });
await combine('(a | b) - c', [box, moved, prism]);
await keep(['10', 'same'], [box, moved]);
const imprinted: ImprintResult = await imprint(box, moved, { inspect: false });
await imprint(imprinted.operands);
const sharedIds: Uint32Array[] = imprinted.operands.map(({ vertexIds }) => vertexIds);
await implant(box, moved, prism, { contact: 'drop' });
await implant([box, moved]);
const resolved: BooleanResult = await resolve(soup, { inspect: false });
// @ts-expect-error: a host and a component are needed
await implant(box);
// @ts-expect-error: keep or drop
await implant([box, moved], { contact: 'glue' });
// @ts-expect-error: no such tag
await keep(['12'], [box, moved]);

const brief: BooleanResult = await union(box, moved, { inspect: false });
const found: number | null = brief.report.selfIntersections;

const operands: Uint32Array = pair.provenance.sourceOperand;
const chains: Uint32Array[] = pair.graph.chains;
const genus: number | null = pair.report.genus;
const report: Report = await inspect(pair.mesh);
const bytes: Uint8Array = await writeMesh(pair.mesh, { format: 'stl' });
await writeMesh('out.ply', pair.mesh);
const back: Mesh = await readMesh(bytes, { format: 'stl' });
const fromFile: Mesh = await readMesh('in.obj');

const parts: Mesh[] = await split(pair.mesh, { by: 'regions' });
const sources: Uint32Array = (await split(pair.mesh))[0].sourceFace;
const shells: Uint32Array = (await splitPinches(pair.mesh)).shell;
const repaired = await repair(soup, { dropDegenerate: true, orient: true });
const step: 'orient' | undefined = repaired.done[0].step === 'orient' ? repaired.done[0].step : undefined;
const solid: Mesh = await extrudeTo(repaired.mesh, { z: -1 });
const polygons: Float64Array[] = (await slice(solid, { plane: [0, 0, 1, 0.5] })).polygons;

const painted: MeshInput = { ...box, vertexData: { uv: { components: 2, values: [0, 1] }, normal: { itemSize: 3, array: new Float32Array(3), kind: 'normal' } } };
const uv: DataChannel | undefined = (await union(painted, box)).mesh.cornerData?.uv;
const copies: Uint32Array = (await cornersToVertices(pair.mesh, { missing: 1 })).sourceVertex;
const starts: number[] = (await groupByLabel(pair.mesh)).groups.map(({ start }) => start);
// @ts-expect-error no such kind
await union({ ...box, vertexData: { uv: { components: 2, values: [], kind: 'texture' } } }, box);

const mortise: Mortise = await load({ wasmUrl: '/core.wasm' });
const now: BooleanResult = mortise.union(box, back, { onProgress: () => false });
const nowBytes: Uint8Array = mortise.writeMesh(now.mesh, { format: 'obj' });
const deck: Uint8Array = mortise.writeMesh(now.mesh, { format: 'inp' });
const analysed: Mesh = mortise.readMesh(deck, { format: 'msh' });
// @ts-expect-error: written only
mortise.readMesh(deck, { format: 'inp' });

try {
  mortise.subtract([fromFile, box]);
} catch (error) {
  if (!(error instanceof MeshError)) throw error;
  const code: MeshErrorCode = error.code;
  const places: [number, number, number][] | undefined = error.details.places;
  console.log(code, error.details.operand, error.details.ids, places);
}

// @ts-expect-error no such shape
await make('teapot');
// @ts-expect-error no such parameter
await make('box', { radius: 1 });
// @ts-expect-error no such option
await union(box, moved, { onprogress: () => true });
// @ts-expect-error yes or no
await union(box, moved, { inspect: 'brief' });
// @ts-expect-error no such format
await writeMesh(box, { format: 'step' });
// @ts-expect-error bytes need a format
await writeMesh(box);
// @ts-expect-error no such step
await repair(box, { weld: true });
// @ts-expect-error a plane has an offset
await slice(box, { plane: [0, 0, 1] });
// @ts-expect-error two steps in one have no order
await transform(box, [{ scale: 2, rotateX: 90 }]);
// @ts-expect-error a promise is not a mesh
await union(make('box'), box);

console.log(sharedIds, resolved, parts, sources, shells, step, polygons);
console.log(uv?.values, copies, starts);
console.log(operands, chains, genus, found, report.certified, nowBytes, analysed);
