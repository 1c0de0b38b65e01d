import type { Scenario } from '../scenario';
import { START, STILL } from '../start';

/** Engines, wheels, RCS and attitude modes. */
export const ACTUATORS: readonly Scenario[] = [
  {
    ...START,
    name: 'freighter-hold',
    title: 'Freighter, held upright',
    about: 'A hauler descends on its engine in attitude mode radial and is turned while it settles.',
    shipClass: 'cargo_hauler',
    initial: { ...STILL, height: 12, velocity: [1, -0.5, -4], tilt: 4, leanTo: 45 },
    inputs: [
      { at: 0, controls: { thrustLevel: 0.5, attitudeMode: 'radial' } },
      { at: 2.6, controls: { rotationInput: [0.3, -0.2, 0.1] } },
      { at: 3.6, controls: { rotationInput: [0, 0, 0], thrustLevel: 0 } },
    ],
    duration: 15,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'out-of-fuel',
    title: 'Out of fuel',
    about: 'The engine brakes until the fuel runs out, twenty-four metres above the ground.',
    initial: { ...STILL, height: 30, velocity: [0, 0, -8], fuelFraction: 0.004 },
    inputs: [{ at: 0.5, controls: { thrustLevel: 0.5, attitudeMode: 'radial' } }],
    duration: 15,
    expected: ['ship.contact', 'ship.landed'],
  },
  {
    ...START,
    name: 'pointing',
    title: 'Pointing',
    about: 'Goes through every attitude mode, high above the Moon.',
    shipClass: 'fast_frigate',
    initial: { ...STILL, height: 3000, velocity: [60, 20, 5], tilt: 30, leanTo: 10, spin: [0.05, 0, 0.02] },
    inputs: [
      { at: 0, controls: { attitudeHold: true } },
      { at: 5, controls: { attitudeMode: 'prograde' } },
      { at: 10, controls: { attitudeMode: 'retrograde' } },
      { at: 16, controls: { attitudeMode: 'normal' } },
      { at: 22, controls: { attitudeMode: 'antinormal' } },
      { at: 28, controls: { attitudeMode: 'radial' } },
      { at: 34, controls: { attitudeMode: 'antiradial' } },
      { at: 40, controls: { attitudeMode: 'hold', targetAttitude: [0.5, 0.5, 0.5, 0.5] } },
      { at: 46, controls: { attitudeMode: 'surface_retrograde' } },
    ],
    duration: 54,
    expected: [],
  },
  {
    ...START,
    name: 'wheels-fill',
    title: 'Wheels saturate',
    about:
      'A frigate with the stick held: its wheels saturate after ten seconds, and RCS alone keeps turning it.',
    shipClass: 'fast_frigate',
    initial: { ...STILL, height: 3000, velocity: [0, 0, 0] },
    inputs: [
      { at: 0, controls: { rotationInput: [0.05, 0, 0] } },
      { at: 14, controls: { rotationInput: [0, 0, 0], attitudeHold: true } },
    ],
    duration: 24,
    expected: [],
  },
];
