// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The declarations for require(): the same as index.d.ts.

import type * as mortise from './index.js' with { 'resolution-mode': 'import' };

export type * from './index.js' with { 'resolution-mode': 'import' };

export declare const union: typeof mortise.union;
export declare const intersect: typeof mortise.intersect;
export declare const subtract: typeof mortise.subtract;
export declare const symmetricDifference: typeof mortise.symmetricDifference;
export declare const partition: typeof mortise.partition;
export declare const combine: typeof mortise.combine;
export declare const keep: typeof mortise.keep;
export declare const imprint: typeof mortise.imprint;
export declare const implant: typeof mortise.implant;
export declare const resolve: typeof mortise.resolve;
export declare const prepare: typeof mortise.prepare;
export declare const inspect: typeof mortise.inspect;
export declare const transform: typeof mortise.transform;
export declare const roundToFloat32: typeof mortise.roundToFloat32;
export declare const make: typeof mortise.make;
export declare const split: typeof mortise.split;
export declare const splitPinches: typeof mortise.splitPinches;
export declare const repair: typeof mortise.repair;
export declare const extrudeTo: typeof mortise.extrudeTo;
export declare const model: typeof mortise.model;
export declare const resultModel: typeof mortise.resultModel;
export declare const readModel: typeof mortise.readModel;
export declare const writeModel: typeof mortise.writeModel;
export declare const gmshProject: typeof mortise.gmshProject;
export declare const sizing: typeof mortise.sizing;
export declare const remesh: typeof mortise.remesh;
export declare const predictTriangles: typeof mortise.predictTriangles;
export declare const quality: typeof mortise.quality;
export declare const slice: typeof mortise.slice;
export declare const cornersToVertices: typeof mortise.cornersToVertices;
export declare const groupByLabel: typeof mortise.groupByLabel;
export declare const readMesh: typeof mortise.readMesh;
export declare const writeMesh: typeof mortise.writeMesh;
export declare const load: typeof mortise.load;
export declare const MeshError: typeof mortise.MeshError;
export type MeshError = mortise.MeshError;
