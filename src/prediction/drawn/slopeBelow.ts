import { flatTerrain, LEG_RADIUS } from '../../dynamics';
import { vector } from './rotation';
import type { ViewContext } from './viewContext';
import type { ShipView } from './view';

/** The slope is computed if the ship's feet are closer to the ground than this, m. */
const SLOPE_HEIGHT = 100;

/** The ground's own normal below a ship's feet, in the body's axes; null where the normal is radial or the ground is far. */
export function slopeBelow(out: ShipView, { world, normal, distance }: ViewContext): Float64Array | null {
  const feet = distance[0]! - out.groundRadius - out.groundContactOffset;
  const { terrainNormals, settings } = world;
  if (terrainNormals === null || settings.surfaceNormal !== 'terrain' || feet > SLOPE_HEIGHT) return null;
  const { name, radius } = world.bodies[out.body]!;
  under.bodyName = name;
  under.radius = radius;
  under.legRadius = out.shipClass.constants[LEG_RADIUS]!;
  under.terrainHeight = world.terrainHeight;
  terrainNormals.writeGroundNormal(slope, normal, under);
  return slope;
}

const slope = vector();
const under = { bodyName: '', radius: 1, legRadius: 1, terrainHeight: flatTerrain };
