// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The result: facets in the colour of the operand they come from, edges of triangles, intersection graph.
// @ts-check

import { Group, Mesh, MeshBasicMaterial, MeshStandardMaterial } from 'three';

import { createGraphView } from './graph_view.js';
import { createMarked } from './marked.js';
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
  const edges = new Mesh(facets.geometry, wires);
  const marked = createMarked();
  const graph = createGraphView();
  facets.castShadow = true;
  facets.receiveShadow = true;
  root.visible = false;
  root.add(facets, edges, marked.mesh, graph.group);
  stage.content.add(root);

  function setGeometry() {
    const { result, meshInView } = model;
    if (result === undefined || meshInView === undefined) return;
    const { display } = meshInView;
    facets.geometry.dispose();
    facets.geometry = edges.geometry = geometryOf(display);
    while (materials.length < display.groups.length) materials.push(createFacetMaterial());
    facets.material = materials;
    graph.setSegments(result.graph);
    root.visible = true;
    mark();
    paint();
  }

  /** Triangles of the chosen bin, of the mesh that is looked at. */
  function mark() {
    const { remeshed, remeshedInView, meshInView, bin } = model;
    if (meshInView === undefined) return;
    const numbers = remeshedInView === undefined ? remeshed?.before : remeshed?.after;
    marked.show(meshInView.display.positions, numbers?.bins, bin);
    stage.invalidate();
  }

  function paint() {
    const { isOld, meshInView } = model;
    meshInView?.display.groups.forEach((_, i) => {
      const position = model.positionOf(keyOf(i) ?? -1);
      if (position >= 0) materials[i].color.copy(partColour(position));
      Object.assign(materials[i], { transparent: isOld, opacity: isOld ? oldOpacity : 1, depthWrite: !isOld, needsUpdate: true });
    });
    wires.color.copy(colourOf('wire'));
    graph.paint();
    marked.paint();
    edges.visible = model.shown.edges;
    graph.group.visible = model.shown.graph && !isOld;
    stage.invalidate();
  }

  /** The operand a facet comes from, by the material of the facet. @param {number} material */
  function keyOf(material) {
    const { result, meshInView } = model;
    return meshInView && result?.operands[meshInView.display.groups[material].operand].key;
  }

  return {
    setGeometry,
    mark,
    paint,
    keyOf,
    facets,
    root,
    /** @param {readonly number[]} origin of the scene */
    place(origin) {
      if (model.result !== undefined) placeAt(root, model.result.display.origin, origin);
    },
  };
}

/** @typedef {ReturnType<typeof createResultView>} ResultView */
