// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operands, seen through: where they are, also where nothing of them is left in the result.
// @ts-check

import { Mesh, MeshStandardMaterial } from 'three';

import { geometryOf, placeAt } from './surface.js';
import { partColour } from './theme.js';

/** @typedef {import('../protocol.js').Operand} Operand */

/** Opacity beside a result, and when there is none of the operands as they are. */
const faint = 0.16;
const clear = 0.55;

const rad = Math.PI / 180;

/** @param {Operand} operand */
function createGhost(operand) {
  const seenThrough = { transparent: true, opacity: faint, depthWrite: false };
  const behindResult = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 };
  const material = new MeshStandardMaterial({ ...seenThrough, ...behindResult, roughness: 0.8 });
  const ghost = new Mesh(geometryOf(operand.display), [material]);
  ghost.rotation.order = 'ZYX';
  ghost.renderOrder = 1;
  return ghost;
}

/** @param {Mesh<any, MeshStandardMaterial[]>} ghost */
function dispose(ghost) {
  ghost.geometry.dispose();
  ghost.material[0].dispose();
  ghost.removeFromParent();
}

/**
 * Puts an object where an operand is.
 * @param {import('three').Object3D} object
 * @param {Operand} operand
 * @param {readonly number[]} origin of the scene
 */
export function placeLike(object, { display, placement }, origin) {
  placeAt(object, display.origin.map((x, axis) => x + placement.move[axis]), origin);
  object.rotation.set(placement.turn[0] * rad, placement.turn[1] * rad, placement.turn[2] * rad, 'ZYX');
  object.scale.set(...placement.scale);
  object.updateMatrixWorld();
}

/**
 * @param {import('../model.js').Model} model
 * @param {import('./stage.js').Stage} stage
 */
export function createGhosts(model, stage) {
  /** @type {Map<number, Mesh<any, MeshStandardMaterial[]>>} */
  const ghosts = new Map();

  function update() {
    const keys = model.operands.map(({ key }) => key);
    for (const [key, ghost] of ghosts) {
      if (keys.includes(key)) continue;
      dispose(ghost);
      ghosts.delete(key);
    }
    for (const operand of model.operands) {
      if (ghosts.has(operand.key)) continue;
      const ghost = createGhost(operand);
      ghosts.set(operand.key, ghost);
      stage.content.add(ghost);
    }
  }

  /** Ghosts are also shown when the result is out of date, and the chosen one while it is dragged. */
  function paint() {
    model.operands.forEach(({ key }, position) => {
      const ghost = ghosts.get(key);
      if (ghost === undefined) return;
      ghost.material[0].color.copy(partColour(position));
      ghost.material[0].opacity = model.isOld ? clear : faint;
      ghost.visible = model.shown.ghosts || model.isOld || model.result === undefined || (model.dragging && position === model.chosen);
    });
    stage.invalidate();
  }

  return {
    update,
    paint,
    /** @param {readonly number[]} origin of the scene */
    place(origin) {
      for (const operand of model.operands) {
        const ghost = ghosts.get(operand.key);
        if (ghost !== undefined) placeLike(ghost, operand, origin);
      }
    },
    /** @returns {{ key: number, ghost: Mesh }[]} */
    all: () => [...ghosts].map(([key, ghost]) => ({ key, ghost })),
  };
}

/** @typedef {ReturnType<typeof createGhosts>} Ghosts */
