import type { Vec3 } from '../result';
import { crater, createKnownCell, noise, noisePoint, noiseValue } from './noise';
import type { TerrainHeight } from '../constants/world';
import { HEIGHT, terrainInPlace } from './inPlace';

/** Level ground at the body's radius. */
export const flatTerrain: TerrainHeight = terrainInPlace((point) => {
  point[HEIGHT] = 0;
});

/** Unit direction of the level site in `hillsTerrain`, body axes; the same on every body. */
export const LANDING_SITE: Vec3 = [0.6, 0.48, 0.64];

/** Parameters of a body's hills. Lengths and heights of the layers below are for scale 1. */
interface Relief {
  /** Radius of the body, m. */
  readonly radius: number;
  /** Factor on lengths and heights: small bodies have small hills. */
  readonly scale: number;
  /** Weight of the craters, 0 … 1; air and water erode them. */
  readonly craters: number;
  readonly seed: number;
}

const RELIEFS: Readonly<Record<string, Relief>> = {
  Luna: { radius: 1737400, scale: 1, craters: 1, seed: 11 },
  Earth: { radius: 6371000, scale: 1, craters: 0, seed: 23 },
  Mars: { radius: 3389500, scale: 1, craters: 0.6, seed: 37 },
  Phobos: { radius: 11267, scale: 0.08, craters: 1, seed: 53 },
};
const UNKNOWN_BODY: Relief = { radius: 1000000, scale: 1, craters: 1, seed: 71 };

/** Layers of the relief: edge of the noise cells, m, and height, m. Their sum stays within ±2 km. */
const SWELL = { cell: 12000, height: 650, known: createKnownCell() };
const RIDGES = { cell: 4300, height: 420, known: createKnownCell() };
const HILLS = { cell: 1100, height: 60, known: createKnownCell() };
const BUMPS = { cell: 130, height: 2.5, known: createKnownCell() };
/** Layers of craters, one per cell: edge of the cells, m, and an offset of the seed that makes the layers differ. */
const CRATERS = { cell: 1500, seed: 4, known: createKnownCell() };
const PITS = { cell: 260, seed: 5, known: createKnownCell() };
/** Distances from the site's centre, m: the ground is level up to the first, and the relief is complete from the second on. */
const LEVEL_RADIUS = 350;
const WHOLE_RADIUS = 4500;

/**
 * Ridges, hills, craters and a level landing site, by + − × ÷ √, floor and integer hashing only: the same bits everywhere.
 * Continuous; within ±2 km. Body axes as in TerrainHeight.
 */
export const hillsTerrain: TerrainHeight = terrainInPlace((point, bodyName) => {
  const nx = point[0]!;
  const ny = point[1]!;
  const nz = point[2]!;
  const relief = RELIEFS[bodyName] ?? UNKNOWN_BODY;
  const size = relief.radius / relief.scale;
  const sx = nx - LANDING_SITE[0];
  const sy = ny - LANDING_SITE[1];
  const sz = nz - LANDING_SITE[2];
  const fromSite = Math.sqrt(sx * sx + sy * sy + sz * sz) * size;
  if (fromSite <= LEVEL_RADIUS) {
    point[HEIGHT] = 0;
    return;
  }
  noisePoint[0] = nx * size;
  noisePoint[1] = ny * size;
  noisePoint[2] = nz * size;
  noise(SWELL.cell, relief.seed, SWELL.known);
  const swell = SWELL.height * noiseValue[0]!;
  noise(RIDGES.cell, relief.seed + 1, RIDGES.known);
  const crest = 1 - (noiseValue[0]! < 0 ? -noiseValue[0]! : noiseValue[0]!);
  const ridge = RIDGES.height * (crest * crest * crest);
  noise(HILLS.cell, relief.seed + 2, HILLS.known);
  const hills = HILLS.height * noiseValue[0]!;
  noise(BUMPS.cell, relief.seed + 3, BUMPS.known);
  const bumps = BUMPS.height * noiseValue[0]!;
  crater(CRATERS.cell, relief.seed + CRATERS.seed, CRATERS.known);
  const bowl = noiseValue[0]!;
  crater(PITS.cell, relief.seed + PITS.seed, PITS.known);
  const ground = swell + ridge + hills + bumps + relief.craters * (bowl + noiseValue[0]!);
  const t = fromSite < WHOLE_RADIUS ? (fromSite - LEVEL_RADIUS) / (WHOLE_RADIUS - LEVEL_RADIUS) : 1;
  point[HEIGHT] = relief.scale * (t * t * (3 - 2 * t)) * ground;
});

/** The terrains a hello may name. */
export const TERRAINS: Readonly<Record<string, TerrainHeight>> = Object.freeze({
  flat: flatTerrain,
  hills: hillsTerrain,
});
