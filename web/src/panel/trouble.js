// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An error in words, what it is about, and the way to the places it names.
// @ts-check

import { byId } from '../dom.js';
import { count, plural } from '../numbers.js';

/** What to do about it. @type {Record<string, string>} */
const advice = {
  NOT_CLOSED: 'A solid needs a surface without open edges. Close the holes in the program the file comes from.',
  NOT_ORIENTED: 'Neighbouring triangles must run the same way round. Unify the normals in the program the file comes from.',
  INSIDE_OUT: 'The surface faces inwards. Flip its normals in the program the file comes from.',
  NOT_FINITE: 'A coordinate is not a number.',
  BAD_INDEX: 'A triangle names a vertex that does not exist.',
  PARSE_FAILED: 'The file is damaged, or not of the kind its name says.',
  UNKNOWN_FORMAT: 'Files may be STL, OBJ, PLY, OFF, MSH, VTK, VTU or MESH.',
  OUT_OF_MEMORY: 'The meshes are too large for this browser.',
  INVALID_ARGUMENT: 'Type a size larger than 0, in the unit of the parts.',
  RESULT_TOO_LARGE: 'Ask for fewer triangles: when remeshing, a larger size; otherwise, parts that have fewer.',
  OUT_OF_RANGE: 'Coordinates this large do not fit. Use a smaller scale.',
};

/** @type {Record<string, string>} */
const placeNames = { vertices: 'place', faces: 'face', vertexPairs: 'edge' };

/** The core names this many places at most. */
const mostPlaces = 1000;

/** @param {import('../protocol.js').Trouble} trouble */
function placesText({ details }) {
  const number = details.places?.length ?? 0;
  const name = placeNames[details.kind ?? 'vertices'] ?? 'place';
  if (number === 0) return '';
  if (number === mostPlaces) return `The first ${count(number)} ${name}s are marked in the view.`;
  return `${plural(number, name)} ${number === 1 ? 'is' : 'are'} marked in the view.`;
}

/** @param {import('../model.js').Model} model */
export function startTrouble(model) {
  const box = byId('trouble');
  const show = byId('show-places', HTMLButtonElement);
  function update() {
    const { trouble } = model;
    const isNew = box.hidden;
    box.hidden = trouble === undefined;
    if (trouble === undefined) return;
    byId('trouble-title').textContent = trouble.about === '' ? 'This did not work' : trouble.about;
    byId('trouble-message').textContent = trouble.message;
    byId('trouble-code').textContent = trouble.code;
    const old = model.isOld ? 'The last good result is kept, shown faintly.' : '';
    byId('trouble-advice').textContent = [advice[trouble.code], placesText(trouble), old].filter(Boolean).join(' ');
    show.hidden = (trouble.details.places?.length ?? 0) === 0;
    if (isNew) box.scrollIntoView({ block: 'nearest' }); // the button that was refused may be far below
  }
  model.on(['trouble', 'result'], update);
  show.addEventListener('click', () => model.tell('frameTrouble'));
}
