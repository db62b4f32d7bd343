// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What came out, in numbers. Each number also stands in full in the value of its <data> element.
// @ts-check

import { byId, make } from '../dom.js';
import { count, duration, measure, plural } from '../numbers.js';

/** @typedef {import('mortise').Report} Report */
/** @typedef {[string, Node | string]} Line */

/** @param {number | null} value @param {string} text */
export function number(value, text) {
  const data = make('data', { value: String(value) }, text);
  if (value !== null && String(value) !== text) data.title = String(value);
  return data;
}

/** @param {boolean} good @param {string} yes @param {string} no */
const verdict = (good, yes, no) => make('span', { class: good ? 'good' : 'bad' }, good ? `✓ ${yes}` : `✕ ${no}`);

/** @param {Report} report */
function verdicts({ closed, manifold, certified }) {
  const words = [verdict(closed, 'closed', 'open'), verdict(manifold, 'manifold', 'not manifold'), verdict(certified, 'certified', 'not certified')];
  return [make('dt', { class: 'unseen' }, 'Surface'), make('dd', { class: 'verdicts' }, ...words)];
}

/** A note with its numbers cut to three digits. @param {string} note */
const shortNote = (note) => note.replace(/\d+\.\d{4,}(e[+-]?\d+)?/g, (number) => measure(Number(number), 3));

/** @param {Report['contact']} contact */
function contactText({ points, length, area }) {
  const words = [area > 0 ? `area ${measure(area)}` : '', length > 0 ? `length ${measure(length)}` : '', points > 0 ? plural(points, 'point') : ''];
  return words.filter(Boolean).join(', ') || 'none';
}

/** @param {Report} report @param {number} milliseconds @returns {Line[]} */
function linesOf(report, milliseconds) {
  const { triangles, volume, area, genus, components, selfIntersections, contact, graph } = report;
  return [
    ['Triangles', number(triangles, count(triangles))],
    ['Volume', number(volume, volume === null ? 'none' : measure(volume))],
    ['Area', number(area, measure(area))],
    ['Components', number(components, count(components))],
    ['Genus', number(genus, genus === null ? 'none' : count(genus))],
    ['Crossings', number(selfIntersections, selfIntersections === null ? 'not counted yet' : selfIntersections === 0 ? 'none' : plural(selfIntersections, 'pair'))],
    ['Intersection', `${plural(graph.closedLoops, 'loop')}${graph.openChains > 0 ? `, ${plural(graph.openChains, 'chain')}` : ''}`],
    ['Contact', contactText(contact)],
    ['Time', make('span', { title: 'of the call; and with moving the parts and shading' }, `${duration(report.milliseconds)} (${duration(milliseconds)} in all)`)],
  ];
}

/** @param {import('../model.js').Model} model */
export function startReport(model) {
  const list = byId('report');
  const notes = byId('notes');
  model.on('result', () => {
    if (model.result === undefined) return;
    const { report, milliseconds } = model.result;
    const lines = linesOf(report, milliseconds).flatMap(([term, text]) => [make('dt', {}, term), make('dd', {}, text)]);
    list.replaceChildren(...verdicts(report), ...lines);
    notes.replaceChildren(...report.notes.map((note) => make('li', { title: note }, shortNote(note))));
    notes.hidden = report.notes.length === 0;
  });
}
