// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A report as a table for people.
// @ts-check

const labelWidth = 14;

/** Stages shorter than this share of the whole call are not shown. */
const shownShare = 0.05;

/** @param {number} n */
const count = (n) => n.toLocaleString('en-US');

/** @param {number} n */
const number = (n) => String(Number(n.toPrecision(12)));

/** @param {number} n */
const short = (n) => String(Number(n.toPrecision(4)));

/** @param {number} n @param {string} one */
const plural = (n, one, many = `${one}s`) => `${count(n)} ${n === 1 ? one : many}`;

/** @param {import('../index.js').Report} report */
function surface({ closed, oriented, manifold, boundaryEdges, nonManifoldEdges }) {
  const words = [closed ? 'closed' : `open (${plural(boundaryEdges, 'boundary edge')})`, oriented ? 'oriented' : 'not oriented'];
  words.push(manifold ? 'manifold' : `not manifold (${plural(nonManifoldEdges, 'edge')})`);
  return words.join(', ');
}

/** @param {import('../index.js').Box | null} box */
function extent(box) {
  return box === null ? 'empty' : `${box.min.map(number).join(', ')}  to  ${box.max.map(number).join(', ')}`;
}

/** @param {import('../index.js').Report} report */
function parts({ components, genus }) {
  return `${plural(components, 'component')}${genus === null ? '' : `, genus ${genus}`}`;
}

/** @param {import('../index.js').OperandReport} operand */
function operandLine({ name, vertices, triangles, selfContacts }) {
  return `${name ?? ''}  ${plural(triangles, 'triangle')}, ${count(vertices)} vertices${selfContacts ? ', crosses itself' : ''}`.trim();
}

/** @param {import('../index.js').ToleranceReport} tolerance */
function sharing({ movedVertices, madeVertices, largestMove, collapsed, unresolved }) {
  const moved = `${plural(movedVertices, 'vertex', 'vertices')} moved${movedVertices === 0 ? '' : ` by at most ${short(largestMove)}`}, ${count(madeVertices)} made`;
  return `${moved}, ${plural(collapsed.length, 'face')} collapsed, ${count(unresolved.length)} unresolved`;
}

/** @param {import('../index.js').Report} report */
function times({ milliseconds, stages }) {
  const long = stages.filter((stage) => stage.milliseconds >= shownShare * milliseconds);
  const parts = long.map((stage) => `${stage.stage} ${Math.round(stage.milliseconds)}`);
  return `${Math.round(milliseconds)} ms${parts.length === 0 ? '' : ` (${parts.join(', ')})`}`;
}

/**
 * Lines of the mesh itself.
 * @param {import('../index.js').Report} report
 * @returns {[string, string][]}
 */
function meshLines(report) {
  /** @type {[string, string][]} */
  const lines = [
    ['triangles', count(report.triangles)],
    ['vertices', count(report.vertices)],
    ['surface', surface(report)],
    ['parts', parts(report)],
    ['volume', report.volume === null ? 'none' : number(report.volume)],
    ['area', number(report.area)],
    ['box', extent(report.bbox)],
  ];
  if (report.minAngleDeg !== null && report.maxAngleDeg !== null) lines.push(['angles', `${short(report.minAngleDeg)} to ${short(report.maxAngleDeg)} degrees`]);
  if (report.selfIntersections !== null) lines.push(['crossings', report.selfIntersections === 0 ? 'none' : plural(report.selfIntersections, 'pair')]);
  return lines;
}

/**
 * Lines of the call that made the mesh.
 * @param {import('../index.js').Report} report
 * @returns {[string, string][]}
 */
function callLines({ operands, certified, tolerance, graph, contact }) {
  if (operands.length === 0) return [];
  const chains = `${plural(graph.closedLoops, 'closed loop')}, ${plural(graph.openChains, 'open chain')}`;
  return [
    ['certified', certified ? 'yes' : 'no'],
    .../** @type {[string, string][]} */ (tolerance === null ? [] : [['tolerance', sharing(tolerance)]]),
    ['graph', `${count(graph.vertices)} vertices, ${plural(graph.edges, 'edge')}, ${chains}`],
    ['contact', `${plural(contact.points, 'point')}, length ${number(contact.length)}, area ${number(contact.area)}`],
    .../** @type {[string, string][]} */ (operands.map((operand, i) => [i === 0 ? 'operands' : '', operandLine(operand)])),
  ];
}

/**
 * @param {import('../index.js').Report} report
 * @param {[string, string]} title first line
 */
export function reportText(report, title) {
  const notes = report.notes.map((note, i) => /** @type {[string, string]} */ ([i === 0 ? 'notes' : '', note]));
  const lines = [title, ...meshLines(report), ...callLines(report), .../** @type {[string, string][]} */ ([['time', times(report)]]), ...notes];
  return `${lines.map(([label, text]) => `${label.padEnd(labelWidth)}${text}`).join('\n')}\n`;
}
