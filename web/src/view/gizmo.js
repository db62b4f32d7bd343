// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The handle on the chosen operand. What it is dragged to is rounded to digits that can be read and typed.
// @ts-check

import { Object3D } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';

import { digitsFor, roundTo } from '../placement.js';
import { placeLike } from './ghosts.js';

/** @typedef {import('../protocol.js').Vector} Vector */

const leastScale = 0.001;

/**
 * @param {import('../model.js').Model} model
 * @param {import('./stage.js').Stage} stage
 */
export function createGizmo(model, stage) {
  const controls = new TransformControls(stage.camera, stage.canvas);
  const handle = new Object3D();
  /** @type {readonly number[]} */
  let origin = [0, 0, 0];
  controls.setSize(0.85);
  stage.scene.add(handle, controls.getHelper());

  function readHandle() {
    const operand = model.chosenOperand;
    if (operand === undefined) return;
    const { display, size } = operand;
    const digits = digitsFor(Math.max(...size));
    const start = display.origin.map((x, axis) => x - origin[axis]);
    const read = (/** @type {(axis: 0 | 1 | 2) => number} */ entry) => /** @type {Vector} */ ([entry(0), entry(1), entry(2)]);
    const position = handle.position.toArray();
    const turn = [handle.rotation.x, handle.rotation.y, handle.rotation.z];
    const scale = handle.scale.toArray();
    const { placement } = operand;
    if (model.mode === 'translate') placement.move = read((axis) => roundTo(position[axis] - start[axis], digits));
    if (model.mode === 'rotate') placement.turn = read((axis) => roundTo((turn[axis] * 180) / Math.PI, 2));
    if (model.mode === 'scale') placement.scale = read((axis) => Math.max(leastScale, roundTo(Math.abs(scale[axis]), 3)));
    model.tell('placement');
  }

  controls.addEventListener('objectChange', readHandle);
  controls.addEventListener('change', stage.invalidate);
  controls.addEventListener('axis-changed', () => {
    stage.canvas.dataset.handle = controls.axis ?? '';
  });
  controls.addEventListener('dragging-changed', ({ value }) => {
    stage.orbit.enabled = !value;
    model.dragging = Boolean(value);
    model.tell('dragging');
  });

  return {
    isBusy: () => controls.axis !== null,
    update() {
      controls.setMode(model.mode);
      controls.setSpace(model.mode === 'translate' ? 'world' : 'local');
      if (model.chosenOperand === undefined) controls.detach();
      else controls.attach(handle);
      stage.invalidate();
    },
    /** @param {readonly number[]} sceneOrigin */
    place(sceneOrigin) {
      origin = sceneOrigin;
      if (model.chosenOperand !== undefined && !model.dragging) placeLike(handle, model.chosenOperand, origin);
    },
  };
}
