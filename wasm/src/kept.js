// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a core keeps for a program: a number there, and here what frees it when nobody needs it.
// @ts-check

import { invalidArgument } from './errors.js';

/** @typedef {import('./sync_api.js').Session} Session */
/** @typedef {{ session: Session, number: number, forget: 'forgetPrepared' | 'forgetSizing' }} Handle and the core's function that frees it */

/** @param {Handle} handle */
function free({ session, number, forget }) {
  if (!session.stopped) session.core[forget](number);
}

/** Frees what a program forgot to dispose of, some time. @type {FinalizationRegistry<Handle>} */
const forgotten = new FinalizationRegistry(free);

export class Kept {
  /** @type {Handle | undefined} */
  #handle;

  /** @param {Handle} handle */
  constructor(handle) {
    this.#handle = handle;
    forgotten.register(this, handle, handle);
  }

  dispose() {
    if (this.#handle === undefined) return;
    forgotten.unregister(this.#handle);
    free(this.#handle);
    this.#handle = undefined;
  }

  /** @param {string} name how the caller knows it */
  handleOf(name) {
    if (this.#handle === undefined) throw invalidArgument(`${name} was disposed of`);
    return this.#handle;
  }
}

// Where there is no Symbol.dispose yet there is no `using` either.
if (Symbol.dispose !== undefined) Object.defineProperty(Kept.prototype, Symbol.dispose, { value: Kept.prototype.dispose });
