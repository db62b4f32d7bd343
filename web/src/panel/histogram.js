// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How many triangles have which smallest angle: bars after remeshing, a line before. A slider over it marks the triangles of a bar.
// @ts-check

import { binWidth, angleBins, shareBelow } from '../angle_bins.js';
import { byId, make } from '../dom.js';
import { count, measure } from '../numbers.js';

/** @typedef {import('../model.js').Model} Model */
/** @typedef {import('../protocol.js').Remeshed} Remeshed */

const width = 300;
const height = 84;
const barWidth = width / angleBins;

/** Triangles with a smaller angle are poor ones. */
const poor = 30;

/** @param {string} tag @param {Record<string, string | number>} attributes @param {...Element} children */
function draw(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** Heights of the bars: meshes of any size compare by parts of all their triangles. @param {Remeshed} remeshed */
function heightsOf({ before, after }) {
  const shares = [before, after].map(({ angleCounts, triangles }) => angleCounts.map((n) => n / Math.max(1, triangles)));
  const highest = Math.max(...shares.flat()) || 1;
  return shares.map((list) => list.map((share) => (share / highest) * height));
}

/** The upper edge of bars as one line. @param {number[]} heights */
const stepsOf = (heights) => `M0 ${height}${heights.map((h, bin) => `V${height - h}H${(bin + 1) * barWidth}`).join('')}V${height}`;

/** @param {Remeshed} remeshed */
function picture(remeshed) {
  const [before, after] = heightsOf(remeshed);
  const bars = after.map((h, bin) => draw('rect', { class: 'bar', x: bin * barWidth + 0.5, width: barWidth - 1, y: height - h, height: h }));
  const ground = draw('path', { class: 'ground', d: `M0 ${height}H${width}` });
  const line = draw('path', { class: 'line-before', d: stepsOf(before) });
  const chosen = draw('rect', { class: 'chosen-bin', width: barWidth, y: 0, height, x: -barWidth });
  const frame = { viewBox: `0 -2 ${width} ${height + 3}`, preserveAspectRatio: 'none', 'aria-hidden': 'true' };
  return draw('svg', frame, chosen, ...bars, ground, line);
}

/** @param {Remeshed} remeshed */
function summary({ before, after }) {
  const percent = (/** @type {number[]} */ counts) => `${measure(100 * shareBelow(counts, poor), 3)} %`;
  return `Triangles with an angle below ${poor}°: ${percent(before.angleCounts)} before, ${percent(after.angleCounts)} after.`;
}

/** @param {Remeshed} remeshed @param {number} bin */
function binText({ before, after }, bin) {
  return `${bin * binWidth}° to ${(bin + 1) * binWidth}°: ${count(before.angleCounts[bin])} before, ${count(after.angleCounts[bin])} after`;
}

/** The slider that chooses a bar: by keys, by touch, and where the pointer is. @param {Model} model @param {() => void} show */
function createChooser(model, show) {
  const slider = make('input', { type: 'range', id: 'angle-bin', min: '0', max: String(angleBins - 1), value: '0', 'aria-label': 'Mark triangles by their smallest angle' });
  /** @param {number | undefined} bin */
  function choose(bin) {
    if (bin === model.bin) return;
    model.bin = bin;
    if (bin !== undefined) slider.value = String(bin);
    show();
    model.tell('bin');
  }
  const leave = () => choose(slider.matches(':focus-visible') ? slider.valueAsNumber : undefined);
  slider.addEventListener('pointermove', ({ clientX }) => {
    const { left, width: across } = slider.getBoundingClientRect();
    choose(Math.min(angleBins - 1, Math.max(0, Math.floor(((clientX - left) / across) * angleBins))));
  });
  slider.addEventListener('pointerleave', leave);
  slider.addEventListener('blur', () => choose(undefined));
  slider.addEventListener('focus', leave);
  slider.addEventListener('input', () => choose(slider.valueAsNumber));
  return slider;
}

/** @param {Model} model */
export function startHistogram(model) {
  const figure = byId('histogram');
  const caption = make('figcaption', { class: 'muted' });
  const axis = make('div', { class: 'axis-labels', 'aria-hidden': 'true' }, ...['0°', '20°', '40°', '60°'].map((text) => make('span', {}, text)));
  const legend = make('p', { class: 'legend', 'aria-hidden': 'true' }, 'Smallest angle', make('span', { class: 'key-before' }, 'before'), make('span', { class: 'key-after' }, 'after'));
  const chooser = createChooser(model, showBin);
  const plot = make('div', { class: 'plot' });

  function showBin() {
    const { remeshed, bin } = model;
    if (remeshed === undefined) return;
    caption.textContent = bin === undefined ? summary(remeshed) : binText(remeshed, bin);
    chooser.setAttribute('aria-valuetext', binText(remeshed, chooser.valueAsNumber));
    plot.querySelector('.chosen-bin')?.setAttribute('x', String((bin ?? -1) * barWidth));
  }

  figure.append(legend, plot, axis, caption);
  model.on('remeshed', () => {
    if (model.remeshed === undefined) return;
    const hadFocus = chooser === document.activeElement;
    plot.replaceChildren(picture(model.remeshed), chooser);
    if (hadFocus) chooser.focus();
    showBin();
  });
}
