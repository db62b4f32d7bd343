// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The four buttons: which operation on which operands.
// @ts-check

/** @typedef {import('./protocol.js').Choice} Choice */

/** @type {Record<Choice, { operation: import('./protocol.js').Operation, title: string, swaps: boolean }>} */
export const choices = {
  union: { operation: 'union', title: 'Union', swaps: false },
  intersect: { operation: 'intersect', title: 'Intersection', swaps: false },
  first: { operation: 'subtract', title: 'A − B', swaps: false },
  second: { operation: 'subtract', title: 'B − A', swaps: true },
};

/**
 * The operands in the order of the call: for B − A the second comes first.
 * @template Item
 * @param {Choice} choice
 * @param {readonly Item[]} items
 */
export function inOrder(choice, items) {
  return choices[choice].swaps && items.length > 1 ? [items[1], items[0], ...items.slice(2)] : [...items];
}

/** @param {Choice} choice @param {number} count of operands */
export function titleOf(choice, count) {
  const { title, operation } = choices[choice];
  return operation === 'subtract' && count > 2 ? `${title.slice(0, 1)} − others` : title;
}
