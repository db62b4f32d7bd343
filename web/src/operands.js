// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Loading, replacing and removing operands.
// @ts-check

import { unmoved } from './placement.js';
import { samples } from './samples.js';
import { troubleOf } from './trouble.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./protocol.js').Operand} Operand */
/** @typedef {import('./protocol.js').Source} Source */

/**
 * @param {Model} model
 * @param {Engine} engine
 */
export function createOperands(model, engine) {
  let lastKey = 0;

  /** @param {Source} source @param {import('./protocol.js').Placement} placement @returns {Promise<Operand>} */
  async function load(source, placement) {
    const key = ++lastKey;
    const { kind, name } = source;
    const loaded = await engine.call('load', { key, source }, { transfer: kind === 'file' ? [source.bytes] : [] });
    return { ...loaded, key, name, source: kind === 'file' ? { kind, name } : source, placement };
  }

  /** @param {Operand[]} operands @param {number} chosen */
  function setOperands(operands, chosen) {
    const gone = model.operands.filter((operand) => !operands.includes(operand)).map(({ key }) => key);
    model.operands = operands;
    model.chosen = chosen;
    model.tell('operands');
    if (gone.length > 0) void engine.call('forget', { keys: gone });
  }

  /** Reads one file after the other; when one fails nothing changes. @param {File[]} files */
  async function read(files) {
    /** @type {Operand[]} */
    const loaded = [];
    for (const file of files) {
      try {
        loaded.push(await load({ kind: 'file', name: file.name, bytes: await file.arrayBuffer() }, unmoved()));
      } catch (error) {
        void engine.call('forget', { keys: loaded.map(({ key }) => key) });
        model.fail(troubleOf(error, file.name));
        return undefined;
      }
    }
    return loaded;
  }

  /** @param {File[]} files @param {(loaded: Operand[]) => void} use */
  async function readInto(files, use) {
    if (files.length === 0) return;
    model.countBusy(1);
    const loaded = await read(files);
    if (loaded !== undefined) {
      use(loaded);
      model.tell('frame');
    }
    model.countBusy(-1);
  }

  return {
    /** The parts the page opens with. */
    async openSamples() {
      model.countBusy(1);
      try {
        setOperands(await Promise.all(samples.map(({ source, placement }) => load(source, structuredClone(placement)))), 1);
        model.tell('frame');
      } catch (error) {
        model.fail(troubleOf(error, 'the sample parts'));
      }
      model.countBusy(-1);
    },
    /** One file replaces the chosen operand, several become A, B, ... @param {File[]} files */
    open(files) {
      return readInto(files, (loaded) => {
        if (loaded.length > 1) setOperands(loaded, 1);
        else setOperands(model.operands.with(model.chosen, loaded[0]), model.chosen);
      });
    },
    /** @param {File[]} files */
    add(files) {
      return readInto(files, (loaded) => setOperands([...model.operands, ...loaded], model.operands.length));
    },
    /** Removes the chosen operand, unless it is the only one. */
    remove() {
      if (model.operands.length < 2) return;
      setOperands(model.operands.toSpliced(model.chosen, 1), Math.max(0, model.chosen - 1));
    },
  };
}

/** @typedef {ReturnType<typeof createOperands>} Operands */
