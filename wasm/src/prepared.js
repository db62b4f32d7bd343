// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Prepared operands, moved and not.
// @ts-check

import { invalidArgument } from './errors.js';
import { Kept } from './kept.js';
import { checkSteps } from './steps.js';

/** @typedef {import('./kept.js').Session} Session */

export class PreparedOperand extends Kept {
  /**
   * @param {Session} session
   * @param {number} number
   * @param {import('./glue_types.js').CheckedMesh} mesh
   */
  constructor(session, number, { positions, triangles }) {
    super({ session, number, forget: 'forgetPrepared' });
    this.vertices = positions.length / 3;
    this.triangles = (triangles ?? positions).length / (triangles === undefined ? 9 : 3);
  }

  /** @param {readonly import('./index.js').TransformStep[]} steps */
  at(steps) {
    return new PlacedOperand(this, checkSteps(steps));
  }

  /**
   * What crosses into the core.
   * @param {Session} session
   * @param {string} name how the caller knows it
   * @param {import('./glue_types.js').FlatStep[]} steps
   */
  checkedFor(session, name, steps) {
    const handle = this.handleOf(name);
    if (handle.session !== session) throw invalidArgument(`${name} was prepared by another core, or one that stopped: prepare it again`);
    return { prepared: handle.number, steps };
  }
}

/** A prepared operand, moved. */
export class PlacedOperand {
  /**
   * @param {PreparedOperand} prepared
   * @param {import('./glue_types.js').FlatStep[]} steps
   */
  constructor(prepared, steps) {
    this.prepared = prepared;
    this.steps = steps;
  }
}

/**
 * A prepared operand, moved or not, ready to cross into the core; undefined for anything else.
 * @param {Session} session
 * @param {unknown} operand
 * @param {string} name how the caller knows it: "operand 0"
 */
export function checkPrepared(session, operand, name) {
  if (operand instanceof PreparedOperand) return operand.checkedFor(session, name, []);
  if (operand instanceof PlacedOperand) return operand.prepared.checkedFor(session, name, operand.steps);
  return undefined;
}
