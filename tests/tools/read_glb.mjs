// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What three.js reads of a GLB file, as JSON: for every mesh of the scene its material's name, its triangles with their corners, its data.
// usage: read_glb.mjs FILE
import { readFileSync } from 'node:fs';
import process from 'node:process';

import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

const bytes = readFileSync(process.argv[2]);
const { scene } = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
const meshes = [];
scene.traverse(({ isMesh, geometry, material }) => {
  if (!isMesh) return;
  const attributes = Object.entries(geometry.attributes).map(([name, { array, itemSize }]) => [name, { itemSize, values: [...array] }]);
  meshes.push({ name: material.name, index: [...geometry.index.array], attributes: Object.fromEntries(attributes) });
});
process.stdout.write(JSON.stringify(meshes));
