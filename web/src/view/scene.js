// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Everything that is drawn, kept in step with the model.
// @ts-check

import { Box3, Vector3 } from 'three';

import { createGhosts } from './ghosts.js';
import { createGizmo } from './gizmo.js';
import { createMarkers } from './markers.js';
import { startPicking } from './picking.js';
import { createResultView } from './result_view.js';
import { createStage } from './stage.js';
import { onThemeChange } from './theme.js';

/**
 * @param {import('../model.js').Model} model
 * @param {HTMLCanvasElement} canvas
 */
export function createScene(model, canvas) {
  const stage = createStage(canvas);
  const result = createResultView(model, stage);
  const ghosts = createGhosts(model, stage);
  const markers = createMarkers(model, stage);
  const gizmo = createGizmo(model, stage);
  startPicking(model, stage, { result, ghosts, gizmo });

  /** Floats are relative to this point in doubles: the first operand's own. */
  const origin = () => model.operands[0]?.display.origin ?? [0, 0, 0];

  /** Every result lies within its operands. */
  const contentBox = () => boxOf(ghosts.all().map(({ ghost }) => ghost));

  function place() {
    result.place(origin());
    ghosts.place(origin());
    gizmo.place(origin());
    markers.update(origin());
    stage.invalidate();
  }

  function paint() {
    result.paint();
    ghosts.paint();
  }

  function settle() {
    if (!model.dragging) stage.fitLight(contentBox());
  }

  model.on('operands', () => {
    ghosts.update();
    gizmo.update();
    place();
    paint();
    settle();
  });
  model.on('placement', place);
  model.on('result', () => {
    result.setGeometry();
    place();
    paint();
    settle();
  });
  model.on('trouble', () => {
    markers.update(origin());
    paint();
  });
  model.on('dragging', () => {
    place();
    ghosts.paint();
    settle();
  });
  model.on(['chosen', 'mode'], () => {
    gizmo.update();
    place();
  });
  model.on('shown', paint);
  model.on('frame', () => stage.frame(contentBox()));
  model.on('frameTrouble', () => stage.frame(markers.box(0.1 * contentBox().getSize(new Vector3()).length())));
  onThemeChange(() => {
    paint();
    markers.update(origin());
  });
}

/** @param {import('three').Object3D[]} objects */
function boxOf(objects) {
  const box = new Box3();
  for (const object of objects) {
    object.updateWorldMatrix(true, false);
    box.expandByObject(object);
  }
  return box;
}
