import { cosineOfDegrees, sineOfDegrees, type Vec3 } from '../../dynamics';
import type { LoadedScenario } from '../scenario';
import type { Mission, Pad } from './mission';

const DEGREES_PER_RADIAN = 180 / 3.141592653589793;

/** Positions of a mission's pads on the ground, m from the body's centre, body axes. */
export function padPlaces(mission: Mission, loaded: LoadedScenario): Vec3[] {
  return mission.pads.map((pad) => padPlace(pad, loaded));
}

function padPlace({ east, north }: Pad, { scenario, body, terrainHeight }: LoadedScenario): Vec3 {
  const degrees = DEGREES_PER_RADIAN / body.radius;
  const latitude = scenario.site.latitude + north * degrees;
  const longitude = scenario.site.longitude + (east * degrees) / cosineOfDegrees(scenario.site.latitude);
  const level = cosineOfDegrees(latitude);
  const direction: Vec3 = [
    level * sineOfDegrees(longitude),
    sineOfDegrees(latitude),
    level * cosineOfDegrees(longitude),
  ];
  const reach = body.radius + terrainHeight(body.name, ...direction);
  return [direction[0] * reach, direction[1] * reach, direction[2] * reach];
}
