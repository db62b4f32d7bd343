// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The entries export what the declarations say; it is compiled, never run.

import * as browser from '../../src/browser.js';
import type * as declared from '../../src/index.js';
import * as node from '../../src/node.js';

type Functions = Omit<typeof declared, 'MeshError'>;

export const entries: Functions[] = [node, browser];
