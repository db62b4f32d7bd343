// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rings at the places an error names, in front of everything.
// @ts-check

import { Box3, BufferAttribute, BufferGeometry, CanvasTexture, Points, PointsMaterial, Vector3 } from 'three';

import { colourOf } from './theme.js';

/** A white ring with a dot, to be coloured. */
function ringTexture() {
  const size = 64;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  pen.strokeStyle = pen.fillStyle = '#fff';
  pen.lineWidth = 9;
  pen.beginPath();
  pen.arc(size / 2, size / 2, size / 2 - 8, 0, 2 * Math.PI);
  pen.stroke();
  pen.beginPath();
  pen.arc(size / 2, size / 2, 6, 0, 2 * Math.PI);
  pen.fill();
  return new CanvasTexture(canvas);
}

/**
 * @param {import('../model.js').Model} model
 * @param {import('./stage.js').Stage} stage
 */
export function createMarkers(model, stage) {
  const material = new PointsMaterial({ size: 18, sizeAttenuation: false, map: ringTexture(), transparent: true, depthTest: false, depthWrite: false });
  const points = new Points(new BufferGeometry(), material);
  points.renderOrder = 3;
  points.frustumCulled = false;
  points.visible = false;
  stage.content.add(points);

  /** @param {readonly number[]} origin of the scene */
  function update(origin) {
    const places = model.trouble?.details.places ?? [];
    points.geometry.dispose();
    points.geometry = new BufferGeometry();
    const relative = places.flatMap((place) => place.map((x, axis) => x - origin[axis]));
    points.geometry.setAttribute('position', new BufferAttribute(new Float32Array(relative), 3));
    points.visible = places.length > 0;
    material.color.copy(colourOf('alarm'));
    stage.invalidate();
  }

  return {
    update,
    /** Around the places, with some air. @param {number} air */
    box(air) {
      const position = points.geometry.getAttribute('position');
      const box = new Box3();
      for (let i = 0; i < position.count; ++i) box.expandByPoint(new Vector3().fromBufferAttribute(position, i));
      return box.isEmpty() ? box : box.expandByScalar(air);
    },
  };
}
