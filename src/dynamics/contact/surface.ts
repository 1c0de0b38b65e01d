import { GROUND_CONTACT_OFFSET, POSITION } from '../state/layout';
import {
  BODY_NORMAL,
  BODY_RADIUS,
  COS_SLOPE,
  DISTANCE,
  DISTANCE_SQUARED,
  GROUND_RADIUS,
  NORMAL,
  PENETRATION,
  quantities,
  SLOPE,
  SMI_MASK,
  step,
  SURFACE_NORMAL,
} from './quantities';
import { groundPoint, HEIGHT, readHeight } from '../terrain/inPlace';
import { IS_TERRAIN_NORMAL } from '../constants/constantRows';

/** Fills NORMAL, DISTANCE and DISTANCE_SQUARED from the ship's current position. */
export function readPlace(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const squared = rx * rx + ry * ry + rz * rz;
  const distance = Math.sqrt(squared);
  const perDistance = 1 / distance;
  q[NORMAL] = rx * perDistance;
  q[NORMAL + 1] = ry * perDistance;
  q[NORMAL + 2] = rz * perDistance;
  q[DISTANCE] = distance;
  q[DISTANCE_SQUARED] = squared;
}

/**
 * Fills NORMAL, DISTANCE_SQUARED, PENETRATION, SURFACE_NORMAL, COS_SLOPE and SLOPE.
 * @param attitude column of the body's attitude: BODY_ATTITUDE at the substep's start, BODY_END_ATTITUDE at its end
 * @param evenOffGround false: stops after the penetration if it is not positive
 */
export function readSurface(attitude: number, evenOffGround: boolean): void {
  const q = quantities;
  const { ships, bodies } = step;
  const at = step.at & SMI_MASK;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  // As in readPlace, but in registers.
  const squared = rx * rx + ry * ry + rz * rz;
  const distance = Math.sqrt(squared);
  const perDistance = 1 / distance;
  const nx = rx * perDistance;
  const ny = ry * perDistance;
  const nz = rz * perDistance;
  q[NORMAL] = nx;
  q[NORMAL + 1] = ny;
  q[NORMAL + 2] = nz;
  q[DISTANCE_SQUARED] = squared;

  const bodyAt = (step.bodyAt + attitude) & SMI_MASK;
  const bx = bodies[bodyAt]!;
  const by = bodies[bodyAt + 1]!;
  const bz = bodies[bodyAt + 2]!;
  const bw = bodies[bodyAt + 3]!;
  const bx2 = bx + bx;
  const by2 = by + by;
  const bz2 = bz + bz;
  const x = (1 - (by * by2 + bz * bz2)) * nx + (bx * by2 + bw * bz2) * ny + (bx * bz2 - bw * by2) * nz;
  const y = (bx * by2 - bw * bz2) * nx + (1 - (bx * bx2 + bz * bz2)) * ny + (by * bz2 + bw * bx2) * nz;
  const z = (bx * bz2 + bw * by2) * nx + (by * bz2 - bw * bx2) * ny + (1 - (bx * bx2 + by * by2)) * nz;
  const point = groundPoint;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  readHeight(point, step.terrainHeight, step.body.name);
  const ground = q[BODY_RADIUS]! + point[HEIGHT]!;
  const penetration = ground + ships[at + GROUND_CONTACT_OFFSET]! - distance;
  q[PENETRATION] = penetration;
  if (!evenOffGround && !(penetration > 0)) return;
  if (step.settings[IS_TERRAIN_NORMAL] === 1) {
    q[BODY_NORMAL] = x;
    q[BODY_NORMAL + 1] = y;
    q[BODY_NORMAL + 2] = z;
    q[GROUND_RADIUS] = ground;
    step.world.terrainNormals!.readSlope(bodyAt);
    return;
  }
  // s = n
  q[SURFACE_NORMAL] = nx;
  q[SURFACE_NORMAL + 1] = ny;
  q[SURFACE_NORMAL + 2] = nz;
  q[COS_SLOPE] = 1;
  q[SLOPE] = 0;
  q[SLOPE + 1] = 0;
  q[SLOPE + 2] = 0;
}
