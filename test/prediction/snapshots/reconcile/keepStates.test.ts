import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  POSITION,
  type Quat,
  REFERENCE_BODY,
  SHIP_STRIDE,
  type Vec3,
  VELOCITY,
} from '../../../../src/dynamics';
import { createBodyTrack } from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { keepServerState } from '../../../../src/prediction/snapshots/reconcile/keepStates';
import { conjugate, cross, plus, product, rotate, turnAbout, unit } from '../../../dynamics/vectors';
import { sessionAt, shipAt } from '../../decisions/sessionAt';

const TICK = 100;
/** Two bodies, turned and turning. */
const BODIES = [
  { place: [0, 0, 0], speed: [0, 0, 0], spin: [1e-4, 2e-4, -3e-4], turn: turnAbout(unit([1, 2, 2]), 0.7) },
  {
    place: [4e5, -3e5, 2e5],
    speed: [900, -300, 50],
    spin: [-2e-4, 0, 1e-4],
    turn: turnAbout(unit([2, -1, 2]), -1.1),
  },
] as const satisfies readonly { place: Vec3; speed: Vec3; spin: Vec3; turn: Quat }[];

const rows = new Float64Array(2 * BODY_STRIDE);
for (const [i, { place, speed, spin, turn }] of BODIES.entries()) {
  rows.set(place, i * BODY_STRIDE + BODY_POSITION);
  rows.set(speed, i * BODY_STRIDE + BODY_VELOCITY);
  rows.set(spin, i * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  rows.set(turn, i * BODY_STRIDE + BODY_ATTITUDE);
}

const STATE = {
  position: [3e5, -2e5, 1e5] as Vec3,
  velocity: [40, -70, 20] as Vec3,
  spin: [0.1, -0.2, 0.05] as Vec3,
  attitude: turnAbout(unit([6, 2, -3]), 0.4),
};

/** A state relative to body `body`, ICRF axes. */
function stateOf(body: number, { position, velocity, spin, attitude } = STATE): Float64Array {
  const row = new Float64Array(SHIP_STRIDE);
  row.set(position, POSITION);
  row.set(velocity, VELOCITY);
  row.set(spin, ANGULAR_VELOCITY);
  row.set(attitude, ATTITUDE);
  row[REFERENCE_BODY] = body;
  return row;
}

function keeping() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  sim.bodies = createBodyTrack(rows, 64, 10);
  const know = (tick: number) => {
    sim.bodies.boundaries[tick % 64]!.set(rows);
    sim.bodies.ticks[tick % 64] = tick;
  };
  const keep = (tick: number, row: Float64Array) => {
    know(tick);
    keepServerState(sim, track, row, { tick, bodies: rows });
    return track.states!;
  };
  return { sim, keep };
}

/** What of the state `seen` from body `body` is in its turning axes, by the formulas. */
function relativeRotation(body: number, { position, velocity, spin, attitude } = STATE) {
  const { spin: turning, turn } = BODIES[body]!;
  const back = conjugate(turn);
  return [
    ...rotate(back, position),
    ...rotate(back, plus(velocity, cross(turning, position), -1)),
    ...rotate(back, spin),
    ...product(back, attitude),
  ];
}
const kept = (row: Float64Array) =>
  [POSITION, VELOCITY, ANGULAR_VELOCITY, ATTITUDE].flatMap((column) => [
    ...row.subarray(column, column + (column === ATTITUDE ? 4 : 3)),
  ]);

function expectNear(actual: readonly number[], expected: readonly number[]): void {
  for (const [i, x] of expected.entries()) expect(actual[i], `number ${i}`).toBeCloseTo(x, 6);
}

describe('the states kept for interpolation', () => {
  it('are in the axes of the turning body, relative to it', () => {
    for (const body of [0, 1]) {
      const { keep } = keeping();
      const states = keep(TICK, stateOf(body));
      expectNear(kept(states.rows[0]!), relativeRotation(body));
    }
  });

  it('are the newest eight', () => {
    const { keep } = keeping();
    for (let tick = TICK; tick < TICK + 9; tick++) keep(tick, stateOf(0));
    const states = keep(TICK + 9, stateOf(0));
    expect(states.ticks).toEqual([102, 103, 104, 105, 106, 107, 108, 109]);
    expect(new Set(states.rows).size).toBe(8);
  });

  it('are converted to the body of the newest', () => {
    const { keep } = keeping();
    keep(TICK, stateOf(0));
    const states = keep(TICK + 1, stateOf(1));
    const [from, to] = BODIES;
    const moved = {
      ...STATE,
      position: plus(STATE.position, plus(from.place, to.place, -1)),
      velocity: plus(STATE.velocity, plus(from.speed, to.speed, -1)),
    };
    expect(states.rows.map((row) => row[REFERENCE_BODY])).toEqual([1, 1]);
    expectNear(kept(states.rows[0]!), relativeRotation(1, moved));
    expectNear(kept(states.rows[1]!), relativeRotation(1));
  });

  it('are dropped at a change of body if the bodies of their tick are no longer known', () => {
    for (const [body, ticks] of [
      [0, [TICK, TICK + 1, TICK + 2]],
      [1, [TICK + 1, TICK + 2]],
    ] as const) {
      const { sim, keep } = keeping();
      keep(TICK, stateOf(0));
      keep(TICK + 1, stateOf(0));
      sim.bodies.ticks[TICK % 64] = -1;
      const states = keep(TICK + 2, stateOf(body));
      expect([states.ticks, states.rows.length]).toEqual([ticks, ticks.length]);
    }
    const { sim, keep } = keeping();
    keep(TICK, stateOf(0));
    sim.bodies.ticks.fill(-1);
    expect(keep(TICK + 1, stateOf(1)).ticks).toEqual([TICK + 1]);
  });
});
