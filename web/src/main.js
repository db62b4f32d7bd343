// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The page: starts the worker, the scene and the panel, and opens the sample parts.
// @ts-check

import './style/page.css';
import './style/panel.css';
import './style/remesh.css';

import { startCalculation } from './calculation.js';
import { byId } from './dom.js';
import { startEngine } from './engine.js';
import { createModel } from './model.js';
import { createOperands } from './operands.js';
import { startFiles } from './panel/files.js';
import { startParts } from './panel/parts.js';
import { startPlacementFields } from './panel/placement_fields.js';
import { startRemeshComparison } from './panel/remesh_comparison.js';
import { startRemeshWish } from './panel/remesh_wish.js';
import { startReport } from './panel/report.js';
import { startSheet } from './panel/sheet.js';
import { startShortcuts } from './panel/shortcuts.js';
import { startStatus } from './panel/status.js';
import { startTakeAway } from './panel/take_away.js';
import { startToolbar } from './panel/toolbar.js';
import { startTrouble } from './panel/trouble.js';
import { startWork } from './panel/work.js';
import { startRemeshing } from './remeshing.js';
import { createScene } from './view/scene.js';

const model = createModel();
const engine = startEngine();
const operands = createOperands(model, engine);

startRemeshing(model, engine); // first: what is remeshed goes before anything else looks at a change
startCalculation(model, engine);
model.on('cancel', engine.cancel);
startToolbar(model);
startParts(model, operands);
startFiles(operands);
startPlacementFields(model);
startReport(model);
startRemeshWish(model);
startRemeshComparison(model);
startStatus(model);
startWork(model);
startTrouble(model);
startTakeAway(model, engine);
startShortcuts();
startSheet();
void operands.openSamples(); // the worker starts while the scene is made
try {
  createScene(model, byId('canvas', HTMLCanvasElement));
} catch (error) {
  byId('no-scene').hidden = false;
  console.error(error);
}
