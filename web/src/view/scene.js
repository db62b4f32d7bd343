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

/** @param {import('three').Object3D[]} objects */
function boxOf(objects) {
  const box = new Box3();
  for (const object of objects) {
    object.updateWorldMatrix(true, false);
    box.expandByObject(object);
  }
  return box;
}

/**
 * @param {Model} model
 * @param {HTMLCanvasElement} canvas
 */
export function createScene(model, canvas) {
  const stage = createStage(canvas);
  const result = createResultView(model, stage);
  const ghosts = createGhosts(model, stage);
  const markers = createMarkers(model, stage);
  const gizmo = createGizmo(model, stage);
  startPicking(model, stage, { result, ghosts, gizmo });
  const parts = { stage, result, ghosts, markers, gizmo };
  follow(model, parts, createUpdates(model, parts));
}

/**
 * @typedef {import('../model.js').Model} Model
 * @typedef {object} Parts
 * @property {import('./stage.js').Stage} stage
 * @property {import('./result_view.js').ResultView} result
 * @property {import('./ghosts.js').Ghosts} ghosts
 * @property {ReturnType<typeof createMarkers>} markers
 * @property {ReturnType<typeof createGizmo>} gizmo
 */

/** What has to be done when something changes. @param {Model} model @param {Parts} parts */
function createUpdates(model, { stage, result, ghosts, markers, gizmo }) {
  /** Floats are relative to this point in doubles: the first operand's own. */
  const origin = () => model.operands[0]?.display.origin ?? [0, 0, 0];

  /** Every result lies within its operands. */
  const contentBox = () => boxOf(ghosts.all().map(({ ghost }) => ghost));

  return {
    contentBox,
    mark: () => markers.update(origin()),
    place() {
      result.place(origin());
      ghosts.place(origin());
      gizmo.place(origin());
      markers.update(origin());
      stage.invalidate();
    },
    paint() {
      result.paint();
      ghosts.paint();
    },
    settle() {
      if (!model.dragging) stage.light.fit(contentBox());
    },
  };
}

/**
 * @param {Model} model
 * @param {Parts} parts
 * @param {ReturnType<typeof createUpdates>} updates
 */
function follow(model, { stage, result, ghosts, markers, gizmo }, { contentBox, mark, place, paint, settle }) {
  model.on('operands', ghosts.update);
  model.on(['result', 'remeshed'], result.setGeometry);
  model.on('bin', result.mark);
  model.on(['operands', 'chosen', 'mode'], gizmo.update);
  model.on(['operands', 'chosen', 'mode', 'placement', 'result', 'dragging'], place);
  model.on(['operands', 'result', 'trouble', 'shown', 'dragging'], paint);
  model.on(['operands', 'result', 'dragging'], settle);
  model.on('trouble', mark);
  model.on('frame', () => stage.frame(contentBox()));
  model.on('frameTrouble', () => stage.frame(markers.box(0.1 * contentBox().getSize(new Vector3()).length())));
  onThemeChange(() => {
    paint();
    mark();
  });
}
