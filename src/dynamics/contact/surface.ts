import { BODY_ANGULAR_VELOCITY, GROUND_CONTACT_OFFSET, POSITION, VELOCITY } from '../state/layout';
import {
  BODY_NORMAL,
  COS_SLOPE,
  DISTANCE,
  GRAVITY,
  GROUND_RADIUS,
  NORMAL,
  NORMAL_SPEED,
  PENETRATION,
  quantities,
  SLOPE,
  SMI_MASK,
  type Step,
  SURFACE_NORMAL,
  TANGENTIAL_SPEED_SQUARED,
  TANGENTIAL_VELOCITY,
} from './quantities';
import { readSlope } from './slope';
import { groundPoint, HEIGHT, readHeight } from '../terrain/inPlace';

/** Fills NORMAL, DISTANCE and GRAVITY at `surface` (START or END) from the ship's position as it is now. */
export function readPlace(surface: number, step: Step): void {
  const q = quantities;
  const to = surface & SMI_MASK;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const squared = rx * rx + ry * ry + rz * rz;
  const distance = Math.sqrt(squared);
  const perDistance = 1 / distance;
  q[to + NORMAL] = rx * perDistance;
  q[to + NORMAL + 1] = ry * perDistance;
  q[to + NORMAL + 2] = rz * perDistance;
  q[to + DISTANCE] = distance;
  q[to + GRAVITY] = step.body.gravityParameter / squared;
}

/**
 * Fills PENETRATION at `surface`, whose place has been read.
 * @param bodyAxes BODY_AXES at a substep's start, BODY_END_AXES at its end: how the body lies under the ship.
 */
export function readPenetration(surface: number, step: Step, bodyAxes: number): void {
  const q = quantities;
  const to = surface & SMI_MASK;
  const { bodies, body } = step;
  const axes = (step.bodyAt + bodyAxes) & SMI_MASK;
  const nx = q[to + NORMAL]!;
  const ny = q[to + NORMAL + 1]!;
  const nz = q[to + NORMAL + 2]!;
  const bx = bodies[axes]! * nx + bodies[axes + 3]! * ny + bodies[axes + 6]! * nz;
  const by = bodies[axes + 1]! * nx + bodies[axes + 4]! * ny + bodies[axes + 7]! * nz;
  const bz = bodies[axes + 2]! * nx + bodies[axes + 5]! * ny + bodies[axes + 8]! * nz;
  q[to + BODY_NORMAL] = bx;
  q[to + BODY_NORMAL + 1] = by;
  q[to + BODY_NORMAL + 2] = bz;
  const point = groundPoint;
  point[0] = bx;
  point[1] = by;
  point[2] = bz;
  readHeight(point, step.world.terrainHeight, body.name);
  const ground = body.radius + point[HEIGHT]!;
  q[to + GROUND_RADIUS] = ground;
  q[to + PENETRATION] = ground + q[GROUND_CONTACT_OFFSET]! - q[to + DISTANCE]!;
}

/** Fills the surface normal and the velocity relative to the ground at `surface`, whose penetration has been read. */
export function readGround(surface: number, step: Step, bodyAxes: number): void {
  if (step.world.settings.surfaceNormal === 'terrain') readSlope(surface, step, bodyAxes);
  else readLevel(surface);
  readVelocity(surface, step);
}

/** s = n */
function readLevel(surface: number): void {
  const q = quantities;
  const to = surface & SMI_MASK;
  q[to + SURFACE_NORMAL] = q[to + NORMAL]!;
  q[to + SURFACE_NORMAL + 1] = q[to + NORMAL + 1]!;
  q[to + SURFACE_NORMAL + 2] = q[to + NORMAL + 2]!;
  q[to + COS_SLOPE] = 1;
  q[to + SLOPE] = 0;
  q[to + SLOPE + 1] = 0;
  q[to + SLOPE + 2] = 0;
}

/** NORMAL_SPEED, TANGENTIAL_VELOCITY and its square: v_rel = u − Ω × r off the ground and along it. */
function readVelocity(surface: number, step: Step): void {
  const q = quantities;
  const to = surface & SMI_MASK;
  const { bodies } = step;
  const bodyAt = step.bodyAt & SMI_MASK;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const ox = bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const oy = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const oz = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const vx = q[VELOCITY]! - (oy * rz - oz * ry);
  const vy = q[VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = q[VELOCITY + 2]! - (ox * ry - oy * rx);
  const sx = q[to + SURFACE_NORMAL]!;
  const sy = q[to + SURFACE_NORMAL + 1]!;
  const sz = q[to + SURFACE_NORMAL + 2]!;
  const speed = vx * sx + vy * sy + vz * sz;
  const tx = vx - speed * sx;
  const ty = vy - speed * sy;
  const tz = vz - speed * sz;
  q[to + NORMAL_SPEED] = speed;
  q[to + TANGENTIAL_VELOCITY] = tx;
  q[to + TANGENTIAL_VELOCITY + 1] = ty;
  q[to + TANGENTIAL_VELOCITY + 2] = tz;
  q[to + TANGENTIAL_SPEED_SQUARED] = tx * tx + ty * ty + tz * tz;
}
