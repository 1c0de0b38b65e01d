/** Poses that are drawn but not simulated: between the server's states, in the newest one, and eased after a correction. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  CONTACT,
  FLYING,
  POSITION,
  type Quat,
  SHIP_STRIDE,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
} from '../../../src/dynamics';
import { captureDrawn, easeCorrection, fadeFromHeld } from '../../../src/prediction/drawn/correction';
import { rowOfPolicy } from '../../../src/prediction/drawn/interpolate';
import { rowToBodyAxes } from '../../../src/prediction/simulation/rings/serverStates';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { wallOfTick } from '../../../src/prediction/time/timeline';
import { conjugate, cross, plus, product, rotate, times, turnAbout, unit } from '../../dynamics/vectors';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
const AXIS = unit([2, -3, 6]);
const BODY = turnAbout(unit([1, 2, 2]), 0.7);
const SPIN: Vec3 = [1e-4, -2e-4, 3e-4];
const [PLACE, MOVING, FALLING]: Vec3[] = [
  [1e6, -2e6, 5e5],
  [30, -20, 10],
  [1, 2, -3],
];
const TILT = turnAbout(unit([1, -1, 3]), 0.4);

const read = (row: Float64Array, column: number, count = 3) => [...row.subarray(column, column + count)];
const near = (found: readonly number[], expected: readonly number[], digits = 6) => {
  for (const [k, x] of expected.entries()) expect(found[k]).toBeCloseTo(x, digits);
};

/** A ship that falls from PLACE in the body's axes, and turns about AXIS by 2 rad/s, after `seconds`. */
const falling = (seconds: number) => ({
  place: plus(plus(PLACE!, MOVING!, seconds), FALLING!, seconds ** 2 / 2),
  velocity: plus(MOVING!, FALLING!, seconds),
  attitude: product(turnAbout(AXIS, 2 * seconds), TILT),
  spin: [0.1 + seconds, -0.2, 0.3 * seconds] as Vec3,
});
function stateAt(seconds: number, state = FLYING, sign = 1) {
  const { place, velocity, attitude, spin } = falling(seconds);
  const row = new Float64Array(SHIP_STRIDE);
  row.set(place, POSITION);
  row.set(velocity, VELOCITY);
  row.set(
    attitude.map((x) => x * sign),
    ATTITUDE,
  );
  row.set(spin, ANGULAR_VELOCITY);
  row[SURFACE_STATE] = state;
  return row;
}

/** The row drawn `wall` s after the first of these states, a tick of 0.1 wall s apart, at four game s per wall s. */
function drawn(wall: number, states: readonly Float64Array[], held?: Vec3) {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'other', 'landed');
  track.policy = 'interpolate';
  track.states = { ticks: states.map((_, i) => TICK + i), rows: [...states] };
  if (held !== undefined) {
    track.picture.hasHeld = true;
    track.picture.heldPlace.set(held);
    track.picture.heldAttitude.set(TILT);
  }
  const at = wallOfTick(sim.timeline, TICK) + wall;
  const row = rowOfPolicy(sim, track, {
    bodyAttitudes: [Float64Array.from(BODY)],
    bodySpins: [Float64Array.from(SPIN)],
    playback: { timeline: sim.timeline, at, timeScale: 4 },
  });
  return { row, picture: track.picture };
}

function expectMotion(row: Float64Array, { place, velocity, attitude, spin }: ReturnType<typeof falling>) {
  const there = rotate(BODY, place);
  near(read(row, POSITION), there, 5);
  near(read(row, VELOCITY), plus(rotate(BODY, velocity), cross(SPIN, there)));
  near(read(row, ANGULAR_VELOCITY), rotate(BODY, spin), 9);
  const expected = product(BODY, attitude);
  const found = read(row, ATTITUDE, 4);
  const sign = Math.sign(found.reduce((sum, x, k) => sum + x * expected[k]!, 0));
  near(
    found.map((x) => x * sign),
    expected,
    9,
  );
}

describe('a ship drawn between two server states', () => {
  const path = [stateAt(0), stateAt(0.4), stateAt(0.8)];

  it.each([0, 0.025, 0.07, 0.1, 0.13, 0.2])(
    'follows its fall and rotation on the turning body: after %d s',
    (wall) => {
      expectMotion(drawn(wall, path).row, falling(4 * wall));
    },
  );

  it('turns the short way if the attitudes have opposite signs', () => {
    expectMotion(drawn(0.05, [stateAt(0), stateAt(0.4, FLYING, -1)]).row, falling(0.2));
  });

  it('stays at the first state before it, and at the last state after it', () => {
    expectMotion(drawn(-0.5, path).row, falling(0));
    expectMotion(drawn(5, path).row, falling(0.8));
  });

  it.each([
    [CONTACT, FLYING],
    [FLYING, CONTACT],
  ])('moves on a straight line if one of them is on the ground: surface states %i, %i', (first, second) => {
    const [from, to] = [falling(0), falling(0.4)];
    const { row } = drawn(0.025, [stateAt(0, first), stateAt(0.4, second)]);
    near(read(row, POSITION), rotate(BODY, plus(times(from.place, 0.75), to.place, 0.25)), 5);
  });

  it('fades from the held pose, and holds its own for the next change', () => {
    const { picture } = drawn(0.05, path, plus(PLACE!, [3, 4, -5]));
    const { place } = falling(0.2);
    near(read(picture.ease.offset, 0), plus(plus(PLACE!, [3, 4, -5]), place, -1), 5);
    near(read(picture.ease.turn, 0), times(AXIS, -0.4), 9);
    near(read(picture.heldPlace, 0), place, 5);
    expect([picture.hasHeld, picture.ease.active]).toEqual([false, true]);
  });

  it('is converted to the body’s axes and back without change', () => {
    const bodies = new Float64Array(BODY_STRIDE);
    bodies.set(BODY, BODY_ATTITUDE);
    bodies.set(SPIN, BODY_ANGULAR_VELOCITY);
    const own = drawn(0, path).row.slice();
    rowToBodyAxes(own, bodies);
    near(read(own, POSITION), PLACE!, 5);
    near(read(own, VELOCITY), MOVING!);
    near(read(own, ANGULAR_VELOCITY), falling(0).spin, 9);
    near(read(own, ATTITUDE, 4), TILT, 9);
  });
});

/** A ship in step that a correction moves by `by`, m, in ICRF, and turns by `angle`, rad. */
function corrected(by: Vec3, { angle = 0, speed = 0, serverTick = TICK, silence = 0, ...style }: Correction) {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'landed');
  const { front, previous } = sim.fleet;
  sim.alpha = 1;
  track.serverTick = serverTick;
  track.silence = silence;
  front.fill(0, track.at + VELOCITY, track.at + VELOCITY + 3);
  front[track.at + VELOCITY + 1] = speed;
  track.mode = style.mode ?? 'stepping';
  const before = captureDrawn(sim, track);
  if (style.slows) front[track.at + VELOCITY + 1] = 0;
  for (const rows of [front, previous]) {
    rows.set(plus(read(rows, track.at + POSITION) as unknown as Vec3, by), track.at + POSITION);
    const attitude = read(rows, track.at + ATTITUDE, 4) as unknown as Quat;
    rows.set(product(turnAbout(AXIS, angle), attitude), track.at + ATTITUDE);
  }
  easeCorrection(sim, track, before, { snaps: style.snaps ?? false, uprights: false });
  const body = read(boundaryAt(sim.bodies, sim.timeline, TICK), BODY_ATTITUDE, 4) as unknown as Quat;
  return { ...track.picture, body, snaps: sim.counters.snaps };
}
interface Correction {
  readonly angle?: number;
  readonly speed?: number;
  readonly serverTick?: number;
  readonly silence?: number;
  readonly snaps?: boolean;
  readonly slows?: boolean;
  readonly mode?: 'stepping' | 'waiting';
}

describe('a correction', () => {
  it('goes into the drawn offset, in the body’s axes', () => {
    const { ease, body, snaps } = corrected([3, -4, 12], { angle: 0.5 });
    near(read(ease.offset, 0), rotate(conjugate(body), [-3, 4, -12]), 5);
    near(read(ease.turn, 0), rotate(conjugate(body), times(AXIS, -0.5)), 6);
    expect([ease.active, snaps]).toEqual([true, 0]);
  });

  // Ticks are 0.1 s long.
  it.each<readonly [string, number, Correction, boolean]>([
    ['of 24.9 m', 24.9, {}, true],
    ['of 25.1 m', 25.1, {}, false],
    ['of 29.9 m, 0.5 s after a state at 10 m/s', 29.9, { speed: 10, serverTick: TICK - 5 }, true],
    ['of 30.1 m, 0.5 s after it', 30.1, { speed: 10, serverTick: TICK - 5 }, false],
    [
      'of 34.9 m after a silence of another 0.5 s',
      34.9,
      { speed: 10, serverTick: TICK - 5, silence: 0.5 },
      true,
    ],
    ['of 35.1 m after it', 35.1, { speed: 10, serverTick: TICK - 5, silence: 0.5 }, false],
    ['of 29.9 m that stops the ship', 29.9, { speed: 10, serverTick: TICK - 5, slows: true }, true],
    ['by 59°', 1, { angle: (59 * Math.PI) / 180 }, true],
    ['by 61°', 1, { angle: (61 * Math.PI) / 180 }, false],
    ['of a ship that respawned', 1, { snaps: true }, false],
  ])('%s', (_, metres, how, isEased) => {
    const { ease, snaps } = corrected([0, 0, metres], how);
    expect([ease.active, snaps]).toEqual([isEased, isEased ? 0 : 1]);
  });

  it('of a ship that was not drawn is neither eased nor counted', () => {
    const { ease, snaps } = corrected([3, 0, 0], { mode: 'waiting' });
    expect([ease.active, snaps]).toEqual([false, 0]);
  });

  it.each([
    [44.9, true],
    [45.1, false],
  ])('by a change of policy over %d m, 2 s at 10 m/s included, is eased: %s', (metres, isEased) => {
    const { sim } = sessionAt(TICK);
    const track = shipAt(sim, 'own', 'landed');
    track.serverRow.set([0, 10, 0], VELOCITY);
    track.picture.hasHeld = true;
    track.picture.heldPlace.set([metres, 0, 0]);
    const seen = { position: new Float64Array(3), attitude: Float64Array.of(0, 0, 0, 1) };
    fadeFromHeld(sim, track, seen);
    expect(track.picture.ease.active).toBe(isEased);
    expect(track.picture.ease.offset[0]).toBe(isEased ? metres : 0);
  });
});
