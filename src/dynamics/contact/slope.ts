import { SHIP_STRIDE } from '../state/layout';
import {
  BODY_AXES,
  BODY_NORMAL,
  BODY_RADIUS,
  COS_SLOPE,
  GROUND_RADIUS,
  LEVEL_1,
  LEVEL_2,
  NORMAL,
  POINT,
  quantities,
  RISE,
  SLOPE,
  step,
  STEP_BODY,
  SURFACE_NORMAL,
} from './quantities';
import { readMatrix } from './pose';
import type { TerrainHeight } from '../constants/world';
import { groundPoint, HEIGHT, readHeight } from '../terrain/inPlace';
import { LEG_RADIUS } from '../constants/constantRows';

/**
 * s = normal of the plane through the ground one leg radius ahead and behind in two level directions.
 * @param attitude offset of the body's attitude in its rows
 */
export function readSlope(attitude: number): void {
  const q = quantities;
  const { shipClass } = step;
  findLevelDirections();
  if (!recallRises()) {
    const arm = shipClass[LEG_RADIUS]! / q[BODY_RADIUS]!;
    // n_b and e_i are orthonormal, so all four n_b ± arm e_i have the same length.
    const perLength = 1 / Math.sqrt(1 + arm * arm);
    q[POINT] = perLength;
    q[POINT + 1] = arm * perLength;
    readRise(LEVEL_1, RISE);
    readRise(LEVEL_2, RISE + 1);
    keepRises();
  }
  const rise1 = q[RISE]!;
  const rise2 = q[RISE + 1]!;
  const x = q[BODY_NORMAL]! - rise1 * q[LEVEL_1]! - rise2 * q[LEVEL_2]!;
  const y = q[BODY_NORMAL + 1]! - rise1 * q[LEVEL_1 + 1]! - rise2 * q[LEVEL_2 + 1]!;
  const z = q[BODY_NORMAL + 2]! - rise1 * q[LEVEL_1 + 2]! - rise2 * q[LEVEL_2 + 2]!;
  const perNormal = 1 / Math.sqrt(x * x + y * y + z * z);
  const bx = x * perNormal;
  const by = y * perNormal;
  const bz = z * perNormal;
  readMatrix(step.bodies, attitude, BODY_AXES);
  const sx = q[BODY_AXES]! * bx + q[BODY_AXES + 1]! * by + q[BODY_AXES + 2]! * bz;
  const sy = q[BODY_AXES + 3]! * bx + q[BODY_AXES + 4]! * by + q[BODY_AXES + 5]! * bz;
  const sz = q[BODY_AXES + 6]! * bx + q[BODY_AXES + 7]! * by + q[BODY_AXES + 8]! * bz;
  const nx = q[NORMAL]!;
  const ny = q[NORMAL + 1]!;
  const nz = q[NORMAL + 2]!;
  const cos = nx * sx + ny * sy + nz * sz;
  q[SURFACE_NORMAL] = sx;
  q[SURFACE_NORMAL + 1] = sy;
  q[SURFACE_NORMAL + 2] = sz;
  q[COS_SLOPE] = cos;
  q[SLOPE] = nx - cos * sx;
  q[SLOPE + 1] = ny - cos * sy;
  q[SLOPE + 2] = nz - cos * sz;
}

/** |n_b · Y| from which the first level direction is taken from X: Y is the pole, and Y × n_b would be rounding error near it. */
export const NEAR_POLE = 0.9;

/** LEVEL_1 = unit(p × n_b), where p is the pole Y, or X near it; LEVEL_2 = n_b × LEVEL_1. Body axes. */
function findLevelDirections(): void {
  const q = quantities;
  const x = q[BODY_NORMAL]!;
  const y = q[BODY_NORMAL + 1]!;
  const z = q[BODY_NORMAL + 2]!;
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
function readRise(direction: number, rise: number): void {
  const q = quantities;
  const { body, shipClass, terrainHeight } = step;
  const perLength = q[POINT]!;
  const spread = q[POINT + 1]!;
  const x = q[BODY_NORMAL]! * perLength;
  const y = q[BODY_NORMAL + 1]! * perLength;
  const z = q[BODY_NORMAL + 2]! * perLength;
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

function keptIndex(): number {
  return (step.at / SHIP_STRIDE) & (KEPT - 1);
}

/** Fills RISE from the cache; returns whether it was there. */
function recallRises(): boolean {
  const q = quantities;
  const index = keptIndex();
  const at = index * KEPT_STRIDE;
  if (
    kept[at] !== q[BODY_NORMAL] ||
    kept[at + 1] !== q[BODY_NORMAL + 1] ||
    kept[at + 2] !== q[BODY_NORMAL + 2] ||
    kept[at + 3] !== q[GROUND_RADIUS] ||
    kept[at + 4] !== step.shipClass[LEG_RADIUS]! ||
    kept[at + 5] !== q[STEP_BODY] ||
    keptTerrain[index] !== step.terrainHeight
  )
    return false;
  q[RISE] = kept[at + 6]!;
  q[RISE + 1] = kept[at + 7]!;
  return true;
}

function keepRises(): void {
  const q = quantities;
  const index = keptIndex();
  const at = index * KEPT_STRIDE;
  kept[at] = q[BODY_NORMAL]!;
  kept[at + 1] = q[BODY_NORMAL + 1]!;
  kept[at + 2] = q[BODY_NORMAL + 2]!;
  kept[at + 3] = q[GROUND_RADIUS]!;
  kept[at + 4] = step.shipClass[LEG_RADIUS]!;
  kept[at + 5] = q[STEP_BODY]!;
  kept[at + 6] = q[RISE]!;
  kept[at + 7] = q[RISE + 1]!;
  keptTerrain[index] = step.terrainHeight;
}
