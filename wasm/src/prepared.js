// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Prepared operands: a number in the core, and here what keeps it until nobody needs it.
// @ts-check

import { invalidArgument } from './errors.js';
import { checkSteps } from './steps.js';

/** @typedef {import('./sync_api.js').Session} Session */
/** @typedef {{ session: Session, number: number }} Handle a prepared operand of a core */

/** @param {Handle} handle */
function forget({ session, number }) {
  if (!session.stopped) session.core.forgetPrepared(number);
}

/** Frees what a program forgot to dispose of, some time. @type {FinalizationRegistry<Handle>} */
const forgotten = new FinalizationRegistry(forget);

export class PreparedOperand {
  /** @type {Handle | undefined} */
  #handle;

  /**
   * @param {Handle} handle
   * @param {import('./glue_types.js').CheckedMesh} mesh
   */
  constructor(handle, { positions, triangles }) {
    this.#handle = handle;
    this.vertices = positions.length / 3;
    this.triangles = (triangles ?? positions).length / (triangles === undefined ? 9 : 3);
    forgotten.register(this, handle, handle);
  }

  /** @param {readonly import('./index.js').TransformStep[]} steps */
  at(steps) {
    return new PlacedOperand(this, checkSteps(steps));
  }

  dispose() {
    if (this.#handle === undefined) return;
    forgotten.unregister(this.#handle);
    forget(this.#handle);
    this.#handle = undefined;
  }

  /**
   * What crosses into the core.
   * @param {Session} session
   * @param {string} name how the caller knows it
   * @param {import('./glue_types.js').FlatStep[]} steps
   */
  checkedFor(session, name, steps) {
    if (this.#handle === undefined) throw invalidArgument(`${name} was disposed of`);
    if (this.#handle.session !== session) throw invalidArgument(`${name} was prepared by another core, or one that stopped: prepare it again`);
    return { prepared: this.#handle.number, steps };
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

// Where there is no Symbol.dispose yet there is no `using` either.
if (Symbol.dispose !== undefined) Object.defineProperty(PreparedOperand.prototype, Symbol.dispose, { value: PreparedOperand.prototype.dispose });

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
