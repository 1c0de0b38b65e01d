import type { Scenario } from '../scenario';
import { START, STILL } from '../start';

/** Landings on slopes and ridges of the Moon. */
export const HILLS: readonly Scenario[] = [
  {
    ...START,
    name: 'stands-on-a-slope',
    title: 'Stands on a slope',
    about:
      'Surface normal from the terrain: set down on a slope of 22°, the ship stays, flush with the ground.',
    settings: { surfaceNormal: 'terrain' },
    site: { latitude: 28.32239, longitude: 43.08088 },
    initial: { ...STILL, height: 1, velocity: [0, 0, -0.3] },
    duration: 10,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'too-steep',
    title: 'Too steep',
    about:
      'Surface normal from the terrain: a slope of 44° is past the footprint, and the ship topples downhill.',
    settings: { surfaceNormal: 'terrain' },
    site: { latitude: 29.05792, longitude: 42.92848 },
    initial: { ...STILL, height: 1, velocity: [0, 0, -0.3] },
    duration: 16,
    expected: ['ship.contact', 'ship.tipped'],
  },
  {
    ...START,
    name: 'up-a-slope',
    title: 'Up a slope',
    about:
      'Hills with a radial surface normal: slides uphill for twenty seconds and lands upright on the slope.',
    site: { latitude: 28.56173, longitude: 42.94376 },
    initial: { ...STILL, height: 1.5, velocity: [15.5, 9.2, -1], heading: 59 },
    duration: 26,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'over-the-edge',
    title: 'Over the edge',
    about: 'Slides over a crest: the ground drops away, the ship flies and touches sixty metres lower.',
    site: { latitude: 28.55263, longitude: 42.97744 },
    initial: { ...STILL, height: 1.5, velocity: [-5.2, -10.8, -1], heading: 206 },
    duration: 20,
    expected: ['ship.contact', 'ship.contact', 'ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'into-a-ridge',
    title: 'Into a ridge',
    about:
      'Flies level at 70 m/s into rising ground and crashes: it approaches the ground faster than 50 m/s.',
    site: { latitude: 28.45651, longitude: 43.23295 },
    initial: { ...STILL, height: 85, velocity: [6, -69.7, 0], heading: 175 },
    duration: 6,
    expected: ['ship.destroyed'],
  },
];
