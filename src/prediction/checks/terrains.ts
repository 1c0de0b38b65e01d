import type { Session } from '../session';

/** m: above the highest mountains, and below every body's radius. */
const HIGHEST = 50_000;
/** Unit directions in the body's axes in which a terrain is sampled. */
const DIRECTIONS = [
  [0, 1, 0],
  [0.6, 0, 0.8],
  [0, -0.6, 0.8],
  [-0.48, 0.6, 0.64],
] as const;

/** Warns of terrains that were passed but are not used, and of impossible heights. */
export function checkTerrains({ warn, options, config, sim }: Session): void {
  const given = Object.keys(options.terrains ?? {});
  const { terrain } = config;
  if (given.length > 0 && !given.includes(terrain)) {
    const message = `The terrains ${given.join(', ')} are not used: the world's terrain is ${terrain}. Set defaults.terrain to one of their names, or name one in the hello.`;
    warn('terrain-unused', message, { terrain, given });
  }
  for (const { name } of sim.world.bodies)
    for (const [x, y, z] of DIRECTIONS) {
      const height: unknown = sim.world.terrainHeight(name, x, y, z);
      if (typeof height !== 'number' || Math.abs(height) <= HIGHEST) continue;
      const message = `The terrain ${terrain} returned ${height} m on ${name}: return the height above the body's radius in metres, not the radius.`;
      warn('terrain-too-high', message, { terrain, body: name, height });
    }
}
