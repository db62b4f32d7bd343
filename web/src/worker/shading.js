// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Normals for the screen: smooth over gentle edges, sharp over creases. Nothing else depends on them.
// @ts-check

/** @typedef {import('mortise').Mesh} Mesh */

const creaseCosine = Math.cos((35 * Math.PI) / 180);

/** A vertex with more triangles than this is shaded flat: every pair of them would be compared. */
const largestFan = 256;

/** @param {Float32Array} normals @param {number} f @param {number} g */
const cosineBetween = (normals, f, g) =>
  normals[3 * f] * normals[3 * g] + normals[3 * f + 1] * normals[3 * g + 1] + normals[3 * f + 2] * normals[3 * g + 2];

/**
 * The vector from one vertex to another.
 * @param {Float64Array} positions
 * @param {number} from
 * @param {number} to
 */
const arrow = (positions, from, to) => [
  positions[3 * to] - positions[3 * from],
  positions[3 * to + 1] - positions[3 * from + 1],
  positions[3 * to + 2] - positions[3 * from + 2],
];

/**
 * One unit normal per triangle; zero where it has no area.
 * @param {Mesh} mesh
 */
export function faceNormals({ positions, triangles }) {
  const normals = new Float32Array(triangles.length);
  for (let at = 0; at < triangles.length; at += 3) {
    const [ux, uy, uz] = arrow(positions, triangles[at], triangles[at + 1]);
    const [vx, vy, vz] = arrow(positions, triangles[at], triangles[at + 2]);
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(...normal) || 1;
    for (let axis = 0; axis < 3; ++axis) normals[at + axis] = normal[axis] / length;
  }
  return normals;
}

/**
 * The normals of a result's faces, taken from the faces they are parts of: also the thinnest sliver has the right one.
 * @param {import('mortise').Provenance} provenance
 * @param {Float32Array[]} sources normals of the operands' faces
 */
export function normalsFromSources({ sourceOperand, sourceFace, flipped }, sources) {
  const normals = new Float32Array(3 * sourceFace.length);
  for (let f = 0; f < sourceFace.length; ++f) {
    const source = sources[sourceOperand[f]];
    const sign = flipped[f] ? -1 : 1;
    for (let axis = 0; axis < 3; ++axis) normals[3 * f + axis] = sign * source[3 * sourceFace[f] + axis];
  }
  return normals;
}

/** Corners of triangles, sorted by vertex: those of vertex v are corners[begin[v]] up to corners[begin[v + 1]]. @param {Mesh} mesh */
function cornersByVertex({ positions, triangles }) {
  const begin = new Uint32Array(positions.length / 3 + 2);
  for (const vertex of triangles) ++begin[vertex + 2];
  for (let v = 2; v < begin.length; ++v) begin[v] += begin[v - 1];
  const corners = new Uint32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) corners[begin[triangles[corner] + 1]++] = corner;
  return { begin, corners };
}

/** The angle of a triangle at each of its corners. @param {Mesh} mesh */
function cornerAngles({ positions, triangles }) {
  const angles = new Float32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const first = corner - (corner % 3);
    const [ux, uy, uz] = arrow(positions, triangles[corner], triangles[first + ((corner + 1) % 3)]);
    const [vx, vy, vz] = arrow(positions, triangles[corner], triangles[first + ((corner + 2) % 3)]);
    angles[corner] = Math.atan2(Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx), ux * vx + uy * vy + uz * vz);
  }
  return angles;
}

/**
 * What the mean at a vertex is made from: per face its normal and its operand, per corner its angle.
 * @typedef {{ normals: Float32Array, angles: Float32Array, sourceOperand: Uint32Array | undefined }} Faces
 */

/**
 * One normal per corner: the mean over those triangles round its vertex that are of the same operand and lie within the crease angle of
 * its own, weighted by their angles there. Cutting a face further does not change it.
 * @param {Mesh} mesh
 * @param {Float32Array} normals of its faces
 * @param {Uint32Array} [sourceOperand] of its faces
 */
export function cornerNormals(mesh, normals, sourceOperand) {
  const { begin, corners } = cornersByVertex(mesh);
  const faces = { normals, angles: cornerAngles(mesh), sourceOperand };
  const smooth = new Float32Array(3 * mesh.triangles.length);
  for (let corner = 0; corner < mesh.triangles.length; ++corner) {
    const vertex = mesh.triangles[corner];
    const face = Math.floor(corner / 3);
    const fan = corners.subarray(begin[vertex], begin[vertex + 1]);
    smooth.set(fan.length > largestFan ? normals.subarray(3 * face, 3 * face + 3) : meanNormal(fan, face, faces), 3 * corner);
  }
  return smooth;
}

/**
 * @param {Uint32Array} fan corners at one vertex
 * @param {number} face one of theirs
 * @param {Faces} faces
 */
function meanNormal(fan, face, { normals, angles, sourceOperand }) {
  const sum = [0, 0, 0];
  for (const corner of fan) {
    const other = Math.floor(corner / 3);
    if (sourceOperand?.[face] !== sourceOperand?.[other] || cosineBetween(normals, face, other) < creaseCosine) continue;
    for (let axis = 0; axis < 3; ++axis) sum[axis] += angles[corner] * normals[3 * other + axis];
  }
  const length = Math.hypot(...sum);
  return length === 0 ? [0, 0, 1] : sum.map((x) => x / length);
}
