// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operations on one mesh: parts, repair, solids of sheets, sections.
// @ts-check

import { checkMesh, checkNumber, checkOptions, checkPlane, describe } from './arguments.js';
import { invalidArgument } from './errors.js';

/** @typedef {import('./glue_types.js').Core} Core */

/** @typedef {import('./glue_types.js').CheckedOperand} CheckedOperand */

/**
 * Calls the core with the operands its errors may be about, and what they are about when they name none; default: the first.
 * @typedef {<Value>(call: (core: Core) => import('./glue_types.js').Answer<Value>, meshes?: CheckedOperand[], whole?: CheckedOperand) => Value} Ask
 */

const waysToSplit = ['components', 'regions'];

/** The steps of a repair in their order. */
export const repairSteps = /** @type {const} */ (['dropDegenerate', 'dropDuplicates', 'cancelOpposites', 'orient', 'flipInsideOut', 'fillPlanarHoles']);

/** @param {any} options */
function checkSteps(options) {
  const checked = checkOptions(options, repairSteps);
  const wrong = repairSteps.find((name) => checked[name] !== undefined && typeof checked[name] !== 'boolean');
  if (wrong !== undefined) throw invalidArgument(`${wrong} must be true or false, not ${describe(checked[wrong])}`);
  return repairSteps.filter((name) => checked[name] === true);
}

/**
 * @param {Ask} ask
 * @returns {Pick<import('./index.js').Mortise, 'split' | 'splitPinches' | 'repair' | 'extrudeTo' | 'slice' | 'cornersToVertices' | 'groupByLabel'>}
 */
export function meshOperations(ask) {
  return {
    split: (mesh, options) => {
      const checked = checkMesh(mesh, 'mesh');
      const { by = 'components' } = checkOptions(options, ['by']);
      if (!waysToSplit.includes(by)) throw invalidArgument(`by is one of ${waysToSplit.join(', ')}, not ${describe(by)}`);
      return ask((core) => core.splitMesh(checked, by), [checked]);
    },
    splitPinches: (mesh) => {
      const checked = checkMesh(mesh, 'mesh');
      return ask((core) => core.splitPinches(checked), [checked]);
    },
    repair: (mesh, steps) => {
      const checked = checkMesh(mesh, 'mesh');
      const names = checkSteps(steps);
      return ask((core) => core.repairMesh(checked, names), [checked]);
    },
    extrudeTo: (mesh, options) => {
      const checked = checkMesh(mesh, 'mesh');
      const z = checkNumber(checkOptions(options, ['z']).z, 'z');
      return ask((core) => core.extrudeTo(checked, z), [checked]);
    },
    slice: (mesh, options) => {
      const checked = checkMesh(mesh, 'mesh');
      const plane = checkPlane(checkOptions(options, ['plane']).plane);
      return ask((core) => core.sliceMesh(checked, plane), [checked]);
    },
    cornersToVertices: (mesh, options) => {
      const checked = checkMesh(mesh, 'mesh');
      const missing = checkNumber(checkOptions(options, ['missing']).missing ?? 0, 'missing');
      return ask((core) => core.cornersToVertices(checked, missing), [checked]);
    },
    groupByLabel: (mesh) => {
      const checked = checkMesh(mesh, 'mesh');
      return ask((core) => core.groupByLabel(checked), [checked]);
    },
  };
}
