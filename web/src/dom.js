// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Short words for the document.
// @ts-check

/**
 * The element with this id, which index.html must have.
 * @template {HTMLElement} [Kind=HTMLElement]
 * @param {string} id
 * @param {new () => Kind} [kind]
 * @returns {Kind}
 */
export function byId(id, kind = /** @type {any} */ (HTMLElement)) {
  const element = document.getElementById(id);
  if (!(element instanceof kind)) throw new Error(`index.html has no ${kind.name} #${id}`);
  return element;
}

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string>} [attributes]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/**
 * All buttons that carry a data attribute, by its value.
 * @param {string} name
 * @returns {[string, HTMLButtonElement][]}
 */
export function buttonsWith(name) {
  const buttons = /** @type {NodeListOf<HTMLButtonElement>} */ (document.querySelectorAll(`button[data-${name}]`));
  return [...buttons].map((button) => [button.dataset[name] ?? '', button]);
}
