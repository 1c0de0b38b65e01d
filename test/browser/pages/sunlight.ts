/** The scene's own sunlight and ground material on plain shapes, for sunlight.test.ts: pixels that a test can count. */
import {
  BufferAttribute,
  Mesh,
  type Material,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import { BODIES, flatTerrain } from '../../../src/dynamics';
import { createFlame } from '../../../src/scene/effects/flame';
import { createDetailTexture } from '../../../src/scene/ground/detailTexture';
import { createGround } from '../../../src/scene/ground/ground';
import { createGroundMaterial, paintGround, placeGrain } from '../../../src/scene/ground/groundMaterial';
import { createLocalFrame } from '../../../src/scene/localFrame';
import { createCone } from '../../../src/scene/camera/viewCone';
import { lookOf } from '../../../src/scene/sky/bodyLook';
import { createShipMaterial } from '../../../src/scene/ships/shipMaterial';
import { createSunlight } from '../../../src/scene/sky/sunlight';
import { underSun } from '../../../src/scene/sky/underSun';

const SIZE = 256;
/** m: of a ship, and of the shadow map around it. */
const RADIUS = 3;
const REACH = 8;
const ORIGIN = new Float64Array(3);
const body = BODIES.find(({ name }) => name === 'Mars')!;

const renderer = new WebGLRenderer({
  antialias: false,
  preserveDrawingBuffer: true,
  reversedDepthBuffer: true,
});
renderer.setSize(SIZE, SIZE, false);
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;

/**
 * One character per pixel of the picture, from the lowest row up: its code is the sum of red, green and blue. As numbers they would take
 * seconds on their way to the test.
 */
function draw(scene: Scene, camera: PerspectiveCamera): string {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const bytes = new Uint8Array(SIZE * SIZE * 4);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return Array.from({ length: SIZE * SIZE }, (_, i) =>
    String.fromCharCode(bytes[i * 4]! + bytes[i * 4 + 1]! + bytes[i * 4 + 2]!),
  ).join('');
}

function sunOver(scene: Scene, elevation: number) {
  const look = underSun(lookOf(body.name), elevation);
  const frame = createLocalFrame(body, [0, body.radius, 0], look.sun);
  const light = createSunlight();
  light.paint(look, frame);
  light.shade(1, 0);
  light.follow(ORIGIN, ORIGIN, REACH, REACH);
  scene.add(light.group);
  return { look, frame, light };
}

/** A ball of the ships' material: dark paint, so that the sun's share of its light shows. */
function createHull(): Mesh {
  const shape = new SphereGeometry(RADIUS, 96, 64);
  const count = shape.getAttribute('position').count;
  const attribute = (name: string, each: readonly number[]) => {
    const values = Float32Array.from({ length: count * each.length }, (_, i) => each[i % each.length]!);
    shape.setAttribute(name, new BufferAttribute(values, each.length));
  };
  attribute('color', [0.05, 0.05, 0.05]);
  attribute('flex', [0, 0]);
  attribute('compression', [0, 0, 0, 0]);
  attribute('surface', [1, 0, 0]);
  attribute('sunlit', [1]);
  const { surface, shadow } = createShipMaterial();
  const hull = new Mesh(shape, surface);
  hull.customDepthMaterial = shadow;
  hull.castShadow = true;
  return hull;
}

/** The hull under the sun, once in its own shadow and once without any. */
function ball(elevation: number): { shaded: string; plain: string } {
  const scene = new Scene();
  sunOver(scene, elevation);
  const hull = createHull();
  scene.add(hull);
  // From the sun's side and from above.
  const camera = new PerspectiveCamera(40, 1, 0.1, 100);
  camera.position.set(9, 4, 4);
  camera.lookAt(0, 0, 0);
  const take = (receives: boolean) => {
    hull.receiveShadow = receives;
    (hull.material as Material).needsUpdate = true;
    return draw(scene, camera);
  };
  return { shaded: take(true), plain: take(false) };
}

/** Flat ground under the sun from `height` m, looking at what is `away` m off. */
function ground(elevation: number, height: number, away: number, anisotropy: number): string {
  const scene = new Scene();
  const { look, frame, light } = sunOver(scene, elevation);
  const material = createGroundMaterial(createDetailTexture(anisotropy), createFlame().uniforms);
  paintGround(material, { ...look, air: null }, light.direction);
  const eye = Float64Array.of(0, height, 0);
  placeGrain(material, eye);
  const land = createGround(material);
  land.rebuild(frame, flatTerrain);
  land.follow(0, 0, Infinity);
  land.place(eye, createCone());
  scene.add(land.mesh);
  const camera = new PerspectiveCamera(20, 1, 0.4, 600_000);
  // The eye is the origin.
  camera.lookAt(0, -height, away);
  return draw(scene, camera);
}

Object.assign(window, { sunlight: { ball, ground, size: SIZE } });
document.documentElement.dataset['ready'] = 'true';
