/** A ship without the dynamics: its motion by the formulas of free fall and of a place on a turning ball. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  CONTACT,
  CRASHED,
  FLYING,
  POSITION,
  type Quat,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
  type World,
} from '../../../src/dynamics';
import { extrapolateRow } from '../../../src/prediction/simulation/extrapolate';
import { cross, dot, lengthOf, plus, product, rotate, times, turnAbout, unit } from '../../dynamics/vectors';

const RADIUS = 200_000;
const GRAVITY = 1.5;
const UP = unit([2, -3, 6]);
const EAST = unit(cross(UP, [1, 2, 2]));
const PLACE = times(UP, RADIUS);
const SPIN: Vec3 = [3e-4, 5e-4, -2e-4];
const AXIS = unit([1, -2, 2]);
const ATTITUDE_THERE: Quat = turnAbout(unit([3, 1, -2]), 0.7);

interface Given {
  readonly velocity: Vec3;
  readonly state?: number;
  readonly crashed?: number;
}

/** The second ship of two, on the second body of two; `steps` of `dt` s later. */
function extrapolated({ velocity, state = FLYING, crashed = 0 }: Given, steps: number, dt: number) {
  const bodies = new Float64Array(2 * BODY_STRIDE);
  bodies.set(SPIN, BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  const world = {
    bodies: [{ gravityParameter: 0 }, { gravityParameter: GRAVITY * RADIUS ** 2 }],
  } as unknown as World;
  const rows = new Float64Array(2 * SHIP_STRIDE);
  const at = SHIP_STRIDE;
  rows.set(PLACE, at + POSITION);
  rows.set(velocity, at + VELOCITY);
  rows.set(ATTITUDE_THERE, at + ATTITUDE);
  rows.set(times(AXIS, 0.2), at + ANGULAR_VELOCITY);
  rows[at + REFERENCE_BODY] = 1;
  rows[at + SURFACE_STATE] = state;
  rows[at + CRASHED] = crashed;
  for (let i = 0; i < steps; i++) extrapolateRow(rows, at, bodies, world, dt);
  const three = (column: number) => [...rows.subarray(at + column, at + column + 3)] as unknown as Vec3;
  expect(rows.subarray(0, SHIP_STRIDE).every((value) => value === 0)).toBe(true);
  return {
    place: three(POSITION),
    velocity: three(VELOCITY),
    spin: three(ANGULAR_VELOCITY),
    attitude: [...rows.subarray(at + ATTITUDE, at + ATTITUDE + 4)] as unknown as Quat,
    state: rows[at + SURFACE_STATE],
  };
}

const apart = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((x, k) => x - b[k]!));

describe('a ship that is extrapolated in flight', () => {
  it('falls: after a quarter of a circular orbit its velocity points down', () => {
    const speed = Math.sqrt(GRAVITY * RADIUS);
    const quarter = (Math.PI * RADIUS) / (2 * speed);
    const steps = 2000;
    const { place, velocity, state } = extrapolated({ velocity: times(EAST, speed) }, steps, quarter / steps);
    expect(apart(place, times(EAST, RADIUS)) / RADIUS).toBeLessThan(2e-3);
    expect(apart(velocity, times(UP, -speed)) / speed).toBeLessThan(2e-3);
    expect(state).toBe(FLYING);
  });

  it('falls by g t² / 2 from rest', () => {
    const { place, velocity } = extrapolated({ velocity: [0, 0, 0] }, 100, 0.01);
    expect(apart(place, times(UP, RADIUS - GRAVITY / 2))).toBeLessThan(1e-4);
    expect(apart(velocity, times(UP, -GRAVITY))).toBeLessThan(1e-4);
  });

  it('turns at its spin', () => {
    const { attitude, spin } = extrapolated({ velocity: [0, 0, 0] }, 100, 0.01);
    expect(apart(attitude, product(turnAbout(AXIS, 0.2), ATTITUDE_THERE))).toBeLessThan(1e-12);
    expect(spin).toEqual(times(AXIS, 0.2));
  });
});

describe('a ship that is extrapolated on the ground', () => {
  const ground = cross(SPIN, PLACE);
  const moving = (east: number, up: number, seconds = 10) =>
    extrapolated(
      { velocity: plus(ground, plus(times(EAST, east), UP, up)), state: CONTACT },
      seconds * 100,
      0.01,
    );

  it('moves with the turning ground while it is upright', () => {
    const { place, velocity, state } = moving(0, 0);
    const rate = lengthOf(SPIN);
    const there = rotate(turnAbout(unit(SPIN), rate * 10), PLACE);
    // 10 s in steps of 10 ms along the tangent: off by (w dt) of the way.
    expect(apart(place, there)).toBeLessThan(rate * 0.01 * lengthOf(ground) * 10);
    expect(apart(velocity, cross(SPIN, place))).toBeLessThan(1e-9);
    expect(state).toBe(CONTACT);
  });

  it('keeps its velocity relative to the ground while it slides', () => {
    const { velocity, place } = moving(5, 0, 1);
    expect(apart(plus(velocity, cross(SPIN, place), -1), times(EAST, 5))).toBeLessThan(1e-6);
    expect(apart(place, moving(0, 0, 1).place)).toBeCloseTo(5, 2);
  });

  it.each([
    ['keeps a descent of 29 %', -1.45, -1.45],
    ['loses one of 31 %, an impact', -1.55, 0],
    ['keeps a climb of 31 %', 1.55, 1.55],
  ])('%s', (_, up, left) => {
    const { velocity, place } = moving(5, up, 0.01);
    const relative = plus(velocity, cross(SPIN, place), -1);
    expect(dot(relative, UP)).toBeCloseTo(left, 6);
    expect(dot(relative, EAST)).toBeCloseTo(5, 6);
  });
});

it('a wreck does not move', () => {
  const { place, attitude } = extrapolated({ velocity: times(EAST, 5), crashed: 1 }, 100, 0.01);
  expect([place, attitude]).toEqual([PLACE, ATTITUDE_THERE]);
});
