// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Light, and the shadow on the ground.
// @ts-check

import { DirectionalLight, HemisphereLight, Mesh, PlaneGeometry, ShadowMaterial, Sphere, Vector3 } from 'three';

const from = new Vector3(-0.45, -0.75, 1.25).normalize();

function createSun() {
  const sun = new DirectionalLight(0xfff6ea, 2.1);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 4;
  return sun;
}

function createGround() {
  const ground = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.16, depthWrite: false }));
  ground.receiveShadow = true;
  ground.visible = false;
  return ground;
}

/** A weaker light that goes with the camera. */
function createFill() {
  const fill = new DirectionalLight(0xe8eeff, 0.9);
  fill.position.set(1, 0.2, 1);
  fill.target.position.set(0, 0, -1);
  return fill;
}

/**
 * @param {import('three').Scene} scene
 * @param {import('three').Camera} camera
 */
export function createLight(scene, camera) {
  const sun = createSun();
  const fill = createFill();
  const ground = createGround();
  const content = new Sphere(new Vector3(), 1);
  camera.add(fill, fill.target);
  scene.add(new HemisphereLight(0xffffff, 0xb9b5af, 2.2), sun, sun.target, ground);

  /** For what is in a box. @param {import('three').Box3} box */
  function fit(box) {
    box.getBoundingSphere(content);
    content.radius ||= 1;
    const { center, radius } = content;
    const reach = 1.3 * radius;
    sun.target.position.copy(center);
    sun.position.copy(from).multiplyScalar(4 * radius).add(center);
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 2 * radius, far: 8 * radius });
    sun.shadow.normalBias = radius / 200;
    sun.shadow.camera.updateProjectionMatrix();
    ground.position.set(center.x, center.y, box.min.z);
    ground.scale.setScalar(24 * radius);
    ground.visible = true;
  }
  return { fit, content };
}
