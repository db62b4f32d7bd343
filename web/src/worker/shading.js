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

/** @param {number[]} vector */
const lengthOf = ([x, y, z]) => Math.sqrt(x * x + y * y + z * z);

/** @param {number[]} u @param {number[]} v */
const crossOf = ([ux, uy, uz], [vx, vy, vz]) => [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];

/**
 * One unit normal per triangle; zero where it has no area.
 * @param {Mesh} mesh
 */
export function faceNormals({ positions, triangles }) {
  const normals = new Float32Array(triangles.length);
  for (let at = 0; at < triangles.length; at += 3) {
    const normal = crossOf(arrow(positions, triangles[at], triangles[at + 1]), arrow(positions, triangles[at], triangles[at + 2]));
    const length = lengthOf(normal) || 1;
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
export function cornerAngles({ positions, triangles }) {
  const angles = new Float32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const first = corner - (corner % 3);
    const u = arrow(positions, triangles[corner], triangles[first + ((corner + 1) % 3)]);
    const v = arrow(positions, triangles[corner], triangles[first + ((corner + 2) % 3)]);
    angles[corner] = Math.atan2(lengthOf(crossOf(u, v)), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
  }
  return angles;
}

/**
 * One normal per corner: the mean over those triangles round its vertex that are of the same operand and lie within the crease angle of
 * its own, weighted by their angles there. Cutting a face further does not change it.
 * @param {Mesh} mesh
 * @param {Float32Array} normals of its faces
 * @param {Uint32Array} [sourceOperand] of its faces
 */
export function cornerNormals(mesh, normals, sourceOperand) {
  const { begin, corners } = cornersByVertex(mesh);
  const angles = cornerAngles(mesh);
  const smooth = new Float32Array(3 * mesh.triangles.length);

  /** @param {number} face @param {number} other */
  const join = (face, other) => sourceOperand?.[face] === sourceOperand?.[other] && cosineBetween(normals, face, other) >= creaseCosine;

  /** The sum over the fan of a vertex, as seen from one of its faces. @param {number} face @param {number} from @param {number} to */
  function sumOver(face, from, to) {
    const sum = [0, 0, 0];
    for (let i = from; i < to; ++i) {
      const other = Math.floor(corners[i] / 3);
      if (!join(face, other)) continue;
      for (let axis = 0; axis < 3; ++axis) sum[axis] += angles[corners[i]] * normals[3 * other + axis];
    }
    return sum;
  }

  for (let corner = 0; corner < mesh.triangles.length; ++corner) {
    const face = Math.floor(corner / 3);
    const [from, to] = [begin[mesh.triangles[corner]], begin[mesh.triangles[corner] + 1]];
    const sum = to - from > largestFan ? [normals[3 * face], normals[3 * face + 1], normals[3 * face + 2]] : sumOver(face, from, to);
    const length = lengthOf(sum) || 1;
    for (let axis = 0; axis < 3; ++axis) smooth[3 * corner + axis] = sum[axis] / length;
  }
  return smooth;
}
