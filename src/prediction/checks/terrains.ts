import type { Session } from '../session';
import type { ClientTerrain } from '../options';
import type { Warn } from '../warnings';
import { describe } from './describe';

/** m: the highest mountains are below it, and every radius above. */
const HIGHEST = 50_000;
/** Unit directions in a body's axes at which a terrain is tried. */
const DIRECTIONS = [
  [0, 1, 0],
  [0.6, 0, 0.8],
  [0, -0.6, 0.8],
  [-0.48, 0.6, 0.64],
] as const;

/** Warns of terrains that were handed in and are not used, and of heights that cannot be. */
export function checkTerrains({ warn, options, config, sim }: Session): void {
  const given = Object.keys(options.terrains ?? {});
  const { terrain } = config;
  if (given.length > 0 && !given.includes(terrain)) {
    const message = `The terrains ${given.join(', ')} are not used: the world has ${terrain}. Set defaults.terrain to one of their names, or have the hello tell it.`;
    warn('terrain-unused', message, { terrain, given });
  }
  for (const { name } of sim.world.bodies)
    for (const [x, y, z] of DIRECTIONS) {
      const height: unknown = sim.world.terrainHeight(name, x, y, z);
      if (typeof height !== 'number' || Math.abs(height) <= HIGHEST) continue;
      const message = `The terrain ${terrain} has ${height} m on ${name}: return the height above the body's radius in metres, not the radius.`;
      warn('terrain-too-high', message, { terrain, body: name, height });
    }
}

/** The terrain of a caller: what it answers that is no height, or throws, counts as not loaded, and is warned of. */
export function guardTerrain(terrain: ClientTerrain, name: string, warn: Warn): ClientTerrain {
  // One of the library's own, read without boxing.
  if ('inPlace' in terrain) return terrain;
  return (bodyName, nx, ny, nz) => {
    let height: unknown = null;
    try {
      height = terrain(bodyName, nx, ny, nz);
      if (typeof height === 'number' && height - height === 0) return height;
    } catch (error) {
      height = error;
    }
    if (height === null) return null;
    const message = `The terrain ${name} answered ${describe(height)} for ${bodyName}: return metres above the body's radius, or null where it is not loaded. It counts as not loaded.`;
    warn('terrain-unusable', message, {
      terrain: name,
      body: bodyName,
      direction: [nx, ny, nz],
      value: height,
    });
    return null;
  };
}
