/** The pose of a sleeping ship on its turning body, by the formulas. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  NEUTRAL_CONTROLS,
  FUEL,
  IMPACT_SPEED,
  POSITION,
  type Quat,
  SHIP_STRIDE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  type Vec3,
  VELOCITY,
} from '../../../src/dynamics';
import { has, offsetOf } from '../../../src/prediction/simulation/rings/history';
import {
  holdSleeping,
  placeAsleep,
  sleepIfAtRest,
  sleepsOn,
  sleepsThrough,
  wake,
  wakeIfBurning,
  writeSleeping,
} from '../../../src/prediction/simulation/sleep';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { createTouchdownRing, logAt } from '../../../src/prediction/touchdown/touchdownRing';
import { cross, product, rotate, turnAbout, unit } from '../../dynamics/vectors';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
const TURN = turnAbout(unit([1, 2, 2]), 0.7);
const SPIN: Vec3 = [1e-3, -2e-3, 3e-3];

function asleep() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'landed');
  track.own = true;
  const bodies = new Float64Array(BODY_STRIDE);
  bodies.set(TURN, BODY_ATTITUDE);
  bodies.set(SPIN, BODY_ANGULAR_VELOCITY);
  expect(sleepIfAtRest(sim, track, bodies)).toBe(true);
  const commanded = sim.fleet.front.slice(track.at, track.at + SHIP_STRIDE);
  return { sim, track, bodies, commanded };
}

const vectorAt = (row: Float64Array, column: number) =>
  [...row.subarray(column, column + 3)] as unknown as Vec3;
const attitudeAt = (row: Float64Array) => [...row.subarray(ATTITUDE, ATTITUDE + 4)] as unknown as Quat;
function expectNear(actual: readonly number[], expected: readonly number[], digits = 5): void {
  for (const [k, x] of expected.entries()) expect(actual[k], `number ${k}`).toBeCloseTo(x, digits);
}

describe('a sleeping ship', () => {
  it('keeps the server’s pose, in the axes of its body', () => {
    const { track } = asleep();
    expectNear(rotate(TURN, vectorAt(track.sleepPlace, 0)), vectorAt(track.serverRow, POSITION));
    const attitude = [...track.sleepAttitude] as unknown as Quat;
    expectNear(product(TURN, attitude), attitudeAt(track.serverRow), 9);
  });

  it('turns and moves with its body, and no other column changes', () => {
    const { track } = asleep();
    const later = turnAbout(unit([1, -2, 2]), 1.3);
    const rows = new Float64Array(2 * SHIP_STRIDE).fill(7);
    writeSleeping(rows, SHIP_STRIDE, track, Float64Array.from(later), Float64Array.from(SPIN));
    const row = rows.subarray(SHIP_STRIDE);
    const place = rotate(later, vectorAt(track.sleepPlace, 0));
    expectNear(vectorAt(row, POSITION), place);
    expectNear(vectorAt(row, VELOCITY), cross(SPIN, place));
    expectNear(vectorAt(row, ANGULAR_VELOCITY), SPIN, 12);
    expectNear(attitudeAt(row), product(later, [...track.sleepAttitude] as unknown as Quat), 9);
    expect(rows.filter((x) => x === 7)).toHaveLength(2 * SHIP_STRIDE - 13);
  });

  it('is compared with the server’s state in that pose', () => {
    const { sim, track, bodies } = asleep();
    const place = { rows: new Float64Array(SHIP_STRIDE), at: 0, bodies: new Float64Array(0) };
    expect(placeAsleep(place, sim, track, { tick: TICK, bodies })).toBe(place);
    expect(place.bodies).toBe(bodies);
    expectNear(vectorAt(place.rows, POSITION), vectorAt(track.serverRow, POSITION));
    expect(place.rows[FUEL]).toBe(sim.fleet.front[track.at + FUEL]);
  });

  it('is not compared if an own input takes effect between the front and the compared tick', () => {
    const { sim, track, bodies } = asleep();
    sim.inputs.plan = [{ tick: TICK + 1, substep: 0, controls: NEUTRAL_CONTROLS }];
    const place = { rows: new Float64Array(SHIP_STRIDE), at: 0, bodies: new Float64Array(0) };
    const compared = (tick: number) => placeAsleep(place, sim, track, { tick, bodies }) !== null;
    expect([compared(TICK + 1), compared(TICK + 2)]).toEqual([true, false]);
    track.own = false;
    expect(compared(TICK + 2)).toBe(true);
  });

  it('stays asleep at a new server state: another pilot’s ship takes its row, the player’s only its pose', () => {
    for (const own of [true, false]) {
      const { sim, track, bodies } = asleep();
      track.own = own;
      track.serverRow[IMPACT_SPEED] = 9;
      track.serverRow[POSITION]! += 5;
      expect(sleepsOn(sim, track, bodies)).toBe(true);
      expectNear(rotate(TURN, vectorAt(track.sleepPlace, 0)), vectorAt(track.serverRow, POSITION));
      expect(sim.fleet.front[track.at + IMPACT_SPEED] === 9).toBe(!own);
    }
    const { sim, track, bodies } = asleep();
    track.mode = 'stepping';
    track.serverRow[POSITION]! += 5;
    expect(sleepsOn(sim, track, bodies)).toBe(false);
    expect(
      Math.abs(rotate(TURN, vectorAt(track.sleepPlace, 0))[0] - track.serverRow[POSITION]!),
    ).toBeGreaterThan(4);
  });

  it('sleeps through a state without thrust, but not through one with thrust', () => {
    const { track } = asleep();
    const burning = track.serverRow.slice();
    burning[THRUST_LEVEL] = 1;
    expect([sleepsThrough(track, track.serverRow), sleepsThrough(track, burning)]).toEqual([true, false]);
    track.mode = 'stepping';
    expect(sleepsThrough(track, track.serverRow)).toBe(false);
  });

  it('holds its pose until its replay', () => {
    const { track } = asleep();
    holdSleeping(track);
    expect([track.mode, track.picture.hasHeld]).toEqual(['waiting', true]);
    expect([...track.picture.heldPlace]).toEqual([...track.sleepPlace]);
    expect([...track.picture.heldAttitude]).toEqual([...track.sleepAttitude]);
    const stepping = asleep().track;
    stepping.mode = 'stepping';
    holdSleeping(stepping);
    expect([stepping.mode, stepping.picture.hasHeld]).toEqual(['stepping', false]);
  });
});

describe('a sleeping ship wakes', () => {
  it.each([
    [THRUST_LEVEL, 0.1],
    [TRANSLATION_INPUT, -0.1],
    [TRANSLATION_INPUT + 1, 0.1],
    [TRANSLATION_INPUT + 2, 0.1],
  ])('when column %i is %f, if it has fuel', (column, set) => {
    const { sim, track, commanded } = asleep();
    expect(wakeIfBurning(sim, track, commanded)).toBe(false);
    commanded[column] = set;
    expect([wakeIfBurning(sim, track, commanded), track.mode]).toEqual([true, 'stepping']);
    expect(wakeIfBurning(sim, track, commanded)).toBe(false);
    const empty = asleep();
    empty.commanded[column] = set;
    empty.commanded[FUEL] = 0;
    expect([wakeIfBurning(empty.sim, empty.track, empty.commanded), empty.track.mode]).toEqual([
      false,
      'sleeping',
    ]);
  });

  it('with history and log since the server’s state, in the pose of each tick', () => {
    const { sim, track } = asleep();
    track.log = createTouchdownRing(track.history.length);
    track.log.front[0] = 1;
    Object.assign(sim.front, { tick: TICK + 3, substep: 4 });
    wake(sim, track);
    for (const tick of [TICK, TICK + 1, TICK + 3]) {
      const at = offsetOf(track.history, tick);
      const row = track.history.rows.subarray(at, at + SHIP_STRIDE);
      const bodies = boundaryAt(sim.bodies, sim.timeline, tick);
      const turn = [...bodies.subarray(BODY_ATTITUDE, BODY_ATTITUDE + 4)] as unknown as Quat;
      const place = rotate(turn, vectorAt(track.sleepPlace, 0));
      expectNear(vectorAt(row, POSITION), place);
      const spin = [...bodies.subarray(BODY_ANGULAR_VELOCITY, BODY_ANGULAR_VELOCITY + 3)] as unknown as Vec3;
      expectNear(vectorAt(row, VELOCITY), cross(spin, place));
      expect(logAt(track.log, tick)![0]).toBe(1);
    }
    expect(has(track.history, TICK + 4)).toBe(false);
    // A substep of turning lies between its last two rows.
    const { front, previous } = sim.fleet;
    const moved = vectorAt(front, track.at + POSITION).map((x, k) => x - previous[track.at + POSITION + k]!);
    const velocity = vectorAt(front, track.at + VELOCITY);
    expectNear(
      moved,
      velocity.map((x) => x * 0.01),
      4,
    );
    expect(Math.hypot(...moved)).toBeGreaterThan(1e-3);
    expect(previous[track.at + FUEL]).toBe(front[track.at + FUEL]);
  });

  it('with no more history than the ring holds', () => {
    const { sim, track } = asleep();
    const { length } = track.history;
    sim.front.tick = TICK + length + 5;
    wake(sim, track);
    const first = sim.front.tick - length + 1;
    expect([has(track.history, first), has(track.history, first - 1), has(track.history, first + 1)]).toEqual(
      [expect.any(Boolean), false, true],
    );
  });
});
