// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the page knows. Parts of the page change it and tell; others listen.
// @ts-check

import { firstWish } from './remesh_wish.js';

/** @typedef {import('./protocol.js').Operand} Operand */
/**
 * @typedef {'operands' | 'chosen' | 'placement' | 'dragging' | 'choice' | 'mode' | 'shown' | 'cancel' | 'again' | 'wish' | 'remesh' | 'unremesh' | 'bin'} Wish what the person does
 * @typedef {Wish | 'busy' | 'result' | 'remeshed' | 'predicted' | 'trouble' | 'frame' | 'frameTrouble'} Topic
 */

/** Who listens to what. */
function createTopics() {
  /** @type {Map<Topic, (() => void)[]>} */
  const listeners = new Map();
  return {
    /** @param {Topic | Topic[]} topics @param {() => void} listener */
    on(topics, listener) {
      for (const topic of [topics].flat()) listeners.set(topic, [...(listeners.get(topic) ?? []), listener]);
    },
    /** @param {Topic} topic */
    tell(topic) {
      for (const listener of listeners.get(topic) ?? []) listener();
    },
  };
}

export function createModel() {
  return {
    ...createTopics(),
    /** @type {Operand[]} */
    operands: [],
    /** Position of the chosen operand. */
    chosen: 0,
    /** True while the handle is being dragged. */
    dragging: false,
    /** @type {import('./protocol.js').Choice} */
    choice: 'union',
    /** @type {import('./protocol.js').GizmoMode} */
    mode: 'translate',
    /** @type {import('./protocol.js').Shown} */
    shown: { edges: false, graph: true, ghosts: true },
    /** Things under way. */
    busy: 0,
    /** The last one that was begun or got on. @type {import('./protocol.js').Work} */
    work: { title: '', fraction: undefined, since: 0 },
    /** What was under way last was cancelled. */
    cancelled: false,
    /** @type {import('./protocol.js').Result | undefined} */
    result: undefined,
    /** The triangles wanted. */
    wish: firstWish(),
    /** About how many that are; undefined when nobody knows. @type {number | undefined} */
    predicted: undefined,
    /** Made of the result. @type {import('./protocol.js').Remeshed | undefined} */
    remeshed: undefined,
    /** The result is looked at as it was before it was remeshed. */
    looksBack: false,
    /** Bin of angles whose triangles are marked. @type {number | undefined} */
    bin: undefined,
    /** The operands changed since, and there is no newer result. */
    isOld: false,
    /** @type {import('./protocol.js').Trouble | undefined} */
    trouble: undefined,

    /** What is remeshed, when that is looked at. @returns {import('./protocol.js').Remeshed | undefined} */
    get remeshedInView() {
      return this.looksBack ? undefined : this.remeshed;
    },
    /** The mesh that is looked at, and taken away. @returns {import('./protocol.js').Remeshed | import('./protocol.js').Result | undefined} */
    get meshInView() {
      return this.remeshedInView ?? this.result;
    },
    /** @returns {Operand | undefined} */
    get chosenOperand() {
      return this.operands[this.chosen];
    },
    /** @param {number} key */
    positionOf(key) {
      return this.operands.findIndex((operand) => operand.key === key);
    },
    /** @param {number} position */
    choose(position) {
      if (position === this.chosen || this.operands[position] === undefined) return;
      this.chosen = position;
      this.tell('chosen');
    },
    /** @param {import('./protocol.js').Trouble | undefined} trouble undefined: there is none, but no result either */
    fail(trouble) {
      this.trouble = trouble;
      this.tell('trouble');
    },
    /** @param {number} step 1 or -1 */
    countBusy(step) {
      if (this.busy === 0) this.cancelled = false;
      this.busy += step;
      this.tell('busy');
    },
    /** @param {string} title */
    begin(title) {
      this.work = { title, fraction: undefined, since: performance.now() };
      this.tell('busy');
    },
    /** @param {string} title @param {number} fraction */
    advance(title, fraction) {
      this.work = { ...this.work, title, fraction };
      this.tell('busy');
    },
    /** Stops whatever is under way. */
    cancel() {
      if (this.busy === 0) return;
      this.cancelled = true;
      this.tell('cancel');
    },
  };
}

/** @typedef {ReturnType<typeof createModel>} Model */

/** A, B, C ... @param {number} position */
export function letterOf(position) {
  return position < 26 ? String.fromCharCode(65 + position) : `#${position + 1}`;
}
