/** The whole scene, drawn in node: three's renderer draws into a context that only counts. */
import { type BufferGeometry, Scene, Vector3 } from 'three';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { hillsTerrain, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { ShipView } from '../../../src/prediction';
import { createSceneView, FINE } from '../../../src/scene';
import { makeShip, makeView, type Pose } from '../../readout/views';
import { toBodyAxes } from '../../../src/scene/localFrame';
import { createCountedCanvas } from './context';
import { type Drawn, frameOf, resourcesOf, shipIn } from './frame';

/** What three drew last. */
let drawn: Drawn;
const { prototype } = Scene;
beforeAll(() => {
  prototype.onBeforeRender = (renderer, scene, camera) => (drawn = { renderer, scene, camera });
});
// The one of all objects is again in place.
afterAll(() => void Reflect.deleteProperty(prototype, 'onBeforeRender'));

function openScene() {
  const counted = createCountedCanvas();
  const warnings: string[] = [];
  const scene = createSceneView(counted.canvas, FINE, { onWarning: (code) => warnings.push(code) });
  scene.resize(800, 600, 2);
  return { ...counted, scene, warnings };
}

const near = (value: number): unknown => expect.closeTo(value, 6);
const THROTTLE = { ...NEUTRAL_CONTROLS, thrustLevel: 0.6, rotationInput: [0.5, 0, 0] } as const;
const WRECK = { shownState: 'crashed', crashed: true, surfaceContactState: 'contact' } as const;

/** The watched ship, and others beside it that are not the pilot's: `aside` m along body x. */
function flight(
  pose: Pose,
  changes: Partial<ShipView> = {},
  others: readonly (Partial<ShipView> & { aside: number })[] = [],
) {
  const view = makeView(pose, changes);
  const beside = others.map(({ aside, ...other }, n) => {
    const ship = { ...makeShip(pose), shipId: `other-${n}`, own: false, body: view.own.body, ...other };
    return moved(ship, aside);
  });
  return { ...view, ships: [view.own, ...beside] };
}

function moved(ship: ShipView, aside: number): ShipView {
  for (const place of [ship.position, ship.meshPosition, ship.easedPosition]) place[0] = place[0]! + aside;
  return ship;
}

type Drawing = ReturnType<typeof openScene>['scene'];
/** Flights of a few frames that show every part of the scene. */
const FLIGHTS: Readonly<Record<string, (scene: Drawing) => void>> = {
  'a ship that brakes over Luna, its fleet beside it'(scene) {
    const pose: Pose = { clearance: 30, east: 6, north: -2, up: -4, tilt: 8, leanTo: 40 };
    const others = [{ aside: 40 }, { aside: -40, controls: THROTTLE }];
    scene.draw(flight(pose, { controls: THROTTLE }, others), 5);
    scene.turnCamera(0.3, 0.1);
    scene.zoomCamera(1.5);
    const after = flight({ ...pose, clearance: 29.5, tiltRate: 0.2 }, { controls: THROTTLE }, others);
    // Far enough for the finest rings of the ground to follow.
    moved(after.own, 9);
    scene.draw(after, 5.1);
  },
  'a crash in hills of Earth, seen from behind'(scene) {
    scene.setTerrain(hillsTerrain);
    scene.setSunElevation(8);
    scene.setCamera('chase');
    const pose: Pose = { body: 'Earth', shipClass: 'cargo_hauler', east: 30, up: -20, terrain: 40 };
    scene.draw(flight({ ...pose, clearance: 4 }), 100);
    scene.draw(flight({ ...pose, clearance: 0 }, WRECK), 100.1);
    scene.draw(flight({ ...pose, clearance: 0 }, WRECK), 100.3);
  },
  'a landing on a pad of Mars with all overlays'(scene) {
    for (const name of Object.keys(scene.overlays) as (keyof Drawing['overlays'])[])
      scene.overlays[name] = true;
    const pose: Pose = { body: 'Mars', shipClass: 'fast_frigate', clearance: 60, up: -3, lift: 4e4 };
    const view = flight(pose, { impactSpeed: 2, legCompression: Float64Array.of(0.1, 0.2, 0, 0.3) });
    const { own, bodies } = view;
    toBodyAxes(own.ghostPosition, bodies[own.body]!.attitude, own.position);
    const pads = [0, 25].map((aside) => ({
      place: own.ghostPosition.map((x, axis) => x + [aside, 0, -10][axis]!),
      radius: 15,
      isNext: aside === 0,
    }));
    Object.assign(scene.markers, { pads, touch: own.position });
    scene.draw(view, 20);
    const touched = flight({ ...pose, clearance: 0.2 }, { surfaceContactState: 'contact', impactSpeed: 3 });
    toBodyAxes(touched.own.ghostPosition, bodies[own.body]!.attitude, own.position);
    touched.own.easedPosition[0] = touched.own.position[0]! + 1;
    scene.draw(touched, 20.05);
    scene.draw(touched, 20.1);
  },
};

it.each(Object.entries(FLIGHTS))('draws %s as recorded, and releases all of it', async (name, fly) => {
  const { scene, held, gpu, warnings } = openScene();
  fly(scene);
  expect([warnings, scene.hasDrawn()]).toEqual([[], false]);
  // A context that is lost draws nothing more.
  gpu.isLost = true;
  expect(scene.hasDrawn()).toBe(true);
  await expect(`${frameOf(drawn).join('\n')}\n`).toMatchFileSnapshot(
    `golden/${name.replaceAll(/\W+/g, '-')}.txt`,
  );
  const left = resourcesOf(drawn);
  expect(left.size).toBeGreaterThan(30);
  for (const thing of left.keys())
    (thing as BufferGeometry).addEventListener('dispose', () => left.delete(thing));
  scene.dispose();
  expect([...left.values()]).toEqual([]);
  // three keeps the program of its own shadow material.
  expect(held).toMatchObject({ Program: 1, Buffer: 0, VertexArray: 0 });
});

it('answers before, during and after its first picture', () => {
  const { scene, held, gpu } = openScene();
  const axes = new Float64Array(9);
  expect([scene.screenAxes(axes), scene.hasDrawn()]).toEqual([false, false]);
  const view = flight({ clearance: 50 });
  scene.draw({ ...view, ready: false }, 1);
  scene.draw({ ...view, own: null, ships: [] }, 1);
  expect(held['Program']).toBe(8);
  scene.draw({ ...view, own: null }, 1);
  expect(held['Program']).toBe(10);

  // The first picture is complete once the GPU has passed the fence.
  expect([scene.hasDrawn(), held['Sync']]).toEqual([false, 1]);
  gpu.isDone = true;
  expect([scene.hasDrawn(), scene.hasDrawn(), held['Sync']]).toEqual([true, true, 0]);
  scene.draw(view, 2);
  expect(held['Sync']).toBe(0);

  // 600 px are the height of what the camera sees at the ship.
  const distance = Math.hypot(...shipIn(drawn));
  expect(scene.pixelSize()).toBeCloseTo((2 * distance * Math.tan((24 * Math.PI) / 180)) / 600, 7);
  expect(scene.screenAxes(axes)).toBe(true);
  expect([0, 3, 6].map((at) => Math.hypot(...axes.slice(at, at + 3)))).toEqual([1, 1, 1].map(near));

  // A camera that was turned and moved, and the one after a reset.
  const first = shipIn(drawn);
  scene.turnCamera(0.5, 0.2);
  scene.zoomCamera(2);
  scene.draw(view, 12);
  const then = shipIn(drawn);
  expect([Math.hypot(...then), then[1]! < first[1]!]).toEqual([near(2 * distance), true]);
  // The eye turns with time: half of the way to where it is wanted takes a moment.
  scene.zoomCamera(0.5);
  scene.draw(view, 12.05);
  expect(Math.hypot(...shipIn(drawn)) / distance).toBeCloseTo(1 + Math.exp(-9 * 0.05), 3);
  scene.resetCamera();
  scene.draw(view, 12.06);
  expect(shipIn(drawn)).toEqual(first.map(near));
});

it('keeps the ship in the middle between the margins, small enough to fit', () => {
  const { scene, warnings } = openScene();
  const view = flight({ clearance: 30 });
  const draw = (seconds: number) => {
    scene.draw(view, seconds);
    const { camera } = drawn;
    const place = new Vector3(...shipIn(drawn)).applyMatrix4(camera.matrixWorldInverse);
    return { y: 300 * (1 - place.clone().applyMatrix4(camera.projectionMatrix).y), distance: place.length() };
  };
  const whole = draw(1);
  expect(whole.y).toBeCloseTo(300, 3);
  scene.setMargins(60, 240);
  const between = draw(1.1);
  expect(between.y).toBeCloseTo((60 + 360) / 2, 3);
  // Half of the height is free, of which a ship and its ground need six tenths.
  expect(between.distance / whole.distance).toBeCloseTo(1.2, 3);
  // However much is covered, the ship stays in sight.
  scene.setMargins(300, 300);
  expect(draw(1.2).distance / whole.distance).toBeCloseTo(3, 3);
  scene.setMargins(0, 0);
  expect(draw(1.3)).toEqual({ y: expect.closeTo(300, 3) as unknown, distance: near(whole.distance) });
  expect(warnings).toEqual([]);
});

it('keeps the ground of a world that begins again where it began, and nothing else of it', () => {
  const { scene } = openScene();
  let asked = 0;
  const hills: typeof hillsTerrain = (...place) => {
    asked += 1;
    return hillsTerrain(...place);
  };
  /** Points of the ground that a draw computes; `aside` m. */
  const askedBy = (aside: number, changes: Partial<ShipView>, seconds: number) => {
    const view = flight({ body: 'Earth', clearance: 0, terrain: 40 }, changes);
    moved(view.own, aside);
    asked = 0;
    scene.draw(view, seconds);
    return asked;
  };
  const effects = () => [
    ...new Set(frameOf(drawn).filter((line) => /^ {2}(Points|Group, hidden)/.test(line))),
  ];
  scene.setTerrain(hills);
  const whole = askedBy(0, {}, 1);
  expect(whole).toBeGreaterThan(10_000);
  askedBy(1, { ...WRECK, impactSpeed: 30 }, 1.1);
  askedBy(1, { ...WRECK, impactSpeed: 30 }, 1.2);
  const crashed = effects();

  scene.setTerrain(hills);
  expect(askedBy(2, {}, 1.3)).toBeLessThan(whole / 100);
  expect(effects()).not.toEqual(crashed);
  expect(effects()).toContain('  Points, hidden');

  // Farther away, and on other ground.
  scene.setTerrain(hills);
  expect(askedBy(70, {}, 1.4)).toBe(whole);
  scene.setTerrain(hillsTerrain);
  askedBy(70, {}, 1.5);
  scene.setTerrain(hills);
  expect(askedBy(70, {}, 1.6)).toBe(whole);
});
