import { cosineOfDegrees, sineOfDegrees, type Vec3 } from '../../dynamics';
import type { StagedScenario } from '../scenario';
import type { Mission, Pad } from './mission';

const DEGREES_PER_RADIAN = 180 / 3.141592653589793;

/** Where a mission's pads lie, body axes, m from the body's centre: on the ground. */
export function padPlaces(mission: Mission, staged: StagedScenario): Vec3[] {
  return mission.pads.map((pad) => padPlace(pad, staged));
}

function padPlace({ east, north }: Pad, { scenario, body, terrainHeight }: StagedScenario): Vec3 {
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
