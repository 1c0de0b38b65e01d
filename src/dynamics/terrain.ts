import type { TerrainHeight } from './world';

/** Level ground at the body's radius. */
export const flatTerrain: TerrainHeight = () => 0;

/** Terrains by the name a server tells. */
export const TERRAINS: Readonly<Record<string, TerrainHeight>> = Object.freeze({ flat: flatTerrain });
