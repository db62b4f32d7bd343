// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A ship's hull with a flat deck: convex sections lofted from stern to bow, closed by the deck and two end plates.

/** Half the breadth as a share of the largest, at x from 0 (stern) to 1 (bow). */
function breadthAt(x) {
  const afterbody = 1 - 0.35 * (1 - Math.min(1, x / 0.4)) ** 2;
  const forebody = 1 - Math.max(0, (x - 0.55) / 0.45) ** 2.2;
  return afterbody * (0.02 + 0.98 * forebody);
}

/** Height of the keel at x, as a share of the depth: it rises to stern and bow. */
function keelAt(x) {
  return 0.45 * Math.max(0, 1 - x / 0.25) ** 2 + 0.3 * Math.max(0, (x - 0.85) / 0.15) ** 2;
}

/**
 * One section from the deck's port edge down to the keel and up to its starboard edge.
 * @returns {[number, number][]} (y, z)
 */
function section(x, { breadth, depth, points }) {
  const half = (breadth / 2) * breadthAt(x);
  const keel = depth * keelAt(x);
  return Array.from({ length: points }, (_, i) => {
    const t = (2 * i) / (points - 1) - 1;
    const y = half * Math.sin((t * Math.PI) / 2);
    const fullness = 3;
    const z = Math.abs(t) === 1 ? depth : keel + (depth - keel) * (1 - Math.cos((t * Math.PI) / 2)) ** fullness;
    return [y, z];
  });
}

/** The triangles of one convex end, seen from outside along -x when it is the stern. */
function endPlate(first, points, isStern) {
  return Array.from({ length: points - 2 }, (_, i) => (isStern ? [first, first + i + 2, first + i + 1] : [first, first + i + 1, first + i + 2])).flat();
}

/**
 * The hull from x = 0 to `length`, symmetric to y = 0, from the keel at z = 0 to the deck at z = `depth`.
 * @param {{ length: number, breadth: number, depth: number, stations?: number, points?: number }} size
 */
export function loftHull({ length, breadth, depth, stations = 49, points = 33 }) {
  const rings = Array.from({ length: stations }, (_, s) => {
    const x = s / (stations - 1);
    return section(x, { breadth, depth, points }).map(([y, z]) => [length * x, y, z]);
  });
  const triangles = [...endPlate(0, points, true), ...endPlate((stations - 1) * points, points, false)];
  for (let s = 0; s + 1 < stations; ++s) {
    for (let i = 0; i < points; ++i) {
      const [a, b] = [s * points + i, s * points + ((i + 1) % points)];
      triangles.push(a, b, b + points, a, b + points, a + points);
    }
  }
  return { positions: Float64Array.from(rings.flat(2)), triangles: Uint32Array.from(triangles) };
}
