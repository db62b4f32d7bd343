// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How a CommonJS TypeScript program uses the package; it is compiled, never run.

import mortise = require('mortise');

async function run(): Promise<number> {
  const box: mortise.Mesh = await mortise.make('box');
  const result: mortise.BooleanResult = await mortise.union(box, box);
  const { subtract } = await mortise.load();
  try {
    subtract(result.mesh, box);
  } catch (error) {
    if (error instanceof mortise.MeshError) return error.details.ids?.length ?? 0;
  }
  return result.report.triangles;
}

run().then(console.log);
