import { CELLS } from '../ground/levels';
import { type TerrainLevel } from '../ground/terrainLevel';

/**
 * Whether all of a level is behind the body's bulge: farther round the body than eye and ground together can look over a
 * sphere that touches the `lowest` ground. `eye` local, m; heights over the body's sphere, m.
 */
export function isOverHorizon(
  level: TerrainLevel,
  innerCells: number,
  eye: Float64Array,
  lowest: number,
): boolean {
  const { radius, spacing } = level;
  const x = (level.cornerX + CELLS / 2) * spacing;
  const z = (level.cornerZ + CELLS / 2) * spacing;
  // Negative beside the level, which is then never over the horizon.
  const near = innerCells * spacing - Math.hypot(x - eye[0]!, z - eye[2]!);
  const range = Math.hypot(eye[0]!, eye[1]! + radius, eye[2]!);
  const base = radius + lowest;
  const sight = angleTo(base, range) + angleTo(base, radius + level.highest);
  // A length on the tangent plane seen from the body's centre; off the frame's origin it is seen under a smaller angle.
  const tilted = Math.hypot(eye[0]!, eye[2]!) + near;
  return Math.atan(tilted / radius) - Math.atan((tilted - near) / radius) > sight;
}

/** Angle at the body's centre from a point at `range` to the horizon of a sphere of `base`, both m. */
function angleTo(base: number, range: number): number {
  return range <= base ? 0 : Math.acos(base / range);
}
