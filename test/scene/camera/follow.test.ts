import { describe, expect, it } from 'vitest';
import { createRig as createCamera, placeEye, updateRig } from '../../../src/scene/camera/cameraRig';
import {
  createTurn,
  createLocalFrame,
  type LocalFrame,
  rotate,
  toLocalPoint,
  turnOfFrame,
} from '../../../src/scene/localFrame';
import { groundPoint } from '../../../src/scene/ground/terrainLevel';
import { createRig } from '../../prediction/rig';

const HZ = 60;
/** Heights of the centre of mass, as the stage begins. */
const DISTANCE = 5.2;

/** The camera over a whole scenario: the eye's worst acceleration, m/s², and how far from the middle the ship came, degrees. */
function watched(scenario: string, seconds: number) {
  const rig = createRig({ scenario, hz: HZ });
  const turn = createTurn();
  let frame: LocalFrame | null = null;
  const place = new Float64Array(3);
  const velocity = new Float64Array(3);
  const spot = new Float64Array(3);
  const camera = createCamera(2, 0.16, 20);
  const path: number[][] = [];
  let angle = 0;
  rig.fly(seconds, (view) => {
    const ship = view.own;
    if (!view.ready || ship === null) return;
    const body = view.bodies[ship.body]!;
    camera.distance = DISTANCE * ship.shipClass.groundContactOffset;
    frame ??= createLocalFrame(body, ship.ghostPosition, { elevation: 15, azimuth: 60 });
    turnOfFrame(turn, frame, body.attitude);
    toLocalPoint(place, frame, turn, ship.meshPosition);
    const [wx, wy, wz] = body.angularVelocity;
    const [x, y, z] = ship.position;
    const [vx, vy, vz] = ship.velocity;
    rotate(velocity, turn.matrix, [
      vx! - (wy * z! - wz * y!),
      vy! - (wz * x! - wx * z!),
      vz! - (wx * y! - wy * x!),
    ]);
    if (ship.crashed) velocity.fill(0);
    updateRig(camera, place, velocity, 1 / HZ);
    const terrainHeight = rig.loaded.terrainHeight;
    placeEye(camera, (gx, gz) => {
      groundPoint(spot, 0, gx, gz, { frame: frame!, terrainHeight });
      return spot[1]!;
    });
    path.push([...camera.eye]);
    angle = Math.max(angle, angleBetween(camera.eye, camera.focus, place));
  });
  return { acceleration: worstAcceleration(path), angle, frames: path.length };
}

/** m/s² */
function worstAcceleration(path: readonly number[][]): number {
  let worst = 0;
  for (let n = 2; n < path.length; n++) {
    const [a, b, c] = [path[n - 2]!, path[n - 1]!, path[n]!];
    const change = [0, 1, 2].map((i) => (c[i]! - 2 * b[i]! + a[i]!) * HZ * HZ);
    worst = Math.max(worst, Math.hypot(...change));
  }
  return worst;
}

/** Degrees between focus and ship as the eye sees them. */
function angleBetween(eye: Float64Array, focus: Float64Array, ship: Float64Array): number {
  const a = [0, 1, 2].map((i) => focus[i]! - eye[i]!);
  const b = [0, 1, 2].map((i) => ship[i]! - eye[i]!);
  const dot = a.reduce((sum, v, i) => sum + v * b[i]!, 0);
  return (Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b)))) * 180) / Math.PI;
}

/**
 * Just above what is measured. A ship that hits the ground at 27 m/s stops within a substep; the eye takes a third of a second.
 * Half of the picture's height is 24°.
 */
const BOUNDS = [
  { name: 'opening', seconds: 14, acceleration: 85, degrees: 6 },
  { name: 'bounce', seconds: 20, acceleration: 145, degrees: 10.5 },
  { name: 'slide', seconds: 14, acceleration: 24, degrees: 1.5 },
  { name: 'topple', seconds: 12, acceleration: 18, degrees: 3.5 },
  { name: 'over-the-edge', seconds: 14, acceleration: 85, degrees: 6 },
  { name: 'into-a-ridge', seconds: 6, acceleration: 1400, degrees: 12 },
] as const;

describe('camera over whole scenarios', () => {
  for (const { name, seconds, acceleration, degrees } of BOUNDS)
    it(`${name}: keeps the ship in the picture and its own acceleration bounded`, () => {
      const seen = watched(name, seconds);
      expect(seen.frames).toBeGreaterThan(seconds * HZ * 0.9);
      expect(seen.acceleration).toBeLessThan(acceleration);
      expect(seen.angle).toBeLessThan(degrees);
    });

  it('moves by less than 8 m/s² for a correction of 0.3 m that is eased over 150 ms', () => {
    const camera = createCamera(2, 0.16, 20);
    const still = new Float64Array(3);
    const place = new Float64Array(3);
    const path: number[][] = [];
    for (let n = 0; n < 120; n++) {
      const since = Math.max(0, n - 10) / HZ;
      // A critically damped spring, within 5 % after 150 ms.
      const rate = 4.74 / 0.15;
      place[0] = 0.3 * (1 - (1 + rate * since) * Math.exp(-rate * since));
      updateRig(camera, place, still, 1 / HZ);
      placeEye(camera, () => -100);
      path.push([...camera.eye]);
    }
    expect(path.at(-1)![0]! - path[0]![0]!).toBeCloseTo(0.3, 2);
    expect(worstAcceleration(path)).toBeLessThan(8);
  });
});
