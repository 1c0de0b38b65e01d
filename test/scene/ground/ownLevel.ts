/** A level of the ground, and sectors, in arrays of their own: the page's are parts of one mesh's. */
import { createSectors, type GroundSectors, SECTOR_INDICES } from '../../../src/scene/ground/groundSectors';
import { VERTICES } from '../../../src/scene/ground/levels';
import { createLevel, type TerrainLevel } from '../../../src/scene/ground/terrainLevel';

const POINTS = VERTICES * VERTICES;

export function ownLevel(spacing: number): TerrainLevel {
  return createLevel(spacing, {
    positions: new Float32Array(POINTS * 3),
    normals: new Float32Array(POINTS * 3),
    sunlit: new Float32Array(POINTS),
  });
}

export function ownSectors(): GroundSectors {
  return createSectors(new Uint16Array(SECTOR_INDICES), 0);
}
