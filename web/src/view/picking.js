// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A click on a part chooses it.
// @ts-check

import { Raycaster, Vector2 } from 'three';

/** Pixels the pointer may move between press and release of a click. */
const stillness = 4;

/**
 * @param {import('../model.js').Model} model
 * @param {import('./stage.js').Stage} stage
 * @param {{ result: import('./result_view.js').ResultView, ghosts: import('./ghosts.js').Ghosts, gizmo: { isBusy: () => boolean } }} views
 */
export function startPicking(model, { canvas, camera }, { result, ghosts, gizmo }) {
  const raycaster = new Raycaster();
  let pressed = new Vector2();

  /** @param {MouseEvent} event */
  function aim({ clientX, clientY }) {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    raycaster.setFromCamera(new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height), camera);
  }

  /** The result covers the ghosts. */
  function keyAtPointer() {
    const [facet] = result.root.visible && !model.isOld ? raycaster.intersectObject(result.facets, false) : [];
    if (facet?.face) return result.keyOf(facet.face.materialIndex);
    const seen = ghosts.all().filter(({ ghost }) => ghost.visible);
    const [hit] = raycaster.intersectObjects(seen.map(({ ghost }) => ghost), false);
    return seen.find(({ ghost }) => ghost === hit?.object)?.key;
  }

  canvas.addEventListener('pointerdown', (event) => {
    pressed = new Vector2(event.clientX, event.clientY);
  });
  canvas.addEventListener('click', (event) => {
    if (gizmo.isBusy() || pressed.distanceTo(new Vector2(event.clientX, event.clientY)) > stillness) return;
    aim(event);
    const key = keyAtPointer();
    if (key !== undefined) model.choose(model.positionOf(key));
  });
}
