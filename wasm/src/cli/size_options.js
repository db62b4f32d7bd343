// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How verbs are told sizes and the angles that make a model.
// @ts-check

import { MeshError, invalidArgument } from '../errors.js';
import { readBytes } from '../node_files.js';
import { parseNumber } from './arguments.js';
import { namingFiles } from './common.js';

/** @typedef {import('../index.js').SizeSource} SizeSource */

const plainSources = ['point', 'segment', 'segments', 'triangle'];

/** @type {Record<string, string>} what the functions call them */
export const sizeNumbers = { size: 'size', smallest: 'smallest', growth: 'growth', 'feature-angle': 'featureAngle', 'curve-angle': 'curveAngle' };

export const sizesHelp = `  --size H               length of edges where no source asks for less
  --sources FILE.json    where it is less: an array like [{"type": "point", "at": [0, 0, 0], "size": 0.1, "growth": 1.5}] with
                         {"type": "segment", "from": [x, y, z], "to": [x, y, z], "size": h}, {"type": "triangle", "corners": [[...], [...],
                         [...]], "size": h} and {"type": "segments", "from": {"points": [...], "edges": [...]}, "size": h}
  --smallest H           nothing below this, whatever sources ask for
  --growth F             from one triangle to the next away from sources that say nothing else (default 1.2)
  --feature-angle DEG    triangles at a larger angle are of different faces (default 40)
  --curve-angle DEG      edges that turn by more keep the vertex there (default 45)
`;

/**
 * Options of these names, and sources, as the command line takes them.
 * @param {Record<string, string>} numbers
 * @returns {Record<string, import('./arguments.js').Option>}
 */
export function sizeOptionsOf(numbers) {
  return Object.fromEntries([...Object.keys(numbers), 'sources'].map((name) => [name, { type: /** @type {'string'} */ ('string') }]));
}

/**
 * A list of JSON as the typed array it stands for; anything else is left to the checks of the call.
 * @template {Float64ArrayConstructor | Uint32ArrayConstructor} Kind
 * @param {unknown} list
 * @param {Kind} Kind
 */
function typed(list, Kind) {
  return Array.isArray(list) && list.every((x) => typeof x === 'number') ? Kind.from(list) : list;
}

/**
 * A source of JSON as the function takes it.
 * @param {any} source
 * @param {string} name
 */
function plainSource(source, name) {
  if (!plainSources.includes(source?.type)) throw invalidArgument(`${name} must have a type: ${plainSources.join(', ')}`);
  if (source.type !== 'segments') return source;
  return { ...source, from: { points: typed(source.from?.points, Float64Array), edges: typed(source.from?.edges, Uint32Array) } };
}

/** @param {string} file @returns {SizeSource[]} */
function readSources(file) {
  const text = new TextDecoder().decode(readBytes(file));
  return namingFiles([file], () => {
    const list = parseJson(text);
    if (!Array.isArray(list)) throw invalidArgument('sources must be a JSON array');
    return list.map((source, i) => plainSource(source, `sources[${i}]`));
  });
}

/** @param {string} text */
function parseJson(text) {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new MeshError('PARSE_FAILED', `this is no JSON: ${/** @type {Error} */ (cause).message}`, {}, { cause });
  }
}

/**
 * What a call takes: the numbers by its names, and the sources.
 * @param {import('./arguments.js').Arguments} args
 * @param {Record<string, string>} numbers
 * @param {string} verb
 * @returns {any}
 */
export function sizesOf({ values }, numbers, verb) {
  if (values.size === undefined) throw invalidArgument(`${verb} needs --size`);
  const given = Object.entries(numbers).filter(([name]) => values[name] !== undefined);
  const sources = values.sources === undefined ? {} : { sources: readSources(values.sources) };
  return { ...Object.fromEntries(given.map(([name, option]) => [option, parseNumber(values[name], name)])), ...sources };
}
