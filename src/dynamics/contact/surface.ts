import { GROUND_CONTACT_OFFSET, POSITION, VELOCITY } from '../state/layout';
import {
  BODY_NORMAL,
  COS_SLOPE,
  DISTANCE,
  GRAVITY,
  GROUND_RADIUS,
  NORMAL,
  NORMAL_SPEED,
  PENETRATION,
  GROUND_SPIN,
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
import { IS_TERRAIN_NORMAL } from '../constants/constantRows';

/** Fills NORMAL, DISTANCE and GRAVITY of `surface` (`start` or `end`) from the ship's current position. */
export function readPlace(surface: Float64Array, step: Step): void {
  const q = quantities;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const squared = rx * rx + ry * ry + rz * rz;
  const distance = Math.sqrt(squared);
  const perDistance = 1 / distance;
  surface[NORMAL] = rx * perDistance;
  surface[NORMAL + 1] = ry * perDistance;
  surface[NORMAL + 2] = rz * perDistance;
  surface[DISTANCE] = distance;
  surface[GRAVITY] = step.body.gravityParameter / squared;
}

/**
 * Fills the other columns of `surface` after readPlace: penetration, surface normal, and the velocity relative to the ground,
 * v_rel = u − Ω × r, normal and tangential.
 * @param bodyAxes column of the body's attitude: BODY_AXES at the substep's start, BODY_END_AXES at its end
 * @param evenOffGround false: stops after the penetration if it is not positive
 */
export function readSurface(
  surface: Float64Array,
  step: Step,
  bodyAxes: number,
  evenOffGround: boolean,
): void {
  const q = quantities;
  const { bodies, body } = step;
  const axes = (step.bodyAt + bodyAxes) & SMI_MASK;
  const nx = surface[NORMAL]!;
  const ny = surface[NORMAL + 1]!;
  const nz = surface[NORMAL + 2]!;
  const point = groundPoint;
  point[0] = bodies[axes]! * nx + bodies[axes + 3]! * ny + bodies[axes + 6]! * nz;
  point[1] = bodies[axes + 1]! * nx + bodies[axes + 4]! * ny + bodies[axes + 7]! * nz;
  point[2] = bodies[axes + 2]! * nx + bodies[axes + 5]! * ny + bodies[axes + 8]! * nz;
  surface[BODY_NORMAL] = point[0];
  surface[BODY_NORMAL + 1] = point[1]!;
  surface[BODY_NORMAL + 2] = point[2]!;
  readHeight(point, step.terrainHeight, body.name);
  const ground = body.radius + point[HEIGHT]!;
  surface[GROUND_RADIUS] = ground;
  surface[PENETRATION] = ground + q[GROUND_CONTACT_OFFSET]! - surface[DISTANCE]!;
  if (!evenOffGround && !(surface[PENETRATION] > 0)) return;

  let sx = nx;
  let sy = ny;
  let sz = nz;
  if (step.settings[IS_TERRAIN_NORMAL] === 1) {
    readSlope(surface, step, bodyAxes);
    sx = surface[SURFACE_NORMAL]!;
    sy = surface[SURFACE_NORMAL + 1]!;
    sz = surface[SURFACE_NORMAL + 2]!;
  } else {
    readLevel(surface);
  }
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const vx = q[VELOCITY]! - (oy * rz - oz * ry);
  const vy = q[VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = q[VELOCITY + 2]! - (ox * ry - oy * rx);
  const speed = vx * sx + vy * sy + vz * sz;
  const tx = vx - speed * sx;
  const ty = vy - speed * sy;
  const tz = vz - speed * sz;
  surface[NORMAL_SPEED] = speed;
  surface[TANGENTIAL_VELOCITY] = tx;
  surface[TANGENTIAL_VELOCITY + 1] = ty;
  surface[TANGENTIAL_VELOCITY + 2] = tz;
  surface[TANGENTIAL_SPEED_SQUARED] = tx * tx + ty * ty + tz * tz;
}

/** s = n */
function readLevel(surface: Float64Array): void {
  surface[SURFACE_NORMAL] = surface[NORMAL]!;
  surface[SURFACE_NORMAL + 1] = surface[NORMAL + 1]!;
  surface[SURFACE_NORMAL + 2] = surface[NORMAL + 2]!;
  surface[COS_SLOPE] = 1;
  surface[SLOPE] = 0;
  surface[SLOPE + 1] = 0;
  surface[SLOPE + 2] = 0;
}
