// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lends the package the licence files of the repository while it is packed: node legal.mjs copy|remove

import { copyFileSync, rmSync } from 'node:fs';
import process from 'node:process';

const repository = new URL('../../', import.meta.url);
const wasm = new URL('../', import.meta.url);

for (const name of ['LICENSE', 'THIRD_PARTY_NOTICES']) {
  if (process.argv[2] === 'copy') copyFileSync(new URL(name, repository), new URL(name, wasm));
  else rmSync(new URL(name, wasm));
}
