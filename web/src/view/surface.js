// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh of the worker as geometry of the scene.
// @ts-check

import { BufferAttribute, BufferGeometry } from 'three';

/** @param {import('../protocol.js').Display} display */
export function geometryOf({ positions, normals, groups }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  groups.forEach(({ start, count }, material) => geometry.addGroup(3 * start, 3 * count, material));
  return geometry;
}

/**
 * Where a point in doubles lies in the scene.
 * @param {import('three').Object3D} object
 * @param {readonly number[]} point
 * @param {readonly number[]} origin of the scene
 */
export function placeAt(object, point, origin) {
  object.position.set(point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]);
}
