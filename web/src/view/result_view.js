// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The result: facets in the colour of the operand they come from, wireframe, intersection graph.
// @ts-check

import { Group, Mesh, MeshBasicMaterial, MeshStandardMaterial } from 'three';

import { createGraphView } from './graph_view.js';
import { geometryOf, placeAt } from './surface.js';
import { colourOf, partColour } from './theme.js';

/** How much of a result that is out of date is seen. */
const oldOpacity = 0.3;

/** Pushed back a little, so that lines on the facets are in front of them. */
function createFacetMaterial() {
  return new MeshStandardMaterial({ roughness: 0.55, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
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
  const graph = createGraphView();
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
    graph.setSegments(result.graph);
    root.visible = true;
    paint();
  }

  function paint() {
    const { result, isOld } = model;
    result?.display.groups.forEach(({ operand }, i) => {
      const position = model.positionOf(result.keys[operand]);
      if (position >= 0) materials[i].color.copy(partColour(position));
      Object.assign(materials[i], { transparent: isOld, opacity: isOld ? oldOpacity : 1, depthWrite: !isOld, needsUpdate: true });
    });
    wires.color.copy(colourOf('wire'));
    graph.paint();
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
