import type { LoadedBody } from './body';
import type { LoadedSettings } from './settings';
import type { LoadedShipClass } from './shipClass';

/**
 * The game's terrain call: height above the body's radius, m, in the unit direction (nx, ny, nz), body axes (Y pole, Z prime meridian,
 * X 90° E). Must be finite and continuous (a step is a wall), and must not throw, which would end a substep half-way. Uses only
 * + − × ÷ √ where bits must agree.
 */
export interface TerrainHeight {
  (bodyName: string, nx: number, ny: number, nz: number): number;
  /** The same look-up in scratch doubles; the substep uses it if the terrain has one. */
  readonly inPlace?: HeightInPlace;
}

/** Reads a unit direction, body axes, from `point[0..2]` and writes the height, m, to `point[3]`. */
export type HeightInPlace = (point: Float64Array, bodyName: string) => void;

/** The ground of one body under one ship. */
export interface GroundUnderShip {
  readonly bodyName: string;
  /** Radius of the body, m. */
  readonly radius: number;
  /** Radius of the ship's footprint, m. */
  readonly legRadius: number;
  readonly terrainHeight: TerrainHeight;
}

/** How the ground's own normal is computed, for `surface_normal` terrain. */
export interface TerrainNormals {
  /** For the substep in progress (slope.ts); `attitude`: offset of the body's attitude in its rows. */
  readonly readSlope: (attitude: number) => void;
  /** For views (groundNormal.ts). */
  readonly writeGroundNormal: (out: Float64Array, normal: Float64Array, ground: GroundUnderShip) => void;
}

/** Everything a substep reads of the world. A world is immutable: another setting, class or terrain makes another world. */
export interface World {
  readonly settings: LoadedSettings;
  readonly shipClasses: readonly LoadedShipClass[];
  readonly bodies: readonly LoadedBody[];
  readonly terrainHeight: TerrainHeight;
  /** Null only in a world of radial normals. */
  readonly terrainNormals: TerrainNormals | null;
}
