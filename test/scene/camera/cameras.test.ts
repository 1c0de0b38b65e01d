import { PerspectiveCamera } from 'three';
import { expect, it } from 'vitest';
import { createRig } from '../../../src/scene/camera/cameraRig';
import { aimCamera, type CameraView } from '../../../src/scene/camera/cameras';
import type { ShipActor } from '../../../src/scene/ships/shipActor';

/** A ship 100 m up that stands upright (its z axis is local y) and flies along −x. */
function flying(): ShipActor {
  const half = Math.SQRT1_2;
  return {
    place: Float64Array.of(20, 100, -30),
    velocity: Float64Array.of(-12, -1, 0),
    // A quarter turn about −x: body z points up.
    turn: Float64Array.of(-half, 0, 0, half),
    height: 4,
  } as ShipActor;
}

/** Unit vector from the eye to the focus after ten seconds under a view. */
function lookOf(view: CameraView): { way: number[]; eye: number[]; camera: PerspectiveCamera } {
  const camera = new PerspectiveCamera(48, 16 / 9, 0.4, 1000);
  const rig = createRig(1.9, 0.16, 24);
  const place = { actor: flying(), seconds: 0.1, groundY: () => 0, pad: null };
  for (let n = 0; n < 100; n++) aimCamera(camera, rig, view, place);
  const way = [0, 1, 2].map((k) => rig.focus[k]! - rig.eye[k]!);
  const length = Math.hypot(...way);
  return { way: way.map((each) => each / length), eye: [...rig.eye], camera };
}

it('chases from behind, facing the direction of motion', () => {
  const { way, eye } = lookOf('chase');
  expect(way[0]).toBeLessThan(-0.9);
  expect(Math.abs(way[2]!)).toBeLessThan(0.05);
  expect(eye[1]).toBeGreaterThan(100);
});

it('looks straight down from above, with a defined up direction', () => {
  const { way } = lookOf('above');
  expect(way[1]).toBeLessThan(-0.99);
  expect(Math.hypot(way[0]!, way[2]!)).toBeGreaterThan(0.01);
});

it('sits in the ship and turns with it: the ship’s z axis is up', () => {
  const { eye, camera, way } = lookOf('cockpit');
  expect(Math.hypot(eye[0]! - 20, eye[1]! - 100, eye[2]! + 30)).toBeLessThan(4);
  expect(camera.up.y).toBeCloseTo(1, 12);
  // Ahead is body y, here local −z, slightly downward.
  expect(way[2]).toBeLessThan(-0.9);
  expect(way[1]).toBeLessThan(0);
});

it('stays in place as free camera', () => {
  const rig = createRig(1.9, 0.16, 24);
  const camera = new PerspectiveCamera();
  const actor = flying();
  const place = { actor, seconds: 0.1, groundY: () => 0, pad: null };
  aimCamera(camera, rig, 'follow', place);
  const before = [...rig.eye];
  actor.place[0] = -500;
  aimCamera(camera, rig, 'free', place);
  expect([...rig.eye]).toEqual(before);
});

it('looks down on the pad from high up, and from the side near the ground, and keeps manual rotation', () => {
  const rig = createRig(1.9, 0.16, 24);
  const camera = new PerspectiveCamera();
  const actor = flying();
  const place = { actor, seconds: 0.1, groundY: () => 0, pad: [20, 0, -30] };
  aimCamera(camera, rig, 'follow', place);
  // Of a quarter turn: from 100 m up almost straight down.
  expect(rig.elevation).toBeGreaterThan(1.2);
  expect(rig.elevation).toBeLessThan(1.4);
  rig.elevation += 0.1;
  actor.place[1] = 5;
  aimCamera(camera, rig, 'follow', place);
  expect(rig.elevation).toBeCloseTo(0.26, 12);
});
