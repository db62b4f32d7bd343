// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Canvas and camera. Draws when asked to, not all the time.
// @ts-check

import { Group, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { createLight } from './light.js';

const firstView = new Vector3(0.62, -1, 0.52).normalize();

/** @param {HTMLCanvasElement} canvas */
function createRenderer(canvas) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setClearColor(0x000000, 0);
  renderer.toneMapping = NeutralToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

/** Looks at the middle from the front, z upwards. */
function createCamera() {
  const camera = new PerspectiveCamera(30);
  camera.up.set(0, 0, 1);
  camera.position.copy(firstView).multiplyScalar(10);
  return camera;
}

/** Half the angle the camera sees across the shorter side of the view. @param {PerspectiveCamera} camera */
function narrowHalf({ fov, aspect }) {
  const half = (fov * Math.PI) / 360;
  return Math.min(half, Math.atan(Math.tan(half) * aspect));
}

/**
 * Moves the camera so that a box fills the view.
 * @param {OrbitControls} orbit
 * @param {PerspectiveCamera} camera
 * @param {import('three').Box3} box
 */
function frameBox(orbit, camera, box) {
  const { center, radius } = box.getBoundingSphere(new Sphere());
  const direction = camera.position.clone().sub(orbit.target).normalize();
  camera.position.copy(direction).multiplyScalar((0.92 * (radius || 1)) / Math.sin(narrowHalf(camera))).add(center);
  orbit.target.copy(center);
  orbit.update();
}

/** @param {HTMLCanvasElement} canvas */
export function createStage(canvas) {
  const renderer = createRenderer(canvas);
  const scene = new Scene();
  const camera = createCamera();
  const light = createLight(scene, camera);
  const content = new Group();
  scene.add(camera, content);
  const orbit = new OrbitControls(camera, canvas);
  orbit.listenToKeyEvents(canvas);
  orbit.keyPanSpeed = 24;
  orbit.addEventListener('change', invalidate);
  let scheduled = false;

  function invalidate() {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    scheduled = false;
    const distance = camera.position.distanceTo(orbit.target);
    camera.far = distance + orbit.target.distanceTo(light.content.center) + 40 * light.content.radius;
    camera.near = Math.max(distance / 200, camera.far / 1e5);
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  }

  /** What was in view stays in view: the distance follows the shorter side. */
  function resize() {
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight, false);
    const before = Math.sin(narrowHalf(camera));
    camera.aspect = clientWidth / clientHeight;
    camera.position.sub(orbit.target).multiplyScalar(before / Math.sin(narrowHalf(camera))).add(orbit.target);
    orbit.update();
    invalidate();
  }

  /** @param {import('three').Box3} box */
  function frame(box) {
    if (!box.isEmpty()) frameBox(orbit, camera, box);
    invalidate();
  }

  new ResizeObserver(resize).observe(canvas);
  resize();
  return { canvas, scene, content, camera, orbit, light, invalidate, frame };
}

/** @typedef {ReturnType<typeof createStage>} Stage */
