// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Deck equipment from generated shapes: a gun and a crane. Their feet lie exactly in the plane of the deck.

import { make, transform } from 'mortise';

/** A shape, moved. */
async function placed(shape, parameters, ...steps) {
  return transform(await make(shape, parameters), steps);
}

/** A ring mount, a wedge-shaped turret, an elevated barrel with a muzzle brake. */
export async function gunParts({ x, deck }) {
  const site = { translate: [x, 0, deck] };
  const turret = [[-1.8, -1.2], [0.9, -1.2], [1.6, -0.6], [1.6, 0.6], [0.9, 1.2], [-1.8, 1.2]];
  const barrel = [[0, 0], [0.26, 0], [0.18, 3.6], [0.3, 3.6], [0.3, 4.3], [0.1, 4.3], [0.1, 0.8], [0, 0.8]];
  return Promise.all([
    placed('cylinder', { radius: 1.5, height: 0.5, around: 64 }, site),
    placed('extrude', { outline: turret, height: 1.4 }, { translate: [0, 0, 0.4] }, site),
    placed('revolve', { profile: barrel, around: 40 }, { rotateY: 78 }, { translate: [1.2, 0, 1.1] }, site),
  ]);
}

/** A pedestal, a cab, a jib, a cable and a hook. */
export async function craneParts({ x, deck }) {
  const site = { translate: [x, 0, deck] };
  return Promise.all([
    placed('cylinder', { radius: 0.8, height: 4, around: 48 }, site),
    placed('box', { lo: [-1, -0.9, 3.4], hi: [1.2, 0.9, 4.8] }, { rotateZ: 25 }, site),
    placed('box', { lo: [0, -0.25, -0.25], hi: [9, 0.25, 0.25] }, { rotateY: -35 }, { translate: [0.6, 0, 4.2] }, { rotateZ: 25 }, site),
    placed('cylinder', { radius: 0.06, height: 3, around: 16 }, { translate: [7.7, 0, 6.2] }, { rotateZ: 25 }, site),
    placed('torus', { majorRadius: 0.35, minorRadius: 0.1, around: 40, across: 16 }, { rotateX: 90 }, { translate: [7.7, 0, 6] }, { rotateZ: 25 }, site),
  ]);
}
