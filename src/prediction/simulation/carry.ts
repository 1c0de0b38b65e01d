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
import { compose, cross, dot, fromRotationVector, quaternion, take, vector } from '../drawn/rotation';
import type { Simulation } from './simulation';
import type { RowStep, Track } from './track';

/** Extrapolates a ship by a substep or, above unknown ground, flies it by the dynamics. */
export function carry(step: RowStep, sim: Simulation, track: Track): void {
  const { rows, at } = step;
  const [dt] = step.dt;
  step.event = NO_EVENT;
  if (track.fit.carried === 'ground' && rows[at + SURFACE_STATE] === FLYING)
    substep(rows, at, step.bodies, sim.groundless, dt);
  else carryRow(rows, at, step.bodies, sim.world, dt);
}

/**
 * Extrapolates a ship's motion like a client without the dynamics: in flight it falls without thrust; on the ground it keeps moving along
 * it and turns with the body. Its surface state and its spin stay.
 * @param bodies rows turned for the next `dt` game s
 */
export function carryRow(
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
  for (let k = 0; k < 3; k++) {
    rows[at + POSITION + k] = place[k]!;
    rows[at + VELOCITY + k] = velocity[k]!;
  }
  for (let k = 0; k < 3; k++) turn[k] = rows[at + ANGULAR_VELOCITY + k]! * dt;
  fromRotationVector(turned, turn);
  take(attitude, rows, at + ATTITUDE);
  compose(attitude, turned, attitude);
  for (let k = 0; k < 4; k++) rows[at + ATTITUDE + k] = attitude[k]!;
}

/** Velocity Verlet, like flight in the dynamics. */
function fall(gravityParameter: number, dt: number): void {
  const before = pull(gravityParameter);
  for (let k = 0; k < 3; k++) place[k] = place[k]! + velocity[k]! * dt + 0.5 * before * place[k]! * dt * dt;
  // The direction of gravity turns by no more than dt · speed / radius.
  const after = pull(gravityParameter);
  for (let k = 0; k < 3; k++) velocity[k] = velocity[k]! + 0.5 * (before + after) * place[k]! * dt;
}

/** Acceleration over position, 1/s². */
function pull(gravityParameter: number): number {
  const squared = place[0]! * place[0]! + place[1]! * place[1]! + place[2]! * place[2]!;
  return -gravityParameter / (squared * Math.sqrt(squared));
}

/** Moves at constant velocity relative to the turning ground; a descent steeper than MAX_SLOPE is removed. */
function slideAlong(dt: number): void {
  cross(ground, spin, place);
  const distance = Math.hypot(place[0]!, place[1]!, place[2]!);
  let climb = 0;
  for (let k = 0; k < 3; k++) {
    velocity[k] = velocity[k]! - ground[k]!;
    climb += (velocity[k]! * place[k]!) / distance;
  }
  const speed = Math.sqrt(Math.max(0, dot(velocity, velocity) - climb * climb));
  if (climb < -MAX_SLOPE * speed)
    for (let k = 0; k < 3; k++) velocity[k] = velocity[k]! - (climb * place[k]!) / distance;
  for (let k = 0; k < 3; k++) place[k] = place[k]! + (velocity[k]! + ground[k]!) * dt;
  cross(ground, spin, place);
  for (let k = 0; k < 3; k++) velocity[k] = velocity[k]! + ground[k]!;
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
