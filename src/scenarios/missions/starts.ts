import type { Scenario } from '../scenario';

/** The level ground of the hills, 350 m around. */
const LEVEL_SITE: Scenario['site'] = { latitude: 28.6854, longitude: 43.15239 };

/** Upright and still, with fuel for a while. */
export const RESTING: Scenario['initial'] = {
  height: 0,
  velocity: [0, 0, 0],
  tilt: 0,
  leanTo: 0,
  heading: 0,
  spin: [0, 0, 0],
  fuelFraction: 0.6,
  surfaceContactState: '',
  contactImpactSpeed: 0,
};

/** In flight over the pad. */
export const PILOTED: Scenario['initial'] = { ...RESTING, height: 200, fuelFraction: 0.25 };

/** A mission's scenario. It flies until the pilot is done: its duration is the longest flight that is scored. */
export function missionStart(
  name: string,
  title: string,
  changes: Partial<Scenario> & Pick<Scenario, 'about' | 'initial'>,
): Scenario {
  return {
    name,
    title,
    body: 'Luna',
    shipClass: 'planetary_lander',
    settings: {},
    terrain: 'hills',
    tickRate: 1,
    timeScale: 1,
    site: LEVEL_SITE,
    inputs: [{ at: 0, controls: { attitudeHold: true } }],
    duration: 900,
    expected: [],
    ...changes,
  };
}
