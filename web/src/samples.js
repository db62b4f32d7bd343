// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The parts the page opens with.
// @ts-check

import { unmoved } from './placement.js';

/** @type {{ source: Exclude<import('./protocol.js').Source, { kind: 'file' }>, placement: import('./protocol.js').Placement }[]} */
export const samples = [
  {
    source: { kind: 'shape', name: 'block', shape: 'box', parameters: { lo: [-1.2, -0.8, -0.6], hi: [1.2, 0.8, 0.6] } },
    placement: unmoved(),
  },
  {
    source: { kind: 'shape', name: 'ring', shape: 'torus', parameters: { majorRadius: 0.85, minorRadius: 0.27, around: 96, across: 48 } },
    placement: { move: [0.3, -0.7, 0.65], turn: [0, 90, -40], scale: [1, 1, 1] },
  },
];
