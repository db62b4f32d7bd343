// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which triangles are wanted: sliders, how many triangles that makes, and the button.
// @ts-check

import { byId } from '../dom.js';
import { count, plural } from '../numbers.js';
import { diagonalOf, mostTriangles, positionOf, sizeAt } from '../remesh_wish.js';

/** @typedef {import('../model.js').Model} Model */
/** @typedef {import('../protocol.js').RemeshWish} RemeshWish */

/**
 * The sliders that have no field of their own, and what their values are called.
 * @type {Record<'growth' | 'featureAngle' | 'layers', { id: string, text: (value: number) => string }>}
 */
const sliders = {
  growth: { id: 'growth', text: (value) => `× ${value}` },
  featureAngle: { id: 'feature-angle', text: (value) => `${value}°` },
  layers: { id: 'layers', text: (value) => (value === 0 ? 'all' : String(value)) },
};

/** What a screen reader says of a value. @param {string} text */
const spoken = (text) => (text === 'all' ? 'all of the surface changes' : text);

/** @param {Model} model @param {Partial<RemeshWish>} change */
function change(model, change) {
  model.wish = { ...model.wish, ...change };
  model.tell('wish');
}

/** @param {Model} model @param {keyof typeof sliders} name */
function startSlider(model, name) {
  const { id, text } = sliders[name];
  const slider = byId(id, HTMLInputElement);
  const output = /** @type {HTMLOutputElement} */ (slider.nextElementSibling);
  slider.addEventListener('input', () => change(model, { [name]: slider.valueAsNumber }));
  function show() {
    slider.value = String(model.wish[name]);
    output.textContent = text(model.wish[name]);
    slider.setAttribute('aria-valuetext', spoken(output.textContent));
  }
  model.on('wish', show);
  show();
}

/** @param {Model} model */
function startSize(model) {
  const slider = byId('size-slider', HTMLInputElement);
  const field = byId('size', HTMLInputElement);
  const diagonal = () => diagonalOf(model.result?.report.bbox ?? null);
  slider.addEventListener('input', () => change(model, { size: sizeAt(slider.valueAsNumber, diagonal()) }));
  field.addEventListener('input', () => change(model, { size: field.valueAsNumber }));
  model.on(['wish', 'result'], () => {
    const { size } = model.wish;
    if (document.activeElement !== field) field.value = String(size);
    if (document.activeElement !== slider) slider.value = String(positionOf(size, diagonal()));
    slider.setAttribute('aria-valuetext', field.value);
    field.step = String(Number(`1e${Math.floor(Math.log10(size > 0 ? size : 1)) - 1}`));
  });
}

/** @param {Model} model */
function predictedText({ predicted, wish }) {
  if (predicted === undefined) return '';
  if (predicted > mostTriangles) return `More than ${count(mostTriangles)} triangles: too many for this page`;
  return `About ${plural(Number(predicted.toPrecision(3)), 'triangle')}${wish.layers > 0 ? ' if all of the surface changed' : ''}`;
}

/** @param {Model} model */
function startPredicted(model) {
  const words = byId('predicted');
  model.on(['predicted', 'wish'], () => {
    words.textContent = predictedText(model);
    words.dataset.count = String(model.predicted ?? '');
    words.classList.toggle('bad', (model.predicted ?? 0) > mostTriangles);
  });
}

/** What is about the cut needs one. @param {Model} model */
function startCut(model) {
  const finer = byId('finer', HTMLInputElement);
  const growth = byId('growth', HTMLInputElement);
  const layers = byId('layers', HTMLInputElement);
  finer.addEventListener('change', () => change(model, { finer: finer.checked }));
  model.on(['wish', 'result'], () => {
    const hasCut = (model.result?.curves.edges.length ?? 0) > 0;
    finer.checked = model.wish.finer;
    finer.disabled = layers.disabled = !hasCut;
    growth.disabled = !hasCut || !model.wish.finer;
  });
}

/** @param {Model} model */
export function startRemeshWish(model) {
  const button = byId('remesh', HTMLButtonElement);
  startSize(model);
  for (const name of /** @type {const} */ (['growth', 'featureAngle', 'layers'])) startSlider(model, name);
  startCut(model);
  startPredicted(model);
  button.addEventListener('click', () => model.tell('remesh'));
  byId('size').addEventListener('keydown', ({ key }) => key === 'Enter' && model.tell('remesh'));
  model.on(['result', 'trouble'], () => {
    button.disabled = model.result === undefined || model.isOld;
  });
}
