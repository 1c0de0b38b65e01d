import type { SpawnOrder } from '../authority';
import { normalNoise, createRandom } from './network/random';
import type { Scenario, LoadedScenario } from './scenario';
import { toBodyRelative } from './site';

/**
 * Ships of other players around a scenario's site: its initial state, with position,
 * height, speed and heading varied at random by a seed.
 * @param count 0 … 9,999
 */
export function fleetOrders(loaded: LoadedScenario, count: number, seed: number): SpawnOrder[] {
  const rng = createRandom(seed);
  const { body, shipClass, terrainHeight, scenario } = loaded;
  return Array.from({ length: count }, (_, i) => {
    const { initial, site } = scattered(scenario, body.radius, i, rng);
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
/** Distance between ships, m: twice the largest class's footprint, and room to slide. */
const SPACING = 40;
const DEGREES_PER_RADIAN = 180 / 3.141592653589793;

/** The i-th position on a square grid around the site, which itself stays free. */
function scattered(
  scenario: Scenario,
  radius: number,
  i: number,
  rng: () => number,
): Pick<Scenario, 'initial' | 'site'> {
  const { initial, site } = scenario;
  const [column, row] = spiral(i + 1);
  const degrees = (SPACING / radius) * DEGREES_PER_RADIAN;
  const sideways = () => initial.velocity[0] * 0.3 * normalNoise(rng) + normalNoise(rng);
  return {
    site: { latitude: site.latitude + row * degrees, longitude: site.longitude + column * degrees },
    initial: {
      ...initial,
      height: initial.height === 0 ? 0 : initial.height * (1 + rng()),
      velocity:
        initial.height === 0
          ? initial.velocity
          : [initial.velocity[0] + sideways(), initial.velocity[1] + sideways(), initial.velocity[2]],
      heading: 360 * rng(),
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
