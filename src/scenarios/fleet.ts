import type { SpawnOrder } from '../authority';
import { bell, createDice } from './network/random';
import type { Scenario, StagedScenario } from './scenario';
import { toBodyRelative } from './site';

/**
 * Ships of other players around a scenario's site: its own initial state, strewn by a seed over place, height, speed and tilt.
 * @param count 0 … 9,999
 */
export function fleetOrders(staged: StagedScenario, count: number, seed: number): SpawnOrder[] {
  const dice = createDice(seed);
  const { body, shipClass, terrainHeight, scenario } = staged;
  return Array.from({ length: count }, (_, i) => {
    const { initial, site } = strewn(scenario, body.radius, i, dice);
    const craft = { ...initial, shipClass, fuel: initial.fuelFraction * shipClass.fuelCapacity };
    return {
      shipId: `other-${i + 1}`,
      playerId: `player-${i + 1}`,
      name: `${NAMES[i % NAMES.length]!} ${i + 1}`,
      ship: toBodyRelative(initial, craft, { body, site, terrainHeight }),
    };
  });
}

const NAMES = ['Heron', 'Kestrel', 'Wagtail', 'Curlew', 'Dunnock', 'Plover'];
/** Between ships, m: twice the largest class's legs and room to slide. */
const APART = 40;
const DEGREES_PER_RADIAN = 180 / 3.141592653589793;

/** Row by row on a square grid around the site, the site itself left free. */
function strewn(
  scenario: Scenario,
  radius: number,
  i: number,
  dice: () => number,
): Pick<Scenario, 'initial' | 'site'> {
  const { initial, site } = scenario;
  const [column, row] = spiral(i + 1);
  const degrees = (APART / radius) * DEGREES_PER_RADIAN;
  const sideways = () => initial.velocity[0] * 0.3 * bell(dice) + bell(dice);
  return {
    site: { latitude: site.latitude + row * degrees, longitude: site.longitude + column * degrees },
    initial: {
      ...initial,
      height: initial.height === 0 ? 0 : initial.height * (1 + dice()),
      velocity:
        initial.height === 0
          ? initial.velocity
          : [initial.velocity[0] + sideways(), initial.velocity[1] + sideways(), initial.velocity[2]],
      heading: 360 * dice(),
    },
  };
}

/** The i-th cell of a square spiral around cell 0. */
function spiral(i: number): [number, number] {
  const ring = Math.ceil((Math.sqrt(i + 1) - 1) / 2);
  const side = 2 * ring;
  const first = (side - 1) * (side - 1);
  const along = i - first;
  const leg = Math.floor(along / side);
  const k = (along % side) + 1 - ring;
  if (leg === 0) return [ring, k];
  if (leg === 1) return [-k, ring];
  return leg === 2 ? [-ring, -k] : [k, -ring];
}
