// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Canvas, camera, light and ground. Draws when asked to, not all the time.
// @ts-check

import {
  Box3, DirectionalLight, Group, HemisphereLight, Mesh, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, PlaneGeometry, Scene, ShadowMaterial,
  Sphere, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const firstView = new Vector3(0.62, -1, 0.52).normalize();
const lightFrom = new Vector3(-0.45, -0.75, 1.25).normalize();

/** @param {HTMLCanvasElement} canvas */
function createRenderer(canvas) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setClearColor(0x000000, 0);
  renderer.toneMapping = NeutralToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

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

/** @param {HTMLCanvasElement} canvas */
export function createStage(canvas) {
  const renderer = createRenderer(canvas);
  const scene = new Scene();
  const camera = new PerspectiveCamera(30);
  camera.up.set(0, 0, 1);
  camera.position.copy(firstView).multiplyScalar(10);
  const content = new Group();
  const sun = createSun();
  const fill = new DirectionalLight(0xe8eeff, 0.9);
  const ground = createGround();
  camera.add(fill, fill.target);
  fill.position.set(1, 0.2, 1);
  fill.target.position.set(0, 0, -1);
  scene.add(new HemisphereLight(0xffffff, 0xb9b5af, 2.2), sun, sun.target, camera, ground, content);

  const orbit = new OrbitControls(camera, canvas);
  orbit.listenToKeyEvents(canvas);
  orbit.keyPanSpeed = 24;
  orbit.addEventListener('change', invalidate);
  const sphere = new Sphere(new Vector3(), 1);
  let scheduled = false;

  function invalidate() {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    scheduled = false;
    const distance = camera.position.distanceTo(orbit.target) + orbit.target.distanceTo(sphere.center);
    camera.far = distance + 40 * sphere.radius;
    camera.near = Math.max(camera.position.distanceTo(orbit.target) / 200, camera.far / 1e5);
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight, false);
    camera.aspect = clientWidth / clientHeight;
    camera.updateProjectionMatrix();
    invalidate();
  }

  /** Light and shadow for what is there. @param {Box3} box */
  function fitLight(box) {
    box.getBoundingSphere(sphere);
    sphere.radius ||= 1;
    const reach = 1.3 * sphere.radius;
    sun.target.position.copy(sphere.center);
    sun.position.copy(lightFrom).multiplyScalar(4 * sphere.radius).add(sphere.center);
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 2 * sphere.radius, far: 8 * sphere.radius });
    sun.shadow.normalBias = sphere.radius / 200;
    sun.shadow.camera.updateProjectionMatrix();
    ground.position.set(sphere.center.x, sphere.center.y, box.min.z);
    ground.scale.setScalar(24 * sphere.radius);
    ground.visible = true;
    invalidate();
  }

  /** Moves the camera so that a box fills the view. @param {Box3} box */
  function frame(box) {
    if (box.isEmpty()) return;
    const around = box.getBoundingSphere(new Sphere());
    const half = (camera.fov * Math.PI) / 360;
    const narrow = Math.min(half, Math.atan(Math.tan(half) * camera.aspect));
    const direction = camera.position.clone().sub(orbit.target).normalize();
    camera.position.copy(direction).multiplyScalar((0.92 * (around.radius || 1)) / Math.sin(narrow)).add(around.center);
    orbit.target.copy(around.center);
    orbit.update();
    invalidate();
  }

  new ResizeObserver(resize).observe(canvas);
  resize();
  return { canvas, scene, content, camera, orbit, renderer, invalidate, fitLight, frame };
}

/** @typedef {ReturnType<typeof createStage>} Stage */
