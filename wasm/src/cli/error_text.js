// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An error as a line or two for people.
// @ts-check

const mostShown = 5;

/** @param {number} x */
const short = (x) => Number(x.toPrecision(7));

/** @param {import('../index.js').MeshErrorDetails} details */
function placeText({ kind, ids = [], places = [] }) {
  const width = kind === 'vertexPairs' ? 2 : 1;
  const count = ids.length / width;
  const shown = Array.from({ length: Math.min(count, mostShown) }, (_, i) => {
    const at = places[i] === undefined ? '' : ` at (${places[i].map(short).join(', ')})`;
    return `${ids.slice(i * width, (i + 1) * width).join('-')}${at}`;
  });
  const more = count > mostShown ? `, ... (${count} in all)` : '';
  return shown.length === 0 ? '' : `  ${kind}: ${shown.join(', ')}${more}\n`;
}

/**
 * @param {import('../errors.js').MeshError} error
 * @param {string | undefined} verb
 */
export function errorText({ code, message, details }, verb) {
  const hint = code === 'INVALID_ARGUMENT' ? `  mortise ${verb === undefined || verb.startsWith('-') ? '' : `${verb} `}--help tells more\n` : '';
  return `mortise: ${message} [${code}]\n${placeText(details)}${hint}`;
}
