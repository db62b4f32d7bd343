// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The intersection graph: strong where it is seen, faint where something is in front of it.
// @ts-check

import { Group } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

import { colourOf } from './theme.js';

export function createGraphView() {
  const strong = new LineMaterial({ linewidth: 3 });
  const faint = new LineMaterial({ linewidth: 2, transparent: true, opacity: 0.3, depthTest: false });
  const lines = [new LineSegments2(undefined, faint), new LineSegments2(undefined, strong)];
  const group = new Group();
  group.add(...lines);
  lines.forEach((line, i) => (line.renderOrder = 2 - i));
  return {
    group,
    /** @param {Float32Array} segments two points each */
    setSegments(segments) {
      const geometry = new LineSegmentsGeometry();
      if (segments.length > 0) geometry.setPositions(segments);
      for (const line of lines) {
        line.geometry.dispose();
        line.geometry = geometry;
        line.visible = segments.length > 0;
      }
    },
    paint() {
      for (const material of [strong, faint]) material.color.copy(colourOf('seam'));
    },
  };
}
