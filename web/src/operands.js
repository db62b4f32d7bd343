// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Loading, replacing and removing operands.
// @ts-check

import { forgetOperands, loadOperand, readOperands } from './loading.js';
import { samples } from './samples.js';
import { isCancelled, troubleOf } from './trouble.js';

/** @typedef {import('./protocol.js').Operand} Operand */

/**
 * @param {import('./model.js').Model} model
 * @param {import('./engine.js').Engine} engine
 */
export function createOperands(model, engine) {
  /** @param {Operand[]} operands @param {number} chosen */
  function setOperands(operands, chosen) {
    const gone = model.operands.filter((operand) => !operands.includes(operand));
    model.operands = operands;
    model.chosen = chosen;
    model.tell('operands');
    forgetOperands(engine, gone);
  }

  /** @param {() => Promise<Operand[]>} load @param {(loaded: Operand[]) => void} use */
  async function loadInto(load, use) {
    model.countBusy(1);
    const loaded = await load();
    if (loaded.length > 0) {
      use(loaded);
      model.tell('frame');
    }
    model.countBusy(-1);
  }

  /** @param {unknown} error @param {string} about */
  function fail(error, about) {
    if (!isCancelled(error)) model.fail(troubleOf(error, about));
  }

  /** @param {File[]} files */
  const read = (files) => () =>
    readOperands(engine, files, { begin: ({ name }) => model.begin(`Reading ${name}`), fail: (error, { name }) => fail(error, name) });

  async function loadSamples() {
    model.begin('Samples');
    try {
      return await Promise.all(samples.map(({ source, placement }) => loadOperand(engine, source, structuredClone(placement))));
    } catch (error) {
      fail(error, 'the sample parts');
      return [];
    }
  }

  return {
    /** The parts the page opens with. */
    openSamples: () => loadInto(loadSamples, (loaded) => setOperands(loaded, 1)),
    /** One file replaces the chosen operand, several become A, B, ... @param {File[]} files */
    open(files) {
      return loadInto(read(files), (loaded) => {
        if (loaded.length > 1) setOperands(loaded, 1);
        else setOperands(model.operands.with(model.chosen, loaded[0]), model.chosen);
      });
    },
    /** @param {File[]} files */
    add(files) {
      return loadInto(read(files), (loaded) => setOperands([...model.operands, ...loaded], model.operands.length));
    },
    /** Removes the chosen operand, unless it is the only one. */
    remove() {
      if (model.operands.length < 2) return;
      setOperands(model.operands.toSpliced(model.chosen, 1), Math.max(0, model.chosen - 1));
    },
  };
}

/** @typedef {ReturnType<typeof createOperands>} Operands */
