import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  CRASHED,
  FLYING,
  GROUND_CONTACT_OFFSET,
  POSITION,
  REFERENCE_BODY,
  SURFACE_STATE,
  VELOCITY,
  type World,
} from '../../dynamics';
import { cross, quaternion, rotateBack, take, vector } from '../drawn/rotation';

/** A server state relative to the ground at or below it. */
export interface Observation {
  /** Radial direction, and direction of motion along the ground: unit, in the body's axes. */
  readonly direction: Float64Array;
  readonly way: Float64Array;
  /** Height of an upright ship's feet above our terrain, m. */
  feet: number;
  /** m/s, relative to the turning ground: away from it and along it. */
  climb: number;
  speed: number;
  /** m/s² */
  gravity: number;
  grounded: boolean;
  crashed: boolean;
}

export function createObservation(): Observation {
  return {
    direction: vector(),
    way: vector(),
    feet: 0,
    climb: 0,
    speed: 0,
    gravity: 0,
    grounded: false,
    crashed: false,
  };
}

/** Observes the row at 0 in `row`; `bodies` are the rows at its tick. */
export function observe(out: Observation, row: Float64Array, bodies: Float64Array, world: World): void {
  const index = row[REFERENCE_BODY]!;
  const body = world.bodies[index]!;
  take(place, row, POSITION);
  take(velocity, row, VELOCITY);
  take(spin, bodies, index * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  take(attitude, bodies, index * BODY_STRIDE + BODY_ATTITUDE);
  cross(groundVelocity, spin, place);
  for (let k = 0; k < 3; k++) velocity[k] = velocity[k]! - groundVelocity[k]!;
  const distance = Math.hypot(place[0]!, place[1]!, place[2]!);
  for (let k = 0; k < 3; k++) place[k] = place[k]! / distance;
  out.climb = velocity[0]! * place[0]! + velocity[1]! * place[1]! + velocity[2]! * place[2]!;
  for (let k = 0; k < 3; k++) velocity[k] = velocity[k]! - out.climb * place[k]!;
  out.speed = Math.hypot(velocity[0]!, velocity[1]!, velocity[2]!);
  for (let k = 0; k < 3; k++) velocity[k] = out.speed > 0 ? velocity[k]! / out.speed : 0;
  rotateBack(out.direction, attitude, place);
  rotateBack(out.way, attitude, velocity);
  const [nx, ny, nz] = out.direction as unknown as [number, number, number];
  const surface = body.radius + world.terrainHeight(body.name, nx, ny, nz);
  out.feet = distance - surface - row[GROUND_CONTACT_OFFSET]!;
  out.gravity = body.gravityParameter / (distance * distance);
  out.crashed = row[CRASHED] === 1;
  out.grounded = !out.crashed && row[SURFACE_STATE] !== FLYING;
}

const place = vector();
const velocity = vector();
const spin = vector();
const groundVelocity = vector();
const attitude = quaternion();
