/** The first picture of every mission and lesson, in every window: the ship and the pad to land on are both in it. */
import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import {
  findScenario,
  LESSONS,
  loadScenario,
  type Mission,
  MISSIONS,
  padPlaces,
} from '../../../src/scenarios';
import { createRig } from '../../../src/scene/camera/cameraRig';
import { aimCamera, FIRST_AZIMUTH, FIRST_ELEVATION } from '../../../src/scene/camera/cameras';
import { groundPoint } from '../../../src/scene/ground/terrainLevel';
import { createLocalFrame, rotate, toBodyAxes } from '../../../src/scene/localFrame';
import type { ShipActor } from '../../../src/scene/ships/shipActor';
import { fieldOfView } from '../../../src/scene/camera/viewCone';
import { lookOf } from '../../../src/scene/sky/bodyLook';
import { NIGHT_ELEVATION, underSun } from '../../../src/scene/sky/underSun';

/** px: phones, a square window, a laptop, a wide screen. */
const WINDOWS = [
  [320, 568],
  [390, 844],
  [768, 700],
  [1280, 720],
  [1280, 800],
  [1920, 1080],
  [2560, 1440],
] as const;
/** Of half the picture, from its middle: nearer to the edge panels cover it. */
const INSIDE = 0.7;

/** Ship and first pad of a mission's start in local axes, m. */
function startOf(mission: Mission) {
  const loaded = loadScenario(findScenario(mission.scenario.name)!);
  if (!loaded.ok) throw new Error(loaded.reason);
  const { body, ship, shipClass, terrainHeight } = loaded.value;
  const { sun } = underSun(lookOf(body.name), mission.night ? NIGHT_ELEVATION : null);
  const inBody = new Float64Array(3);
  toBodyAxes(inBody, body.attitude, Float64Array.from(ship.relativePosition));
  const frame = createLocalFrame(body, inBody, sun);
  const toLocal = (point: ArrayLike<number>) => {
    const local = rotate(new Float64Array(3), frame.axes, point);
    local[1] = local[1]! - frame.radius;
    return local;
  };
  const spot = new Float64Array(3);
  const groundY = (x: number, z: number) => {
    groundPoint(spot, 0, x, z, { frame, terrainHeight });
    return spot[1]!;
  };
  const pad = toLocal(padPlaces(mission, loaded.value)[0]!);
  return { place: toLocal(inBody), pad, height: shipClass.groundContactOffset, groundY };
}

/** Where the first picture of a window shows the ship and the pad: −1 … 1 across and up, NaN behind the eye. */
function firstPicture(mission: Mission, [width, height]: readonly [number, number]) {
  const start = startOf(mission);
  const camera = new PerspectiveCamera(fieldOfView(width / height), width / height, 0.4, 600_000);
  const rig = createRig(FIRST_AZIMUTH, FIRST_ELEVATION, 5.2 * start.height);
  const actor = { ...start, velocity: new Float64Array(3) } as unknown as ShipActor;
  aimCamera(camera, rig, 'follow', { actor, seconds: 0, groundY: start.groundY, pad: start.pad });
  camera.updateMatrixWorld();
  camera.updateProjectionMatrix();
  const shown = (point: Float64Array) => {
    const [x, y, z] = [0, 1, 2].map((k) => point[k]! - rig.eye[k]!) as [number, number, number];
    const inView = new Vector3(x, y, z).applyMatrix4(camera.matrixWorldInverse);
    if (inView.z >= 0) return [NaN, NaN];
    const { x: across, y: up } = inView.applyMatrix4(camera.projectionMatrix);
    return [across, up];
  };
  return { ship: shown(start.place), pad: shown(start.pad) };
}

describe.each([...MISSIONS, ...LESSONS].map((mission) => [mission.scenario.title, mission] as const))(
  '%s',
  (_, mission) => {
    it.each(WINDOWS)('shows ship and pad in a window of %i × %i', (...window) => {
      const { ship, pad } = firstPicture(mission, window);
      for (const each of [...ship, ...pad]) expect(Math.abs(each)).toBeLessThan(INSIDE);
      // Under the ship, as it is for the pilot.
      expect(pad[1]).toBeLessThan(ship[1]!);
    });
  },
);
