// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How a TypeScript program uses the package; it is compiled, never run. A wrong use must be an error.

import { combine, cornersToVertices, extrudeTo, gmshProject, groupByLabel, implant, imprint, inspect, intersect, keep, load, make, MeshError, model, partition, predictTriangles, prepare, quality, readMesh, readModel, remesh, repair } from 'mortise';
import { resolve, resultModel, sizing, slice, split, splitPinches, subtract, symmetricDifference, transform, union, writeMesh, writeModel } from 'mortise';
import type { Attribute, AttributePolicy, BooleanResult, DataChannel, EntityPart, EntitySource, ImprintResult, Mesh, MeshErrorCode, MeshInput, Model, ModelEntity, Mortise } from 'mortise';
import type { ModelRemeshResult, PreparedOperand, QualityReport, RemeshResult, Report, ResultModel, SizeSource, Sizing, TransformStep } from 'mortise';

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

interface Steel {
  young: number;
}
const steel: Steel = { young: 210e9 };
const policy: AttributePolicy = { split: 'largest', merge: 'error', delete: 'toNeighbours', pieceName: '{name} {piece}' };
const boxModel: Model = await model(box, { faceAngle: 30 });
const soupModel: Model<MeshInput> = await model(soup);
const deckFace: ModelEntity = { dimension: 'face', id: 3 };
boxModel.attributes.push({ name: 'deck', targets: [deckFace] }, { name: 'steel', kind: 'material', value: steel, targets: [{ dimension: 'region', id: 1 }], policy });
const ship: ResultModel = await resultModel(pair, [boxModel, moved], { names: ['hull', 'gun'], attributesOf: [0], splitAtAttributes: false, seams: 'none' });
await resultModel(imprinted.operands[0], [soupModel]);
await resultModel(await intersect(box, { plane: [0, 0, 1, 0.5] }), [boxModel, { plane: [0, 0, 1, 0.5] }]);
const shipAgain: BooleanResult = await union(ship.mesh, box);
const sourcesOfDeck: EntitySource[] = ship.sourcesOf(deckFace);
const partsOfDeck: EntityPart[] = ship.partsOf(0, deckFace);
const shared: Attribute[] = ship.interfaces;
const deckArea: number = ship.measures()[0].area;
await writeModel('ship.msh', ship);
const shipBytes: Uint8Array = await writeModel(ship, { format: 'vtu' });
const shipBack: Model = await readModel(shipBytes, { format: 'vtu', faceAngle: 30 });
const script: string = (await gmshProject(shipBack, { meshFile: 'ship.msh' })).script;
const wanted: SizeSource[] = [{ type: 'point', at: [0, 0, 0], size: 0.1 }, { model: shipBack, entity: { dimension: 'edge', id: 0 }, size: 0.2, growth: 1.3 }, { mesh: box, sizes: (x) => 1 + x }];
const sizes: Sizing = await sizing({ size: 1, model: shipBack, sources: [...wanted, { type: 'segments', from: (await union(box, box)).graph, size: 0.01, growth: 1.2 }, { curvature: { perTurn: 16 } }] });
export const one: number = sizes.sizeAt([0, 0, 0]);
export const many: Float64Array = sizes.sizeAt(box.positions);
export const view: string = sizes.toGmshView({ min: [0, 0, 0], max: [1, 1, 1] });
const finer: RemeshResult = await remesh(box, { size: 0.1, sources: wanted, featureAngle: 30, onProgress: ({ fraction }) => fraction < 1 });
await remesh(pair, { operands: [box, moved], sizing: sizes, mostTriangles: 1e6 });
const finerShip: ModelRemeshResult<ResultModel> = await remesh(ship, { size: 0.1, layers: 2, sources: [{ curvature: { perTurn: 24 } }] });
const finerSoup: ModelRemeshResult = await remesh(soupModel, { sizing: sizes });
await remesh(finerSoup.model, { size: 0.2, featureAngle: undefined });
await writeModel(finerShip.model, { format: 'msh' });
await resultModel(pair, [finerShip.model, finerSoup.model]);
export const interfaceCount: number = finerShip.model.interfaces.length + (await predictTriangles(ship, { size: 1 }));
await quality(finerShip, { size: 0.1, reference: ship });
await remesh(pair, { operands: [box, { plane: [0, 0, 1, 0.5] }], size: 1 });
// @ts-expect-error a model says itself what its edges are
await remesh(ship, { size: 1, featureAngle: 30 });
// @ts-expect-error and where it comes from
await remesh(ship, { size: 1, operands: [box] });
// @ts-expect-error a mesh is answered without a model
console.log(finer.model);
export const least: number | null = finer.after.minAngleDeg;
export const expected: number = await predictTriangles(finer.mesh, { sizing: sizes });
const judged: QualityReport = await quality(finer, { sizing: sizes, reference: pair, operands: [box, moved] });
export const spread: number = judged.free.minAngleDeg + (judged.deviation?.toReference.inSizes ?? 0);
export const shown: string = (await quality(box, { size: 1, featureAngle: 30 })).table;
// @ts-expect-error operands are those of a reference
await quality(box, { size: 1, operands: [box] });
// @ts-expect-error operands are those of a result
await remesh(box, { size: 1, operands: [box] });
// @ts-expect-error a sizing says all about sizes
await remesh(box, { size: 1, sizing: sizes });
// @ts-expect-error a point has one size
await sizing({ size: 1, sources: [{ type: 'point', at: [0, 0, 0], size: [1, 2] }] });
// @ts-expect-error there is always a size
await sizing({ sources: [] });
// @ts-expect-error a mesh is no model
await writeModel(box, { format: 'msh' });
// @ts-expect-error the format keeps no models
await writeModel(ship, { format: 'stl' });
// @ts-expect-error a result has a provenance
await resultModel(box, [boxModel]);
// @ts-expect-error no such policy
boxModel.attributes.push({ name: 'x', targets: [], policy: { split: 'union' } });
// @ts-expect-error targets are entities
boxModel.attributes.push({ name: 'x', targets: [3] });
// @ts-expect-error a model is not a mesh
await union(ship, box);

const mortise: Mortise = await load({ wasmUrl: '/core.wasm' });
const syncModel: ResultModel = mortise.resultModel(pair, [mortise.model(box), mortise.readModel('b.msh')]);
const syncBytes: Uint8Array = mortise.writeModel(syncModel, { format: 'inp' });
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
console.log(shipAgain, sourcesOfDeck, partsOfDeck, shared, deckArea, script, syncBytes);
console.log(operands, chains, genus, found, report.certified, nowBytes, analysed);
