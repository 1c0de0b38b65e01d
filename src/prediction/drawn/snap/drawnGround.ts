import { HEIGHT, readHeight, type TerrainHeight } from '../../../dynamics';

/** The ground that is drawn, of one body: terrain above its radius. */
export interface DrawnGround {
  bodyName: string;
  /** m */
  radius: number;
  terrainHeight: TerrainHeight;
}

/** A unit direction in the body's axes, and room for one double beside it. */
export const groundDirection = (): Float64Array => new Float64Array(4);

/**
 * Writes the distance, m, of the drawn ground from the body's centre along the direction in `point` to point[HEIGHT]. In place, since
 * a double that is an argument or the result of a call that is not inlined is boxed.
 */
export function writeGroundRadius(
  point: Float64Array,
  { bodyName, radius, terrainHeight }: DrawnGround,
): void {
  readHeight(point, terrainHeight, bodyName);
  const height = point[HEIGHT]!;
  // NaN if a terrain returns no number, despite its type.
  point[HEIGHT] = height > -radius ? radius + height : radius;
}
