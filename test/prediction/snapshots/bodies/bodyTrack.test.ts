import { describe, expect, it } from 'vitest';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  type BodyMotion,
  type Quat,
} from '../../../../src/dynamics';
import {
  boundaryAt,
  createBodyTrack,
  forgetAfter,
  keptTicks,
  knowsBoundary,
  resizedBodies,
  rowsAt,
  startBodiesAt,
} from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { updateBodies } from '../../../../src/prediction/snapshots/bodies/updateBodies';
import { createTimeline, setTempo } from '../../../../src/prediction/time/timeline';
import { angleBetween, product, times, turnAbout, unit } from '../../../dynamics/vectors';

const RATE = 10;
const SUBSTEPS = 10;
const TICK = 100;
const AXIS = unit([2, -3, 6]);
/** rad/s */
const TURNING = 1e-5;
const TURN = turnAbout(unit([1, 2, 2]), 0.7);
const PLACE = [1e6, -2e6, 3e6] as const;
const SPEED = [1000, 2000, -500] as const;

/** The body `seconds` after TICK, by the formulas. */
const at = (seconds: number): BodyMotion =>
  ({
    position: PLACE.map((x, k) => x + SPEED[k]! * seconds),
    velocity: SPEED,
    attitude: product(turnAbout(AXIS, TURNING * seconds), TURN),
    angularVelocity: times(AXIS, TURNING),
  }) as unknown as BodyMotion;

function tracked(length = 16) {
  const start = new Float64Array(BODY_STRIDE);
  const { position, velocity, attitude, angularVelocity } = at(0);
  start.set(position, BODY_POSITION);
  start.set(velocity, BODY_VELOCITY);
  start.set(attitude, BODY_ATTITUDE);
  start.set(angularVelocity, BODY_ANGULAR_VELOCITY);
  const timeline = createTimeline(0.01);
  setTempo(timeline, TICK, { tickRate: RATE, timeScale: 1, paused: false }, 0);
  const track = createBodyTrack(start, length, SUBSTEPS);
  updateBodies(track, TICK, [at(0)]);
  return { track, timeline, start };
}

/** Whether rows are those of the body `seconds` after TICK. */
function expectAt(rows: Float64Array, seconds: number): void {
  const { position, attitude } = at(seconds);
  for (const [k, x] of position.entries()) expect(rows[BODY_POSITION + k]).toBeCloseTo(x, 5);
  const turned = [...rows.subarray(BODY_ATTITUDE, BODY_ATTITUDE + 4)] as unknown as Quat;
  expect(angleBetween(turned, attitude)).toBeLessThan(1e-9);
}

describe('the bodies at a tick', () => {
  it.each([0, 1, 5, 15])('%i after the last one sent have moved and turned since', (ticks) => {
    const { track, timeline } = tracked();
    expectAt(boundaryAt(track, timeline, TICK + ticks), ticks / RATE);
    expect(knowsBoundary(track, TICK + ticks)).toBe(true);
  });

  it.each([16, 17, 40, 1000])('%i after it, beyond the ring, have moved and turned too', (ticks) => {
    const { track, timeline } = tracked();
    expectAt(boundaryAt(track, timeline, TICK + ticks), ticks / RATE);
  });

  it('before the ring are computed backwards, and not stored', () => {
    const { track, timeline } = tracked();
    boundaryAt(track, timeline, TICK + 40);
    expectAt(boundaryAt(track, timeline, TICK + 2), 0.2);
    expect(knowsBoundary(track, TICK + 2)).toBe(false);
    expectAt(boundaryAt(track, timeline, TICK + 40), 4);
  });

  it('are those of the given start', () => {
    const { track, timeline, start } = tracked();
    startBodiesAt(track, TICK + 3);
    expect([...boundaryAt(track, timeline, TICK + 3)]).toEqual([...start]);
    expect([...track.ticks].filter((tick) => tick >= 0)).toEqual([TICK + 3]);
  });
});

describe('the bodies in a substep', () => {
  it('have turned to its end', () => {
    const { track, timeline } = tracked();
    for (const substep of [3, 0, 9]) {
      const rows = rowsAt(track, timeline, TICK + 1, substep);
      expect(rowsAt(track, timeline, TICK + 1, substep)).toBe(rows);
      // Their places are those of the tick.
      for (let k = 0; k < 3; k++)
        expect(rows[BODY_POSITION + k]).toBeCloseTo(PLACE[k]! + SPEED[k]! / RATE, 5);
    }
  });

  it('are computed again if the tick before was sent differently', () => {
    const { track, timeline } = tracked();
    const before = rowsAt(track, timeline, TICK + 1, 4)[BODY_POSITION];
    updateBodies(track, TICK, [at(5)]);
    expect(rowsAt(track, timeline, TICK + 1, 4)[BODY_POSITION]! - before!).toBeCloseTo(SPEED[0] * 5, 5);
  });

  it('are kept for as many ticks as memory allows', () => {
    expect([1, 64, 65, 100, 1000, 1366, 12_800].map(keptTicks)).toEqual([64, 64, 63, 40, 4, 3, 3]);
  });
});

describe('bodies that are sent', () => {
  it('as predicted change nothing', () => {
    const { track, timeline } = tracked();
    const rows = boundaryAt(track, timeline, TICK + 2);
    const part = (column: number, count: number) => [...rows.subarray(column, column + count)];
    boundaryAt(track, timeline, TICK + 5);
    const motion = {
      position: part(BODY_POSITION, 3),
      velocity: part(BODY_VELOCITY, 3),
      attitude: part(BODY_ATTITUDE, 4),
      angularVelocity: part(BODY_ANGULAR_VELOCITY, 3),
    } as unknown as BodyMotion;
    expect(updateBodies(track, TICK + 2, [motion])).toEqual({ attitude: 0, spin: 0 });
    expect(knowsBoundary(track, TICK + 5)).toBe(true);
    expect([...track.replaced]).toEqual([...rows]);
    for (const field of ['position', 'velocity', 'attitude', 'angularVelocity'] as const) {
      const other = tracked();
      boundaryAt(other.track, other.timeline, TICK + 5);
      const changed = { ...motion, [field]: motion[field].map((x, k) => (k === 2 ? x + 1e-6 : x)) };
      updateBodies(other.track, TICK + 2, [changed]);
      expect(knowsBoundary(other.track, TICK + 5), field).toBe(false);
    }
  });

  it('differently are reported with the largest error of attitude and spin, and later ones computed again', () => {
    const { track, timeline } = tracked();
    const before = [...boundaryAt(track, timeline, TICK + 2)];
    boundaryAt(track, timeline, TICK + 5);
    const sent = at(0.2);
    const motion = {
      ...sent,
      attitude: sent.attitude.map((x, k) => x + [0, -1e-3, 0, 2e-3][k]!),
      angularVelocity: sent.angularVelocity.map((x, k) => x + [1e-4, 0, -3e-4][k]!),
    } as unknown as BodyMotion;
    const error = updateBodies(track, TICK + 2, [motion]);
    expect(error.attitude).toBeCloseTo(2e-3, 6);
    expect(error.spin).toBeCloseTo(3e-4, 9);
    expect([...track.replaced]).toEqual(before);
    expect([TICK, TICK + 2, TICK + 5].map((tick) => knowsBoundary(track, tick))).toEqual([true, true, false]);
  });

  it('of a tick that was not predicted have no error', () => {
    const { track } = tracked();
    expect(updateBodies(track, TICK + 9, [at(9)])).toEqual({ attitude: 0, spin: 0 });
    expectAt(track.replaced, 9);
  });
});

describe('a ring', () => {
  it('forgets what is after a tick', () => {
    const { track, timeline } = tracked();
    boundaryAt(track, timeline, TICK + 5);
    forgetAfter(track, TICK + 3);
    expect([3, 4, 5].map((ticks) => knowsBoundary(track, TICK + ticks))).toEqual([true, false, false]);
  });

  it.each([
    [32, [0, 1, 2, 3, 4, 5]],
    [4, [2, 3, 4, 5]],
  ])('of %i keeps the newest', (length, ticks) => {
    const { track, timeline } = tracked();
    boundaryAt(track, timeline, TICK + 5);
    track.replaced[0] = 7;
    const next = resizedBodies(track, length, SUBSTEPS);
    expect([next.length, next.count, next.replaced[0], next.start]).toEqual([length, 1, 7, track.start]);
    expect([0, 1, 2, 3, 4, 5].filter((ago) => knowsBoundary(next, TICK + ago))).toEqual(ticks);
    for (const ago of ticks) expectAt(boundaryAt(next, timeline, TICK + ago), ago / RATE);
  });
});
