import type { LoadedBody } from './body';
import type { LoadedSettings } from './settings';
import type { LoadedShipClass } from './shipClass';

/**
 * The game's terrain call: metres above the body's radius along the unit direction (nx, ny, nz) in the body's axes
 * (Y pole, Z prime meridian, X 90° E). Finite, continuous (a step is a wall), and for exactness from + − × ÷ √ alone.
 */
export interface TerrainHeight {
  (bodyName: string, nx: number, ny: number, nz: number): number;
  /** The same height in scratch doubles, if the terrain has it; the substep then uses this. */
  readonly inPlace?: HeightInPlace;
}

/** Reads the unit direction at `point[0..2]`, body's axes, and writes its height, m, to `point[3]`. */
export type HeightInPlace = (point: Float64Array, bodyName: string) => void;

/** Everything a substep reads of the world. A substep changes only rows. */
export interface World {
  readonly settings: LoadedSettings;
  readonly shipClasses: readonly LoadedShipClass[];
  readonly bodies: readonly LoadedBody[];
  readonly terrainHeight: TerrainHeight;
}
