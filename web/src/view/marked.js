// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles that are marked: painted over, and seen faintly where something is in front of them.
// @ts-check

import { BufferAttribute, BufferGeometry, Group, Mesh, MeshBasicMaterial } from 'three';

import { colourOf } from './theme.js';

/** The triangles of a bin, nine floats each. @param {Float32Array} positions of all @param {Uint8Array} bins @param {number} bin */
function trianglesIn(positions, bins, bin) {
  const found = [...bins.keys()].filter((i) => bins[i] === bin);
  const some = new Float32Array(9 * found.length);
  found.forEach((i, at) => some.set(positions.subarray(9 * i, 9 * i + 9), 9 * at));
  return some;
}

export function createMarked() {
  const strong = new MeshBasicMaterial({ toneMapped: false });
  const faint = new MeshBasicMaterial({ transparent: true, opacity: 0.35, depthTest: false, depthWrite: false, toneMapped: false });
  const meshes = [new Mesh(new BufferGeometry(), strong), new Mesh(new BufferGeometry(), faint)];
  const mesh = new Group();
  mesh.add(...meshes);
  mesh.visible = false;
  return {
    mesh,
    /**
     * @param {Float32Array} positions nine per triangle
     * @param {Uint8Array | undefined} bins of the triangles
     * @param {number | undefined} bin
     */
    show(positions, bins, bin) {
      mesh.visible = bins !== undefined && bin !== undefined;
      meshes[0].geometry.dispose();
      if (bins === undefined || bin === undefined) return;
      const some = new BufferGeometry();
      some.setAttribute('position', new BufferAttribute(trianglesIn(positions, bins, bin), 3));
      for (const each of meshes) each.geometry = some;
    },
    paint() {
      for (const material of [strong, faint]) material.color.copy(colourOf('alarm'));
    },
  };
}
