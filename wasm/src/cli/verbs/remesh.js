// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise remesh IN -o OUT --size H
// @ts-check

import { MeshError, invalidArgument } from '../../errors.js';
import { readBytes } from '../../node_files.js';
import { parseNumber } from '../arguments.js';
import { namingFiles, readOperand, targetOf, writePlain, writingOptions } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @typedef {import('../../index.js').SizeSource} SizeSource */
/** @typedef {import('../../index.js').TriangleShapes} TriangleShapes */

const plainSources = ['point', 'segment', 'segments', 'triangle'];

/** @type {Record<string, string>} what the function calls them */
const numberOptions = { size: 'size', smallest: 'smallest', growth: 'growth', 'feature-angle': 'featureAngle', 'curve-angle': 'curveAngle', 'most-triangles': 'mostTriangles' };

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

/** @param {import('../arguments.js').Arguments} args @returns {any} */
function optionsOf({ values }) {
  const given = Object.entries(numberOptions).filter(([name]) => values[name] !== undefined);
  const sources = values.sources === undefined ? {} : { sources: readSources(values.sources) };
  return { ...Object.fromEntries(given.map(([name, option]) => [option, parseNumber(values[name], name)])), ...sources };
}

/** @param {string} when @param {TriangleShapes} shapes */
function shapesText(when, { triangles, minAngleDeg, maxAngleDeg }) {
  const short = (/** @type {number} */ n) => String(Number(n.toPrecision(4)));
  const angles = minAngleDeg === null || maxAngleDeg === null ? '' : `, angles ${short(minAngleDeg)} to ${short(maxAngleDeg)} degrees`;
  return `${when}: ${triangles.toLocaleString('en-US')} triangles${angles}`;
}

/** @type {import('../common.js').Verb} */
export const remeshVerb = {
  help: `mortise remesh IN -o OUT --size H

The same model (faces, edges and corners by angles and labels) with triangles of the size wanted. Corners stay, edges stay edges.

  --size H               length of edges where no source asks for less
  --sources FILE.json    where it is less: an array like [{"type": "point", "at": [0, 0, 0], "size": 0.1, "growth": 1.5}] with
                         {"type": "segment", "from": [x, y, z], "to": [x, y, z], "size": h}, {"type": "triangle", "corners": [[...], [...],
                         [...]], "size": h} and {"type": "segments", "from": {"points": [...], "edges": [...]}, "size": h}
  --smallest H           nothing below this, whatever sources ask for
  --growth F             from one triangle to the next away from sources that say nothing else (default 1.2)
  --feature-angle DEG    triangles at a larger angle are of different faces (default 40)
  --curve-angle DEG      edges that turn by more keep the vertex there (default 45)
  --most-triangles N     sizes that ask for more are refused (default 20 million)
  -o, --output FILE      .stl .obj .ply .off .glb .msh .vtk .vtu .mesh .inp .bdf; - is the standard output
  --format FORMAT        stl, stl-ascii, obj, ply, ply-ascii, off, msh, msh22, vtk, vtu, mesh; glb, inp, bdf:
                         of the output, and of a mesh from - (the standard input)
  --json                 print the report as JSON, with before, after and the count predicted
  -q, --quiet            print no report
`,
  options: { ...writingOptions, ...Object.fromEntries([...Object.keys(numberOptions), 'sources'].map((name) => [name, { type: /** @type {'string'} */ ('string') }])) },
  run(mortise, args, streams) {
    targetOf(args);
    if (args.positionals.length !== 1) throw invalidArgument('remesh needs one mesh file');
    if (args.values.size === undefined) throw invalidArgument('remesh needs --size');
    const options = optionsOf(args);
    const given = readOperand(mortise, args.positionals[0], args, streams);
    const { mesh, predicted, before, after } = mortise.remesh(given, options);
    const notes = [shapesText('before', before), shapesText('after', after), `${Math.round(predicted).toLocaleString('en-US')} triangles predicted`];
    writePlain(mortise, mesh, { verb: 'remesh', args, streams, notes, more: { predicted, before, after } });
    return exitCode.ok;
  },
};
