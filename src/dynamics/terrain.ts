import type { TerrainHeight } from './world';

/** Level ground at the body's radius. */
export const flatTerrain: TerrainHeight = () => 0;
