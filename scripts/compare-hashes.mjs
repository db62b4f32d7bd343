// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Compares the native library with the npm package, bit for bit: SHA-256 of the raw little-endian arrays of every scene of
// tests/scenes.txt and of every small scene of the unit tests. Real meshes come from MORTISE_DATA.
// usage: compare-hashes.mjs [path of the native tool result_hashes]

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { load, MeshError } from 'mortise';

const repository = fileURLToPath(new URL('..', import.meta.url));
const sceneList = join(repository, 'tests/scenes.txt');
const tool = process.argv[2] ?? join(repository, 'build/release/tests/result_hashes');
const dataFolder = process.env.MORTISE_DATA ?? join(repository, '../shared/data');
const shapeNames = { grid_sheet: 'gridSheet' };
const mortise = await load();

const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** The bytes of a typed array. */
const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

const textBytes = (text) => new TextEncoder().encode(text);

/** The arrays of a mesh with their names. */
function arraysOfMesh(prefix, { positions, triangles, vertexData, cornerData, faceLabels, labelNames }) {
  const data = Object.entries({ ...vertexData, ...cornerData }).map(([name, { values }]) => [`${prefix}data.${name}`, bytesOf(values)]);
  const surface = [[`${prefix}positions`, bytesOf(positions)], [`${prefix}triangles`, bytesOf(triangles)], ...data];
  if (faceLabels === undefined) return surface;
  return [...surface, [`${prefix}faceLabels`, bytesOf(faceLabels)], [`${prefix}labelNames`, textBytes(labelNames.map((name) => `${name}\n`).join(''))]];
}

/** make() parameters from numbers in the order of the C++ function. */
function makeShape(name, numbers) {
  const pairs = (list) => list.flatMap((x, i) => (i % 2 === 0 ? [[x, list[i + 1]]] : []));
  const [a, b, c, d] = numbers;
  const parameters = {
    box: () => ({ lo: numbers.slice(0, 3), hi: numbers.slice(3) }),
    sphere: () => ({ radius: a, around: b, rings: c }),
    icosphere: () => ({ radius: a, levels: b }),
    cylinder: () => ({ radius: a, height: b, around: c }),
    cone: () => ({ radius: a, height: b, around: c }),
    torus: () => ({ majorRadius: a, minorRadius: b, around: c, across: d }),
    grid_sheet: () => ({ width: a, depth: b, cellsX: c, cellsY: d }),
    extrude: () => ({ height: a, outline: pairs(numbers.slice(1)) }),
    revolve: () => ({ around: a, profile: pairs(numbers.slice(1)) }),
  };
  return mortise.make(shapeNames[name] ?? name, parameters[name]());
}

/** @param {string} move "rx=90", "t=1,2,3" */
function stepOf(move) {
  const [name, numbers] = move.split('=');
  const list = numbers?.split(',').map(Number);
  if (name === 's') return { scale: list[0] };
  if (name === 't') return { translate: list };
  if (name[0] === 'r') return { [`rotate${name[1].toUpperCase()}`]: list[0] };
  return { mirror: name[1] };
}

/** @param {string} text "make torus 2 0.5 48 24 ; rx=90 t=1,2,3" */
function operandOf(text) {
  const [source, moves = ''] = text.split(';');
  const words = source.trim().split(/\s+/);
  const mesh = words[0] === 'make' ? makeShape(words[1], words.slice(2).map(Number)) : mortise.readMesh(join(dataFolder, words[0]));
  const steps = moves.trim() === '' ? [] : moves.trim().split(/\s+/).map(stepOf);
  return steps.reduce((moved, step) => mortise.transform(moved, [step]), mesh);
}

/** Data as the native tool gives to all operands but the second: linear functions of the position. */
function withData(operands) {
  const chart = ([x, y, z]) => [0.75 * x - 0.5 * y + 0.25 * z, 0.5 * x + 0.25 * y - 1 * z];
  return operands.map((mesh, k) => {
    if (k === 1) return mesh;
    const values = [];
    for (let i = 0; i < mesh.positions.length; i += 3) values.push(...chart(mesh.positions.subarray(i, i + 3)));
    return { ...mesh, vertexData: { uv: { components: 2, values: Float64Array.from(values) } } };
  });
}

/** Operands as the native tool wrote them. */
function storedOperands(folder) {
  const count = readdirSync(folder).filter((name) => /^operand\d+\.positions$/.test(name)).length;
  return Array.from({ length: count }, (_, k) => {
    const read = (name) => Uint8Array.from(readFileSync(join(folder, `operand${k}.${name}`))).buffer;
    return { positions: new Float64Array(read('positions')), triangles: new Uint32Array(read('triangles')) };
  });
}

const functionNames = { symmetric_difference: 'symmetricDifference' };

/** @param {string[]} settings "tolerance=1e-7", "simplify=cut", "coordinates=float32" */
function optionsOf(settings) {
  const pairs = settings.map((setting) => setting.split('='));
  return Object.fromEntries(pairs.map(([name, value]) => [name, name === 'tolerance' ? Number(value) : value]));
}

/** @param {string} word "union", "combine:(a|b)&!c", "keep:10,same", "union@tolerance=1e-7@simplify=cut" */
function evaluateWord(word, operands) {
  const [operation, ...settings] = word.split('@');
  const [kind, text] = operation.split(':');
  const options = optionsOf(settings);
  if (kind === 'combine') return mortise.combine(text, operands, options);
  if (kind === 'keep') return mortise.keep(text.split(','), operands, options);
  if (kind === 'implant') return mortise.implant(operands, { ...options, contact: text });
  if (kind === 'resolve') return mortise.resolve(operands[0], options);
  return mortise[functionNames[kind] ?? kind](operands, options);
}

/** The arrays of an operand after an imprint. */
function arraysOfPart(prefix, { vertexIds, facetIds, sourceVertex, sourceFace, category, ...mesh }) {
  const arrays = Object.entries({ vertexIds, facetIds, sourceVertex, sourceFace, category });
  return [...arraysOfMesh(prefix, mesh), ...arrays.map(([field, array]) => [`${prefix}${field}`, bytesOf(array)])];
}

const comparedTables = [
  ...['edgeStart', 'edgeEnd', 'edgeIsSeam', 'faceGenus', 'faceBehind', 'faceInFront', 'usesOfLoopBegin', 'useEdge', 'useIsReversed'],
  ...['sidesOfShellBegin', 'sideFace', 'pathBegin', 'path', 'triangleFace', 'vertexDimension', 'vertexEntity', 'regionVolume'],
];

/** The tables of the model of a mesh. */
function arraysOfModel(prefix, mesh) {
  const { tables } = mortise.model(mesh);
  return comparedTables.map((name) => [`${prefix}${name}`, bytesOf(tables[name])]);
}

/** A result remeshed as the native tool does it. */
function arraysOfRemeshed(prefix, mesh, area) {
  if (mesh.triangles.length > 3 * 10000 || !(area > 0)) return [];
  const size = Math.sqrt((area * 2.31) / 2000);
  const [lo, hi] = [mesh.positions.slice(0, 3), mesh.positions.slice(0, 3)];
  mesh.positions.forEach((x, i) => {
    lo[i % 3] = Math.min(lo[i % 3], x);
    hi[i % 3] = Math.max(hi[i % 3], x);
  });
  if (Math.max(...hi.map((x, k) => x - lo[k])) > 300 * size) return [];
  const fine = mortise.remesh(mesh, { size, features: 'keep' });
  const { all, free, edges, deviation: { toReference, fromReference, curvesToReference, curvesFromReference } } = mortise.quality(fine, { size, reference: mesh });
  const distances = [toReference, fromReference, curvesToReference, curvesFromReference].map(({ max }) => max);
  const quality = Float64Array.of(all.minAngleDeg, all.meanRadiusRatio, free.count, edges.mean, edges.inBand, ...distances);
  const { mesh: { positions, triangles }, sources, modelFaces } = fine;
  const predicted = mesh.triangles.length > 3 * 1000 ? [] : [mortise.predictTriangles(mesh, { size })];
  return Object.entries({ positions, triangles, sources, modelFaces, quality, predicted: Float64Array.from(predicted) }).map(([field, array]) => [`${prefix}${field}`, bytesOf(array)]);
}

/** Names and bytes of what the native tool writes for one evaluation. */
function outcome(name, word, operands) {
  try {
    const { mesh, provenance, graph, report, operands: parts = [] } = evaluateWord(word, operands);
    const { categoryNames: _, coveringSets, ...perTriangle } = provenance;
    const { volume, area, minAngleDeg, maxAngleDeg, contact, regions } = report;
    const arrays = {
      ...perTriangle,
      coveringSets: Uint32Array.from(coveringSets.flatMap((set) => [...set])),
      graphPoints: graph.points,
      graphEdges: graph.edges,
      graphChains: Uint32Array.from(graph.chains.flatMap((chain) => [...chain])),
      regionMeasures: Float64Array.from(regions.flatMap((region) => [region.volume, region.area, ...region.operands])),
      measures: Float64Array.of(volume ?? 0, area, minAngleDeg ?? 0, maxAngleDeg ?? 0, contact.length, contact.area, report.certified ? 1 : 0, report.closed ? 1 : 0),
      'ply-ascii': mortise.writeMesh(mesh, { format: 'ply-ascii' }),
      stl: mortise.writeMesh(mesh, { format: 'stl' }),
      glb: mortise.writeMesh(mesh, { format: 'glb' }),
    };
    return [
      ...arraysOfMesh(`${name}.`, mesh),
      ...arraysOfMesh(`${name}.float32.`, mortise.roundToFloat32(mesh)),
      ...arraysOfModel(`${name}.model.`, mesh),
      ...arraysOfRemeshed(`${name}.remeshed.`, mesh, area),
      ...Object.entries(arrays).map(([field, array]) => [`${name}.${field}`, bytesOf(array)]),
      ...parts.flatMap((part, k) => arraysOfPart(`${name}.part${k}.`, part)),
    ];
  } catch (error) {
    if (!(error instanceof MeshError)) throw error;
    return [[`${name}.error`, textBytes(error.code)]];
  }
}

/** The evaluations of a scene: its indented lines, "subtract B A = 6.41", or else five operations. */
function evaluationsOf(lines) {
  if (lines.length === 0) return [['union'], ['intersect'], ['subtract'], ['symmetric_difference'], ['partition']];
  return lines.map((line) => line.split(' = ')[0].trim().split(/\s+/));
}

/** Every array of a scene by name. @param {string[][]} evaluations operation and operands, none for all of them */
function arraysOf(operands, evaluations) {
  const given = operands.flatMap((mesh, k) => arraysOfMesh(`operand${k}.`, mesh));
  const results = evaluations.flatMap(([operation, ...chosen]) => {
    const order = chosen.map((letter) => operands[letter.charCodeAt(0) - 'A'.charCodeAt(0)]);
    return outcome([operation, ...chosen].join('-'), operation, order.length === 0 ? operands : order);
  });
  return new Map([...given, ...results]);
}

/** The first few of many names. */
const summary = (names) => `${names.slice(0, 4).join(', ')}${names.length > 4 ? `, ... ${names.length} arrays` : ''}`;

/** Compares one scene, prints a line, answers whether all is equal. */
function compareScene(folder, { operands, evaluations }) {
  const name = readFileSync(join(folder, 'name'), 'utf8');
  const ours = arraysOf(operands, evaluations);
  const files = new Set([...readdirSync(folder).filter((file) => file !== 'name'), ...ours.keys()]);
  const total = createHash('sha256');
  const different = [...files].sort().filter((file) => {
    const native = existsSync(join(folder, file)) ? sha256(readFileSync(join(folder, file))) : 'absent';
    total.update(native);
    return native !== (ours.has(file) ? sha256(ours.get(file)) : 'absent');
  });
  const verdict = different.length === 0 ? 'same     ' : 'DIFFERENT';
  console.log(`${verdict} ${total.digest('hex').slice(0, 16)}  ${name}${different.length === 0 ? '' : `: ${summary(different)}`}`);
  return different.length === 0;
}

/** The scene a folder was written for. */
function sceneOf(folderName, folder, lines) {
  if (!folderName.startsWith('listed-')) return { operands: withData(storedOperands(folder)), evaluations: evaluationsOf([]) };
  const [line, ...following] = lines.slice(Number(folderName.slice('listed-'.length)) - 1);
  const end = following.findIndex((text) => !text.startsWith(' '));
  const texts = line.slice(line.indexOf(' : ') + 3).split('|');
  const operands = texts.map(operandOf), isGenerated = texts.every((text) => text.trim().startsWith('make '));
  return { operands: isGenerated ? withData(operands) : operands, evaluations: evaluationsOf(following.slice(0, end)) };
}

const byNumber = (a, b) => a.localeCompare(b, 'en', { numeric: true });
const out = mkdtempSync(join(tmpdir(), 'mortise-hashes-'));
try {
  execFileSync(tool, [sceneList, out], { stdio: 'inherit', env: { ...process.env, MORTISE_DATA: dataFolder } });
  const lines = readFileSync(sceneList, 'utf8').split('\n');
  const folders = readdirSync(out).sort(byNumber);
  const same = folders.filter((name) => compareScene(join(out, name), sceneOf(name, join(out, name), lines)));
  console.log(`${same.length} of ${folders.length} scenes have the same bits natively and in WebAssembly${!existsSync(dataFolder) ? ' (no real meshes here)' : ''}`);
  process.exitCode = same.length === folders.length && folders.length > 0 ? 0 : 1;
} finally {
  rmSync(out, { recursive: true, force: true });
}
