import type { HeightInPlace, TerrainHeight } from '../constants/world';

/**
 * Terrain look-ups in scratch doubles. The engine boxes double arguments and results of calls that it does not inline, 64 bytes per
 * look-up, and it inlines none in a process with several terrains (such as the ground and a readout's plane ahead).
 */

/** Direction and height of the current look-up. */
export const groundPoint = new Float64Array(4);
/** Index of the height in `groundPoint`. */
export const HEIGHT = 3;

/** The game's terrain call for a look-up in place. */
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

/** Writes the height for the direction in `point` to `point[HEIGHT]`: in place if the terrain can, else by the game's call. */
export function readHeight(point: Float64Array, terrainHeight: TerrainHeight, bodyName: string): void {
  const { inPlace } = terrainHeight;
  if (inPlace === undefined) point[HEIGHT] = terrainHeight(bodyName, point[0]!, point[1]!, point[2]!);
  else inPlace(point, bodyName);
}
