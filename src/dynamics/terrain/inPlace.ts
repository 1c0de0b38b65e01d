import type { HeightInPlace, TerrainHeight } from '../constants/world';

/**
 * Terrain look-ups in scratch doubles. A double that is an argument or the result of a call that the engine does not inline is boxed,
 * 64 bytes per look-up, and in a process with several terrains (the ground, a plane ahead of a readout) no call is inlined.
 */

/** Direction and height of the current look-up. */
export const groundPoint = new Float64Array(4);
/** Index of the height in `groundPoint`. */
export const HEIGHT = 3;

/** The game's terrain call, by a look-up in place. */
export function terrainInPlace(inPlace: HeightInPlace): TerrainHeight {
  const point = new Float64Array(4);
  const terrainHeight = (bodyName: string, nx: number, ny: number, nz: number): number => {
    point[0] = nx;
    point[1] = ny;
    point[2] = nz;
    inPlace(point, bodyName);
    return point[HEIGHT]!;
  };
  return Object.assign(terrainHeight, { inPlace });
}

/** Writes the height along the direction in `point` beside it: in place if the terrain can, otherwise by the game's call. */
export function readHeight(point: Float64Array, terrainHeight: TerrainHeight, bodyName: string): void {
  const { inPlace } = terrainHeight;
  if (inPlace === undefined) point[HEIGHT] = terrainHeight(bodyName, point[0]!, point[1]!, point[2]!);
  else inPlace(point, bodyName);
}
