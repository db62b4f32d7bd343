// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Gives the person a file.
// @ts-check

/** @param {Uint8Array} bytes @param {string} name */
export function saveAs(bytes, name) {
  const url = URL.createObjectURL(new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], { type: 'application/octet-stream' }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
