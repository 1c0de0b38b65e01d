import { REFERENCE_BODY, SHIP_STRIDE } from '../state/layout';
import {
  BODY_NORMAL,
  COS_SLOPE,
  GROUND_RADIUS,
  LEVEL_1,
  LEVEL_2,
  NORMAL,
  POINT,
  quantities,
  RISE,
  SLOPE,
  SMI_MASK,
  type Step,
  SURFACE_NORMAL,
} from './quantities';
import type { TerrainHeight } from '../constants/world';
import { groundPoint, HEIGHT, readHeight } from '../terrain/inPlace';
import { LEG_RADIUS } from '../constants/constantRows';

/** s = normal of the plane through the ground one leg radius ahead and behind in two level directions. */
export function readSlope(surface: Float64Array, step: Step, bodyAxes: number): void {
  const q = quantities;
  const { bodies, body, shipClass } = step;
  findLevelDirections(surface);
  if (!recallRises(surface, step)) {
    const arm = shipClass[LEG_RADIUS]! / body.radius;
    // n_b and e_i are orthonormal, so all four n_b ± arm e_i have the same length.
    const perLength = 1 / Math.sqrt(1 + arm * arm);
    q[POINT] = perLength;
    q[POINT + 1] = arm * perLength;
    readRise(surface, step, LEVEL_1, RISE);
    readRise(surface, step, LEVEL_2, RISE + 1);
    keepRises(surface, step);
  }
  const rise1 = q[RISE]!;
  const rise2 = q[RISE + 1]!;
  const x = surface[BODY_NORMAL]! - rise1 * q[LEVEL_1]! - rise2 * q[LEVEL_2]!;
  const y = surface[BODY_NORMAL + 1]! - rise1 * q[LEVEL_1 + 1]! - rise2 * q[LEVEL_2 + 1]!;
  const z = surface[BODY_NORMAL + 2]! - rise1 * q[LEVEL_1 + 2]! - rise2 * q[LEVEL_2 + 2]!;
  const perNormal = 1 / Math.sqrt(x * x + y * y + z * z);
  const bx = x * perNormal;
  const by = y * perNormal;
  const bz = z * perNormal;
  const axes = (step.bodyAt + bodyAxes) & SMI_MASK;
  const sx = bodies[axes]! * bx + bodies[axes + 1]! * by + bodies[axes + 2]! * bz;
  const sy = bodies[axes + 3]! * bx + bodies[axes + 4]! * by + bodies[axes + 5]! * bz;
  const sz = bodies[axes + 6]! * bx + bodies[axes + 7]! * by + bodies[axes + 8]! * bz;
  const nx = surface[NORMAL]!;
  const ny = surface[NORMAL + 1]!;
  const nz = surface[NORMAL + 2]!;
  const cos = nx * sx + ny * sy + nz * sz;
  surface[SURFACE_NORMAL] = sx;
  surface[SURFACE_NORMAL + 1] = sy;
  surface[SURFACE_NORMAL + 2] = sz;
  surface[COS_SLOPE] = cos;
  surface[SLOPE] = nx - cos * sx;
  surface[SLOPE + 1] = ny - cos * sy;
  surface[SLOPE + 2] = nz - cos * sz;
}

/** |n_b · Y| from which the first level direction is taken from X: Y is the pole, and Y × n_b would be rounding error near it. */
export const NEAR_POLE = 0.9;

/** LEVEL_1 = unit(p × n_b), where p is the pole Y, or X near it; LEVEL_2 = n_b × LEVEL_1. Body axes. */
function findLevelDirections(surface: Float64Array): void {
  const q = quantities;
  const x = surface[BODY_NORMAL]!;
  const y = surface[BODY_NORMAL + 1]!;
  const z = surface[BODY_NORMAL + 2]!;
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

/** q[rise] = slope of the ground along the level direction at slot `direction`, m/m. */
function readRise(surface: Float64Array, step: Step, direction: number, rise: number): void {
  const q = quantities;
  const { body, shipClass, terrainHeight } = step;
  const perLength = q[POINT]!;
  const spread = q[POINT + 1]!;
  const x = surface[BODY_NORMAL]! * perLength;
  const y = surface[BODY_NORMAL + 1]! * perLength;
  const z = surface[BODY_NORMAL + 2]! * perLength;
  const ex = q[direction]! * spread;
  const ey = q[direction + 1]! * spread;
  const ez = q[direction + 2]! * spread;
  const point = groundPoint;
  point[0] = x + ex;
  point[1] = y + ey;
  point[2] = z + ez;
  readHeight(point, terrainHeight, body.name);
  const ahead = point[HEIGHT]!;
  point[0] = x - ex;
  point[1] = y - ey;
  point[2] = z - ez;
  readHeight(point, terrainHeight, body.name);
  q[rise] = (ahead - point[HEIGHT]!) / (2 * shipClass[LEG_RADIUS]!);
}

/**
 * Cache of the last slopes of each row. A substep starts where the previous one ended, so the cache saves half of the terrain look-ups
 * with identical results. The key is direction, ground radius, footprint, body and terrain.
 */
const KEPT = 256;
const KEPT_STRIDE = 8;
const kept = new Float64Array(KEPT * KEPT_STRIDE).fill(NaN);
const keptTerrain: (TerrainHeight | null)[] = Array.from({ length: KEPT }, () => null);

function keptIndex(step: Step): number {
  return (step.at / SHIP_STRIDE) & (KEPT - 1);
}

/** Fills RISE from the cache; returns whether it was there. */
function recallRises(surface: Float64Array, step: Step): boolean {
  const q = quantities;
  const index = keptIndex(step);
  const at = index * KEPT_STRIDE;
  if (
    kept[at] !== surface[BODY_NORMAL] ||
    kept[at + 1] !== surface[BODY_NORMAL + 1] ||
    kept[at + 2] !== surface[BODY_NORMAL + 2] ||
    kept[at + 3] !== surface[GROUND_RADIUS] ||
    kept[at + 4] !== step.shipClass[LEG_RADIUS]! ||
    kept[at + 5] !== q[REFERENCE_BODY] ||
    keptTerrain[index] !== step.terrainHeight
  )
    return false;
  q[RISE] = kept[at + 6]!;
  q[RISE + 1] = kept[at + 7]!;
  return true;
}

function keepRises(surface: Float64Array, step: Step): void {
  const q = quantities;
  const index = keptIndex(step);
  const at = index * KEPT_STRIDE;
  kept[at] = surface[BODY_NORMAL]!;
  kept[at + 1] = surface[BODY_NORMAL + 1]!;
  kept[at + 2] = surface[BODY_NORMAL + 2]!;
  kept[at + 3] = surface[GROUND_RADIUS]!;
  kept[at + 4] = step.shipClass[LEG_RADIUS]!;
  kept[at + 5] = q[REFERENCE_BODY]!;
  kept[at + 6] = q[RISE]!;
  kept[at + 7] = q[RISE + 1]!;
  keptTerrain[index] = step.terrainHeight;
}
