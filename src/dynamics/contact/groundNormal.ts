import type { GroundUnderShip } from '../constants/world';
import { NEAR_POLE } from './slope';

/**
 * Surface normal of `surface_normal` terrain (DYNAMICS, "The ground's own normal"), for views and readouts. The substep computes its
 * own (slope.ts).
 * @param out unit, body axes
 * @param normal the radial direction, unit, body axes
 */
export function writeGroundNormal(out: Float64Array, normal: Float64Array, ground: GroundUnderShip): void {
  const [x, y, z] = normal as unknown as readonly [number, number, number];
  const isNearPole = y >= NEAR_POLE || y <= -NEAR_POLE;
  const length = isNearPole ? Math.sqrt(z * z + y * y) : Math.sqrt(z * z + x * x);
  const ax = isNearPole ? 0 : z / length;
  const ay = isNearPole ? -z / length : 0;
  const az = (isNearPole ? y : -x) / length;
  const bx = y * az - z * ay;
  const by = z * ax - x * az;
  const bz = x * ay - y * ax;
  const first = rise(normal, ax, ay, az, ground);
  const second = rise(normal, bx, by, bz, ground);
  const sx = x - first * ax - second * bx;
  const sy = y - first * ay - second * by;
  const sz = z - first * az - second * bz;
  const perLength = 1 / Math.sqrt(sx * sx + sy * sy + sz * sz);
  out[0] = sx * perLength;
  out[1] = sy * perLength;
  out[2] = sz * perLength;
}

/** Slope of the ground along the level unit direction (dx, dy, dz), m/m. */
function rise(n: Float64Array, dx: number, dy: number, dz: number, ground: GroundUnderShip): number {
  const { bodyName, radius, legRadius, terrainHeight } = ground;
  const arm = legRadius / radius;
  const l = 1 / Math.sqrt(1 + arm * arm);
  const [x, y, z] = n as unknown as readonly [number, number, number];
  const ahead = terrainHeight(bodyName, (x + dx * arm) * l, (y + dy * arm) * l, (z + dz * arm) * l);
  const behind = terrainHeight(bodyName, (x - dx * arm) * l, (y - dy * arm) * l, (z - dz * arm) * l);
  return (ahead - behind) / (2 * legRadius);
}
