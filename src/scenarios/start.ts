import type { Scenario } from './scenario';

/** Where a scenario begins unless it says otherwise. */
export const START: Pick<
  Scenario,
  'body' | 'shipClass' | 'settings' | 'terrain' | 'tickRate' | 'timeScale' | 'site' | 'inputs'
> = {
  body: 'Luna',
  shipClass: 'planetary_lander',
  settings: {},
  terrain: 'hills',
  // The game's defaults.
  tickRate: 1,
  timeScale: 1,
  // LANDING_SITE of the hills, level to 350 m around.
  site: { latitude: 28.6854, longitude: 43.15239 },
  inputs: [],
};

export const STILL: Scenario['initial'] = {
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

export const KEPT = { touchdownAttitude: 'kept' } as const;
