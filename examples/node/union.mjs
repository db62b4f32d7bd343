// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Unites a box and a sphere, then drills through both.

import { make, subtract, transform, union } from 'mortise';

const box = await make('box', { lo: [-1, -1, -1], hi: [1, 1, 1] });
const sphere = await make('icosphere', { radius: 1.3 });
const drill = await transform(await make('cylinder', { radius: 0.5, height: 4 }), [{ translate: [0, 0, -2] }, { rotateX: 30 }]);

const solid = await union(box, sphere);
const { report } = await subtract(solid.mesh, drill);
console.log(`${report.triangles} triangles, volume ${report.volume}, genus ${report.genus}, certified: ${report.certified}`);
