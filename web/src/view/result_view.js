// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The result: facets in the colour of the operand they come from, wireframe, intersection graph.
// @ts-check

import { Group, Mesh, MeshBasicMaterial, MeshStandardMaterial } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

import { geometryOf, placeAt } from './surface.js';
import { colourOf, partColour } from './theme.js';

/** How much of a result that is out of date is seen. */
const oldOpacity = 0.3;

const createFacetMaterial = () => new MeshStandardMaterial({ roughness: 0.55, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });

/** Lines in front of everything are faint, lines that are not hidden are strong. */
function createGraph() {
  const geometry = new LineSegmentsGeometry();
  const strong = new LineMaterial({ linewidth: 3 });
  const faint = new LineMaterial({ linewidth: 2, transparent: true, opacity: 0.3, depthTest: false });
  const group = new Group();
  group.add(new LineSegments2(geometry, faint), new LineSegments2(geometry, strong));
  group.children.forEach((line, i) => (line.renderOrder = 2 - i));
  return { group, materials: [strong, faint] };
}

/**
 * @param {import('../model.js').Model} model
 * @param {import('./stage.js').Stage} stage
 */
export function createResultView(model, stage) {
  const root = new Group();
  /** @type {MeshStandardMaterial[]} */
  const materials = [];
  const wires = new MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.4 });
  const facets = new Mesh();
  const wireframe = new Mesh(facets.geometry, wires);
  const graph = createGraph();
  facets.castShadow = true;
  facets.receiveShadow = true;
  root.visible = false;
  root.add(facets, wireframe, graph.group);
  stage.content.add(root);

  function setGeometry() {
    const { result } = model;
    if (result === undefined) return;
    facets.geometry.dispose();
    facets.geometry = wireframe.geometry = geometryOf(result.display);
    while (materials.length < result.display.groups.length) materials.push(createFacetMaterial());
    facets.material = materials;
    setSegments(result.graph);
    root.visible = true;
    paint();
  }

  /** @param {Float32Array} segments */
  function setSegments(segments) {
    const geometry = new LineSegmentsGeometry();
    if (segments.length > 0) geometry.setPositions(segments);
    for (const line of /** @type {LineSegments2[]} */ (graph.group.children)) {
      line.geometry.dispose();
      line.geometry = geometry;
      line.visible = segments.length > 0;
    }
  }

  function paint() {
    const { result, isOld } = model;
    result?.display.groups.forEach(({ operand }, i) => {
      const position = model.positionOf(result.keys[operand]);
      if (position >= 0) materials[i].color.copy(partColour(position));
      Object.assign(materials[i], { transparent: isOld, opacity: isOld ? oldOpacity : 1, needsUpdate: true });
    });
    wires.color.copy(colourOf('wire'));
    for (const material of graph.materials) material.color.copy(colourOf('seam'));
    wireframe.visible = model.shown.wireframe;
    graph.group.visible = model.shown.graph && !isOld;
    stage.invalidate();
  }

  return {
    setGeometry,
    paint,
    facets,
    root,
    /** @param {readonly number[]} origin of the scene */
    place(origin) {
      if (model.result !== undefined) placeAt(root, model.result.display.origin, origin);
    },
    /** The operand a facet comes from, by the material of the facet. @param {number} material */
    keyOf(material) {
      const { result } = model;
      return result?.keys[result.display.groups[material].operand];
    },
  };
}

/** @typedef {ReturnType<typeof createResultView>} ResultView */
