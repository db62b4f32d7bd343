// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A duct of air with a heater on a plate, as one model for heat transfer: named regions that share their faces. Writes out/duct.geo with
// out/duct.msh: `gmsh out/duct.geo -3` fills all regions with tetrahedra, conforming.

import { mkdirSync, writeFileSync } from 'node:fs';

import { gmshProject, make, model, partition, resultModel } from 'mortise';

const out = new URL('./out/', import.meta.url);
mkdirSync(out, { recursive: true });

/** A box as a model whose only region has a name and a material. */
async function body(name, value, lo, hi) {
  const made = await model(await make('box', { lo, hi }));
  made.attributes.push({ name, kind: 'material', value, targets: [{ dimension: 'region', id: 1 }] });
  return made;
}

const air = await body('air', { conductivity: 0.026 }, [0, 0, 0], [6, 2, 2]);
const plate = await body('plate', { conductivity: 200 }, [1, 0, 0], [5, 2, 0.25]);
const heater = await body('heater', { conductivity: 400, watt: 50 }, [2.5, 0.5, 0.25], [3.5, 1.5, 0.5]);

// The inlet and the outlet are the faces of the duct at its ends: all their vertices have this x.
for (const [name, x] of [['inlet', 0], ['outlet', 6]]) {
  const { positions, triangles } = air.mesh;
  const isThere = (t) => [0, 1, 2].every((k) => positions[3 * triangles[3 * t + k]] === x);
  const ids = Array.from({ length: air.counts.modelFaces }, (_, id) => id).filter((id) => [...air.trianglesOf(id)].every(isThere));
  air.attributes.push({ name, kind: 'boundaryCondition', targets: ids.map((id) => ({ dimension: 'face', id })) });
}

// Where a part lies in the air it takes the air's place: of two materials on one region the later operand's stays.
const parts = [air, plate, heater];
for (const part of parts) part.attributes[0] = { ...part.attributes[0], name: 'material', value: { name: part.attributes[0].name, ...part.attributes[0].value }, policy: { merge: 'second' } };

const result = await partition(parts.map(({ mesh }) => mesh));
const duct = await resultModel(result, parts, { names: ['air', 'plate', 'heater'] });
for (const { name, value, targets } of duct.attributes.filter((attribute) => attribute.name === 'material')) {
  const volume = targets.reduce((sum, { id }) => sum + duct.region(id).volume, 0);
  console.log(`${name} ${value.name}: volume ${volume}, conductivity ${value.conductivity}`);
}

// For the file a region goes by its material, a shared face by both its sides.
const regions = duct.attributes.filter(({ name }) => name === 'material').map((attribute) => ({ ...attribute, name: attribute.value.name }));
const interfaces = duct.interfaces.filter(({ targets }) => targets.some(({ dimension }) => dimension === 'face'));
duct.attributes = [...regions, ...duct.attributes.filter(({ name }) => name !== 'material'), ...interfaces];
for (const { name, area, volume } of duct.measures()) console.log(`${name}: ${volume > 0 ? `volume ${volume}` : `area ${area}`}`);

const { mesh, script } = await gmshProject(duct, { meshFile: 'duct.msh' });
writeFileSync(new URL('duct.msh', out), mesh);
writeFileSync(new URL('duct.geo', out), script);
console.log(`wrote duct.geo and duct.msh: ${duct.counts.regions} regions, ${duct.counts.modelFaces} faces`);
