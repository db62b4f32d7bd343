// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the built page needs besides the bundle: a content policy and the licences of what is in it.
// @ts-check

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** Scripts of this site only; WebAssembly may be compiled; nothing is evaluated, nothing comes from elsewhere. */
export const contentPolicy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "style-src 'self'",
  "img-src 'self' data:",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** The policy inside the page, for servers that send none. While developing, vite needs more than it allows. @returns {import('vite').Plugin} */
export function policyInPage() {
  return {
    name: 'mortise-content-policy',
    apply: 'build',
    transformIndexHtml: () => [{ tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: contentPolicy }, injectTo: 'head-prepend' }],
  };
}

/** @param {string} path from this file */
const textOf = (path) => readFileSync(fileURLToPath(new URL(path, import.meta.url)), 'utf8');

const rule = '-'.repeat(78);

/** @returns {string} */
function noticesOfPage() {
  const three = textOf('../../node_modules/three/LICENSE').trimEnd();
  const core = textOf('../../THIRD_PARTY_NOTICES').trimEnd();
  return `This page contains three.js (https://threejs.org):\n\n${three}\n\n${rule}\nand the WebAssembly core of Mortise, which contains:\n\n${core}\n`;
}

/** Licences beside the page, which links to them. @returns {import('vite').Plugin} */
export function licences() {
  return {
    name: 'mortise-licences',
    apply: 'build',
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'LICENSE.txt', source: textOf('../../LICENSE') });
      this.emitFile({ type: 'asset', fileName: 'THIRD_PARTY_NOTICES.txt', source: noticesOfPage() });
    },
  };
}
