import { BODY_ATTITUDE, BODY_STRIDE, POSITION, REFERENCE_BODY, type World } from '../../dynamics';
import { quaternion, rotateBack, take, vector } from '../drawn/rotation';

/** Ground that the client has not loaded: its terrain returns null or no finite height. */

/** Whether the ground below the row at 0 in `row` is known; `bodies` are the rows at its tick. */
export function knowsGround(row: Float64Array, bodies: Float64Array, world: World): boolean {
  const index = row[REFERENCE_BODY]!;
  take(body, bodies, index * BODY_STRIDE + BODY_ATTITUDE);
  take(place, row, POSITION);
  rotateBack(place, body, place);
  const distance = Math.hypot(place[0]!, place[1]!, place[2]!);
  const height: unknown = world.terrainHeight(
    world.bodies[index]!.name,
    place[0]! / distance,
    place[1]! / distance,
    place[2]! / distance,
  );
  return Number.isFinite(height);
}

/** The world with its ground out of reach of flying ships. */
export function withoutGround(world: World): World {
  const radii = new Map(world.bodies.map(({ name, radius }) => [name, radius]));
  return { ...world, terrainHeight: (name) => -radii.get(name)! / 2 };
}

const body = quaternion();
const place = vector();
