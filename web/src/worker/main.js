// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The worker: everything that needs the mesh core. Each message is a call and gets one answer, one after the other.
// @ts-check

import { calls } from './calls.js';
import { plainError } from './plain_error.js';

/** @typedef {import('../protocol.js').Request} Request */
/** @typedef {import('../protocol.js').Answer} Answer */

/**
 * What of a worker's global scope is used; the library of types has windows only.
 * @typedef {object} Scope
 * @property {(message: Answer, transfer?: Transferable[]) => void} postMessage
 * @property {((event: MessageEvent<Request>) => void) | null} onmessage
 */
const scope = /** @type {Scope} */ (/** @type {unknown} */ (globalThis));

/** @typedef {(args: any, tell: (progress: import('../protocol.js').Progress) => void) => Promise<import('../protocol.js').Parcel<any>>} Call */

/** @param {Request} request */
async function answer({ id, name, args }) {
  try {
    const call = /** @type {Call} */ (calls[name]);
    const { value, transfer } = await call(args, (progress) => scope.postMessage({ id, progress }));
    scope.postMessage({ id, value }, transfer);
  } catch (error) {
    scope.postMessage({ id, error: plainError(error) });
  }
}

let last = Promise.resolve();
scope.onmessage = (/** @type {MessageEvent<Request>} */ event) => {
  last = last.then(() => answer(event.data));
};
