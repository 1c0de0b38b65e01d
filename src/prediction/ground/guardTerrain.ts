import type { ClientTerrain } from '../options';
import type { Warn } from '../warnings';
import { describe } from '../checks/describe';

/** Wraps a caller's terrain: where it returns no height, or throws, the ground counts as not loaded, with a warning. */
export function guardTerrain(terrain: ClientTerrain, name: string, warn: Warn): ClientTerrain {
  // A terrain of the library, which is read without boxing.
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
    warn(
      'terrain-unusable',
      `The terrain ${name} returned ${describe(height)} for ${bodyName}: return metres above the body's radius, or null where it is not loaded. It counts as not loaded.`,
      { terrain: name, body: bodyName, direction: [nx, ny, nz], value: height },
    );
    return null;
  };
}
