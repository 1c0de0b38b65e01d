import { BODY_ANGULAR_VELOCITY, GROUND_CONTACT_OFFSET, POSITION, VELOCITY } from './layout';
import {
  BODY_NORMAL,
  COS_SLOPE,
  DISTANCE,
  GRAVITY,
  LEVEL_1,
  LEVEL_2,
  NORMAL,
  NORMAL_SPEED,
  PENETRATION,
  POINT,
  quantities,
  RISE,
  SLOPE,
  SMI_MASK,
  type Step,
  SURFACE_NORMAL,
  TANGENTIAL_SPEED_SQUARED,
  TANGENTIAL_VELOCITY,
} from './quantities';

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
  const ground = body.radius + step.world.terrainHeight(body.name, bx, by, bz);
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

/** s = the normal of the plane that the feet stand on: the ground one leg radius ahead and behind, in two level directions. */
function readSlope(surface: number, step: Step, bodyAxes: number): void {
  const q = quantities;
  const to = surface & SMI_MASK;
  const { bodies, body, shipClass } = step;
  findLevelDirections(to);
  const arm = shipClass.legRadius / body.radius;
  // n_b and e_i are unit and at right angles, so n_b ± arm e_i have all four the same length.
  const perLength = 1 / Math.sqrt(1 + arm * arm);
  q[POINT] = perLength;
  q[POINT + 1] = arm * perLength;
  readRise(to, step, LEVEL_1, RISE);
  readRise(to, step, LEVEL_2, RISE + 1);
  const rise1 = q[RISE]!;
  const rise2 = q[RISE + 1]!;
  const x = q[to + BODY_NORMAL]! - rise1 * q[LEVEL_1]! - rise2 * q[LEVEL_2]!;
  const y = q[to + BODY_NORMAL + 1]! - rise1 * q[LEVEL_1 + 1]! - rise2 * q[LEVEL_2 + 1]!;
  const z = q[to + BODY_NORMAL + 2]! - rise1 * q[LEVEL_1 + 2]! - rise2 * q[LEVEL_2 + 2]!;
  const perNormal = 1 / Math.sqrt(x * x + y * y + z * z);
  const bx = x * perNormal;
  const by = y * perNormal;
  const bz = z * perNormal;
  const axes = (step.bodyAt + bodyAxes) & SMI_MASK;
  const sx = bodies[axes]! * bx + bodies[axes + 1]! * by + bodies[axes + 2]! * bz;
  const sy = bodies[axes + 3]! * bx + bodies[axes + 4]! * by + bodies[axes + 5]! * bz;
  const sz = bodies[axes + 6]! * bx + bodies[axes + 7]! * by + bodies[axes + 8]! * bz;
  const nx = q[to + NORMAL]!;
  const ny = q[to + NORMAL + 1]!;
  const nz = q[to + NORMAL + 2]!;
  const cos = nx * sx + ny * sy + nz * sz;
  q[to + SURFACE_NORMAL] = sx;
  q[to + SURFACE_NORMAL + 1] = sy;
  q[to + SURFACE_NORMAL + 2] = sz;
  q[to + COS_SLOPE] = cos;
  q[to + SLOPE] = nx - cos * sx;
  q[to + SLOPE + 1] = ny - cos * sy;
  q[to + SLOPE + 2] = nz - cos * sz;
}

/** Near the pole (Y of the body's axes) the first level direction is taken from X instead: p × n_b would be round-off there. */
const NEAR_POLE = 0.9;

/** LEVEL_1 = unit(p × n_b), p the pole or near it X; LEVEL_2 = n_b × LEVEL_1. Body's axes. */
function findLevelDirections(to: number): void {
  const q = quantities;
  const x = q[to + BODY_NORMAL]!;
  const y = q[to + BODY_NORMAL + 1]!;
  const z = q[to + BODY_NORMAL + 2]!;
  if (y >= NEAR_POLE || y <= -NEAR_POLE) {
    const perLength = 1 / Math.sqrt(z * z + y * y);
    const ey = -z * perLength;
    const ez = y * perLength;
    q[LEVEL_1] = 0;
    q[LEVEL_1 + 1] = ey;
    q[LEVEL_1 + 2] = ez;
    q[LEVEL_2] = y * ez - z * ey;
    q[LEVEL_2 + 1] = -x * ez;
    q[LEVEL_2 + 2] = x * ey;
  } else {
    const perLength = 1 / Math.sqrt(z * z + x * x);
    const ex = z * perLength;
    const ez = -x * perLength;
    q[LEVEL_1] = ex;
    q[LEVEL_1 + 1] = 0;
    q[LEVEL_1 + 2] = ez;
    q[LEVEL_2] = y * ez;
    q[LEVEL_2 + 1] = z * ex - x * ez;
    q[LEVEL_2 + 2] = -y * ex;
  }
}

/** q[rise] = how much the ground rises per metre along the level direction at `direction`. */
function readRise(to: number, step: Step, direction: number, rise: number): void {
  const q = quantities;
  const { body, shipClass, world } = step;
  const perLength = q[POINT]!;
  const spread = q[POINT + 1]!;
  const x = q[to + BODY_NORMAL]! * perLength;
  const y = q[to + BODY_NORMAL + 1]! * perLength;
  const z = q[to + BODY_NORMAL + 2]! * perLength;
  const ex = q[direction]! * spread;
  const ey = q[direction + 1]! * spread;
  const ez = q[direction + 2]! * spread;
  const ahead = world.terrainHeight(body.name, x + ex, y + ey, z + ez);
  const behind = world.terrainHeight(body.name, x - ex, y - ey, z - ez);
  q[rise] = (ahead - behind) / (2 * shipClass.legRadius);
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
