import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  CRASHED,
  FLYING,
  NO_EVENT,
  POSITION,
  REFERENCE_BODY,
  substep,
  SURFACE_STATE,
  VELOCITY,
  type World,
} from '../../dynamics';
import {
  add,
  compose,
  cross,
  dot,
  fromRotationVector,
  lengthOf,
  put,
  quaternion,
  take,
  vector,
} from '../drawn/rotation';
import type { Simulation } from './simulation';
import type { Track } from './track';
import type { RowStep } from './rowStep';

/** Extrapolates a ship by a substep or, above unknown ground, flies it by the dynamics. */
export function extrapolate(step: RowStep, sim: Simulation, track: Track): void {
  const { rows, at } = step;
  const [dt] = step.dt;
  step.event = NO_EVENT;
  if (track.fit.extrapolated === 'ground' && rows[at + SURFACE_STATE] === FLYING)
    substep(rows, at, step.bodies, sim.groundless, dt);
  else extrapolateRow(rows, at, step.bodies, sim.world, dt);
}

/**
 * Extrapolates a ship's motion like a client without the dynamics: in flight it falls without thrust; on the ground it keeps moving along
 * it and turns with the body. Its surface state and its spin stay.
 * @param bodies rows turned for the next `dt` game s
 */
export function extrapolateRow(
  rows: Float64Array,
  at: number,
  bodies: Float64Array,
  world: World,
  dt: number,
): void {
  if (rows[at + CRASHED] === 1) return;
  const index = rows[at + REFERENCE_BODY]!;
  take(place, rows, at + POSITION);
  take(velocity, rows, at + VELOCITY);
  take(spin, bodies, index * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  const { gravityParameter } = world.bodies[index]!;
  if (rows[at + SURFACE_STATE] === FLYING) fall(gravityParameter, dt);
  else slideAlong(dt);
  put(rows, at + POSITION, place);
  put(rows, at + VELOCITY, velocity);
  turn.fill(0);
  take(spin, rows, at + ANGULAR_VELOCITY);
  add(turn, spin, dt);
  fromRotationVector(turned, turn);
  take(attitude, rows, at + ATTITUDE);
  compose(attitude, turned, attitude);
  put(rows, at + ATTITUDE, attitude);
}

/** Velocity Verlet, like flight in the dynamics. */
function fall(gravityParameter: number, dt: number): void {
  const before = pull(gravityParameter);
  add(place, place, 0.5 * before * dt * dt);
  add(place, velocity, dt);
  // The direction of gravity turns by no more than dt · speed / radius.
  add(velocity, place, 0.5 * (before + pull(gravityParameter)) * dt);
}

/** Acceleration over position, 1/s². */
function pull(gravityParameter: number): number {
  const distance = lengthOf(place);
  return -gravityParameter / (distance * distance * distance);
}

/** Moves at constant velocity relative to the turning ground; a descent steeper than MAX_SLOPE is removed. */
function slideAlong(dt: number): void {
  cross(ground, spin, place);
  add(velocity, ground, -1);
  const distance = lengthOf(place);
  const climb = dot(velocity, place) / distance;
  const speed = Math.sqrt(Math.max(0, dot(velocity, velocity) - climb * climb));
  if (climb < -MAX_SLOPE * speed) add(velocity, place, -climb / distance);
  add(place, velocity, dt);
  add(place, ground, dt);
  cross(ground, spin, place);
  add(velocity, ground, 1);
}

/** m/m. Steeper descents are impacts, not slopes. */
const MAX_SLOPE = 0.3;

const place = vector();
const velocity = vector();
const spin = vector();
const ground = vector();
const turn = vector();
const turned = quaternion();
const attitude = quaternion();
