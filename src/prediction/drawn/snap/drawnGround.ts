import type { TerrainHeight } from '../../../dynamics';

/** The ground that is drawn, of one body: terrain above its radius. */
export interface DrawnGround {
  bodyName: string;
  /** m */
  radius: number;
  terrainHeight: TerrainHeight;
}

/** Distance, m, of the drawn ground from the body's centre along a unit direction in the body's axes. */
export function groundRadius(
  { bodyName, radius, terrainHeight }: DrawnGround,
  nx: number,
  ny: number,
  nz: number,
): number {
  const height = terrainHeight(bodyName, nx, ny, nz);
  // Null if not loaded, despite its type.
  return height > -radius ? radius + height : radius;
}
