// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// mortise slice IN -o OUT --plane NX,NY,NZ,D
// @ts-check

import { invalidArgument } from '../../errors.js';
import { parseNumbers } from '../arguments.js';
import { displayName, namingFiles, readOperand, send } from '../common.js';
import { exitCode } from '../exit_codes.js';

/** @typedef {import('../../index.js').Section} Section */

/** @param {Float64Array} polygon */
function pointsOf(polygon) {
  return Array.from({ length: polygon.length / 3 }, (_, i) => [...polygon.subarray(3 * i, 3 * i + 3)]);
}

/** Closed polylines: vertices, and lines that come back to their first. @param {Section} section */
function objText({ polygons }) {
  let first = 1;
  return polygons
    .map((polygon) => {
      const points = pointsOf(polygon);
      const line = `l ${points.map((_, i) => first + i).join(' ')} ${first}\n`;
      first += points.length;
      return points.map((p) => `v ${p.join(' ')}\n`).join('') + line;
    })
    .join('');
}

/** @param {Section} section @param {number[]} plane */
function jsonText({ polygons, areas, area }, plane) {
  return `${JSON.stringify({ plane, area, areas: [...areas], polygons: polygons.map(pointsOf) })}\n`;
}

/** @param {import('../common.js').Arguments} args */
function targetOf({ values }) {
  const file = values.output;
  if (file === undefined) throw invalidArgument('-o FILE is missing (-o - writes to the standard output)');
  const format = values.format ?? /\.(obj|json)$/i.exec(file)?.[1].toLowerCase();
  if (format !== 'obj' && format !== 'json') throw invalidArgument('a section is written as .obj or .json: name the format with --format');
  return { file, format };
}

/** @param {Section} section @param {string} name */
function summary({ polygons, area }, name) {
  return `slice         ${name}\npolygons      ${polygons.length}\narea          ${Number(area.toPrecision(12))}\n`;
}

/** @type {import('../common.js').Verb} */
export const sliceVerb = {
  help: `mortise slice IN -o OUT --plane NX,NY,NZ,D

The closed polygons in which the plane of the points p with n . p = D cuts a closed mesh. Seen against the normal, the inside is
on their left. A side that lies in the plane counts when the mesh is behind it.

  --plane NX,NY,NZ,D    normal and offset
  -o, --output FILE     .obj (closed polylines) or .json; - is the standard output
  --format FORMAT       obj or json
  --json                print the summary as JSON
  -q, --quiet           print no summary
`,
  options: {
    help: { type: 'boolean', short: 'h' },
    json: { type: 'boolean' },
    quiet: { type: 'boolean', short: 'q' },
    format: { type: 'string' },
    output: { type: 'string', short: 'o' },
    plane: { type: 'string' },
  },
  run(mortise, args, streams) {
    const { file, format } = targetOf(args);
    if (args.positionals.length !== 1) throw invalidArgument('slice needs one mesh file');
    if (args.values.plane === undefined) throw invalidArgument('slice needs --plane');
    const plane = /** @type {[number, number, number, number]} */ (parseNumbers(args.values.plane, 'plane', 4));
    const mesh = readOperand(mortise, args.positionals[0], { ...args, values: {} }, streams);
    const section = namingFiles(args.positionals, () => mortise.slice(mesh, { plane }));
    const text = format === 'obj' ? objText(section) : jsonText(section, plane);
    send({ file }, new TextEncoder().encode(text), streams);
    if (args.values.quiet) return exitCode.ok;
    const { areas, area } = section;
    const said = args.values.json ? `${JSON.stringify({ plane, polygons: areas.length, area, areas: [...areas] }, null, 2)}\n` : summary(section, displayName(file));
    if (file === '-') streams.err(said);
    else streams.out(said);
    return exitCode.ok;
  },
};
