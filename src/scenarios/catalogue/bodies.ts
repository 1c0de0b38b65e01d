import type { Scenario } from '../scenario';
import { KEPT, START, STILL } from '../start';

/** Landings on Earth, Mars and Phobos. */
export const OTHER_BODIES: readonly Scenario[] = [
  {
    ...START,
    name: 'settle-earth',
    title: 'Settle on Earth',
    about: 'Settles as on the Moon, under six times the gravity, on ground that moves at 408 m/s.',
    body: 'Earth',
    initial: { ...STILL, height: 1.5, velocity: [0, 0, -1], tilt: 3, leanTo: 200 },
    duration: 6,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'bounce-earth',
    title: 'Bounce on Earth',
    about: 'Touches at 30 m/s while moving along the ground at 5 m/s.',
    body: 'Earth',
    initial: { ...STILL, height: 15, velocity: [5, 0, -25] },
    duration: 10,
    expected: ['ship.contact', 'ship.contact', 'ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'slide-mars',
    title: 'Slide on Mars',
    about: 'A frigate slides under 3.7 m/s².',
    body: 'Mars',
    shipClass: 'fast_frigate',
    initial: { ...STILL, height: 2, velocity: [-6, 12, -3], heading: 333 },
    duration: 15,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'topple-mars',
    title: 'Topple on Mars',
    about:
      'Keeps its touchdown attitude: a hauler at 38° of tilt, a degree past the point of no return, topples.',
    body: 'Mars',
    shipClass: 'cargo_hauler',
    settings: KEPT,
    initial: { ...STILL, height: 1, velocity: [0, 0, -1], tilt: 38, leanTo: 300 },
    duration: 25,
    expected: ['ship.contact', 'ship.tipped'],
  },
  {
    ...START,
    name: 'settle-phobos',
    title: 'Settle on Phobos',
    about: 'Gravity of 6 mm/s²: a touch at 2 m/s settles without leaving the ground again.',
    body: 'Phobos',
    initial: { ...STILL, height: 4, velocity: [0.6, 0.2, -2], tilt: 5, leanTo: 70 },
    duration: 15,
    expected: ['ship.contact', 'ship.landed'],
  },
];
