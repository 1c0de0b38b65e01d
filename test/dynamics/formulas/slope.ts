import type { TerrainHeight, Vec3 } from '../../../src/dynamics';
import { cross, dot, unit } from '../vectors';

/** The foot of the slopes, unit, body axes. */
export const FOOT: Vec3 = unit([0.6, 0.48, 0.64]);
/** Horizontal at FOOT, toward the body's east. */
export const EAST: Vec3 = unit(cross([0, 1, 0], FOOT));

/** Ground that rises by tan(degrees) toward the east through FOOT; straight to one part in 10⁶ over metres. */
export function slopeOf(degrees: number, radius: number): TerrainHeight {
  const rise = radius * Math.tan((degrees * Math.PI) / 180);
  return (_body, x, y, z) => rise * dot(EAST, [x, y, z]);
}

/** Ground that rises on both sides of FOOT toward east and west, as (distance)² / (2 bend): metres. */
export function valleyOf(bend: number, radius: number): TerrainHeight {
  const scale = (radius * radius) / (2 * bend);
  return (_body, x, y, z) => {
    const along = dot(EAST, [x, y, z]);
    return scale * along * along;
  };
}
