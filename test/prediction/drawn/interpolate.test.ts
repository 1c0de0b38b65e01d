/** A ship between two of its server states, by the formulas: in the axes of its body, which are those of ICRF here. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CONTACT,
  FLYING,
  POSITION,
  SHIP_STRIDE,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
} from '../../../src/dynamics';
import { rowOfPolicy, rowToIcrf } from '../../../src/prediction/drawn/interpolate';
import type { TurnedBodies } from '../../../src/prediction/drawn/viewContext';
import { setTempo } from '../../../src/prediction/time/timeline';
import { cross, plus, product, rotate, turnAbout, unit } from '../../dynamics/vectors';
import { RATE, sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
const AXIS = unit([2, -3, 6]);
/** Two states, 4 ticks = 0.4 s apart. */
const FROM = { position: [10, 20, 30], velocity: [5, -2, 1], spin: [0.1, 0.2, 0.3], angle: 0.2 } as const;
const TO = { position: [12, 19, 31], velocity: [6, -3, 2], spin: [0.3, 0.2, -0.1], angle: 0.8 } as const;

function rowOf({ position, velocity, spin, angle }: typeof FROM | typeof TO, state: number): Float64Array {
  const row = new Float64Array(SHIP_STRIDE);
  row.set(position, POSITION);
  row.set(velocity, VELOCITY);
  row.set(spin, ANGULAR_VELOCITY);
  row.set(turnAbout(AXIS, angle), ATTITUDE);
  row[SURFACE_STATE] = state;
  return row;
}

/** The row drawn `seconds` after the first state; `states` are the surface states of the two. */
function drawnAt(
  seconds: number,
  { states = [FLYING, FLYING], timeScale = 1, ticks = [TICK, TICK + 4] } = {},
) {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  track.policy = 'interpolate';
  setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale, paused: false }, 0);
  track.states = { ticks: [...ticks], rows: [rowOf(FROM, states[0]!), rowOf(TO, states[1]!)] };
  const turned: TurnedBodies = {
    bodyAttitudes: [Float64Array.of(0, 0, 0, 1)],
    bodySpins: [new Float64Array(3)],
    playback: { timeline: sim.timeline, at: seconds, timeScale },
  };
  const row = rowOfPolicy(sim, track, turned);
  const part = (column: number, count = 3) => [...row.subarray(column, column + count)];
  return {
    position: part(POSITION),
    velocity: part(VELOCITY),
    spin: part(ANGULAR_VELOCITY),
    attitude: part(ATTITUDE, 4),
    held: [...track.picture.heldPlace],
    state: row[SURFACE_STATE],
  };
}

function expectNear(actual: readonly number[], expected: readonly number[], digits = 9): void {
  for (const [k, x] of expected.entries()) expect(actual[k], `number ${k}`).toBeCloseTo(x, digits);
}
const between = (a: readonly number[], b: readonly number[], share: number) =>
  a.map((x, k) => x + (b[k]! - x) * share);

describe('an interpolated ship', () => {
  it('has velocity, spin and attitude in proportion to time', () => {
    for (const share of [0.25, 0.5, 0.9]) {
      const drawn = drawnAt(0.4 * share);
      expectNear(drawn.velocity, between(FROM.velocity, TO.velocity, share));
      expectNear(drawn.spin, between(FROM.spin, TO.spin, share));
      expectNear(drawn.attitude, turnAbout(AXIS, 0.2 + 0.6 * share));
      expectNear(drawn.held, drawn.position);
    }
  });

  it('follows the cubic through both positions and velocities', () => {
    const step = 1e-5;
    // At its ends it is there, at that velocity.
    expectNear(drawnAt(0).position, FROM.position);
    expectNear(drawnAt(0.4).position, TO.position);
    const speedAt = (seconds: number) => {
      const [before, after] = [drawnAt(seconds).position, drawnAt(seconds + step).position];
      return after.map((x, k) => (x - before[k]!) / step);
    };
    expectNear(speedAt(0), FROM.velocity, 2);
    expectNear(speedAt(0.4 - step), TO.velocity, 2);
    // In the middle by Hermite: the mean, and an eighth of the interval times the difference of the velocities.
    const middle = between(FROM.position, TO.position, 0.5);
    expectNear(
      drawnAt(0.2).position,
      middle.map((x, k) => x + (0.4 / 8) * (FROM.velocity[k]! - TO.velocity[k]!)),
    );
    // In twice the game time.
    expectNear(
      drawnAt(0.2, { timeScale: 2 }).position,
      middle.map((x, k) => x + (0.8 / 8) * (FROM.velocity[k]! - TO.velocity[k]!)),
    );
  });

  it.each([
    [CONTACT, FLYING],
    [FLYING, CONTACT],
    [CONTACT, CONTACT],
  ])('moves straight from surface state %i to %i', (from, to) => {
    const drawn = drawnAt(0.1, { states: [from, to] });
    expectNear(drawn.position, between(FROM.position, TO.position, 0.25));
    expect(drawn.state).toBe(from);
  });

  it('stays in the first state before it, and in the last after it', () => {
    expectNear(drawnAt(-1).position, FROM.position);
    const last = drawnAt(9);
    expectNear(last.position, TO.position);
    expectNear(last.velocity, TO.velocity);
    expectNear(last.attitude, turnAbout(AXIS, 0.8));
  });

  it('takes the later of two states at one instant', () => {
    expectNear(drawnAt(0, { ticks: [TICK, TICK] }).position, TO.position);
  });
});

describe('a row in a body’s axes', () => {
  it('is turned with the body, whose ground moves', () => {
    const turn = turnAbout(unit([1, 2, 2]), 0.7);
    const spin: Vec3 = [0.01, -0.02, 0.03];
    const row = rowOf(FROM, FLYING);
    rowToIcrf(row, Float64Array.from(turn), Float64Array.from(spin));
    const position = rotate(turn, [...FROM.position]);
    expectNear([...row.subarray(POSITION, POSITION + 3)], position);
    const velocity = plus(rotate(turn, [...FROM.velocity]), cross(spin, position));
    expectNear([...row.subarray(VELOCITY, VELOCITY + 3)], velocity);
    expectNear([...row.subarray(ANGULAR_VELOCITY, ANGULAR_VELOCITY + 3)], rotate(turn, [...FROM.spin]));
    expectNear([...row.subarray(ATTITUDE, ATTITUDE + 4)], product(turn, turnAbout(AXIS, 0.2)));
  });
});
