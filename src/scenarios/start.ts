import type { Scenario } from './scenario';

/** The default start of scenarios. */
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
  // LANDING_SITE of hillsTerrain, level within 350 m.
  site: { latitude: 28.6854, longitude: 43.15239 },
  inputs: [],
};

/** At rest and upright on the ground. */
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

/** Settings in which a ship keeps its attitude at touchdown, so that it can topple. */
export const KEPT = { touchdownAttitude: 'kept' } as const;
