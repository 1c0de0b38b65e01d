import { LESSONS } from './lessons';
import type { Scenario } from '../scenario';
import { SCENARIOS } from '../catalogue';
import type { Mission } from './mission';
import { STILL } from '../start';
import { missionStart, PILOTED } from './starts';

const SCORED = { isLesson: false, night: false, how: '', done: { kind: 'land' } } as const;
/** Slopes matter: contact forces act along the terrain's normal. */
const ON_THE_GROUND = { surfaceNormal: 'terrain' } as const;
const UPRIGHT = { attitudeMode: 'radial', attitudeHold: true } as const;

/** The missions, easiest first. The page opens with the first. */
export const MISSIONS: readonly Mission[] = [
  {
    ...SCORED,
    scenario: missionStart('first-landing', 'First landing', {
      about: 'Two hundred metres above level ground, straight over the beacon.',
      initial: { ...PILOTED, velocity: [0, 0, -6] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.078, attitudeHold: true } }],
    }),
    goal: 'Land by the beacon, softer than 2 m/s.',
    touchLimit: 2,
    pads: [{ east: 0, north: 0, radius: 30 }],
    parSeconds: 60,
    parFuel: 250,
  },
  {
    ...SCORED,
    scenario: missionStart('sidestep', 'Sidestep', {
      about: 'The pad is eighty metres away: fly there first.',
      initial: { ...PILOTED, height: 120, velocity: [0, 0, -2] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.085 } }],
    }),
    goal: 'Fly to the beacon eighty metres away and land by it.',
    pads: [{ east: 70, north: 40, radius: 20 }],
    parSeconds: 80,
    parFuel: 400,
  },
  {
    ...SCORED,
    scenario: missionStart('long-approach', 'Long approach', {
      about: 'Approaching from the east at 40 m/s and 600 m up: brake, turn upright and land.',
      initial: { ...PILOTED, height: 600, velocity: [-40, 0, -8], tilt: 30, leanTo: 90 },
    }),
    goal: 'Brake from 40 m/s and land by the beacon.',
    pads: [{ east: -900, north: 0, radius: 30 }],
    parSeconds: 110,
    parFuel: 600,
  },
  {
    ...SCORED,
    scenario: missionStart('crater-floor', 'Crater floor', {
      about: 'A pit with walls all around.',
      settings: ON_THE_GROUND,
      site: { latitude: 28.77246, longitude: 43.00127 },
      initial: { ...PILOTED, height: 180, velocity: [4, -3, -5] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.08 } }],
    }),
    goal: 'Land on the floor of the crater.',
    pads: [{ east: 0, north: 0, radius: 25 }],
    parSeconds: 75,
    parFuel: 350,
  },
  {
    ...SCORED,
    scenario: missionStart('crater-rim', 'Crater rim', {
      about: 'A knoll forty metres above its surroundings: next to it, the ground drops away.',
      settings: ON_THE_GROUND,
      site: { latitude: 28.81995, longitude: 43.32381 },
      initial: { ...PILOTED, height: 150, velocity: [3, 5, -4] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.08 } }],
    }),
    goal: 'Land on top of the rim.',
    pads: [{ east: 10, north: 10, radius: 20 }],
    parSeconds: 75,
    parFuel: 350,
  },
  {
    ...SCORED,
    scenario: missionStart('ridge', 'On the ridge', {
      about: 'A ridge eight hundred metres above the plain, hardly wider than the pad.',
      settings: ON_THE_GROUND,
      site: { latitude: 28.43411, longitude: 42.95165 },
      initial: { ...PILOTED, height: 140, velocity: [-6, 2, -3], tilt: 10, leanTo: 200 },
    }),
    goal: 'Land on the ridge. Both sides are steep.',
    pads: [{ east: -10, north: 0, radius: 15 }],
    parSeconds: 75,
    parFuel: 350,
  },
  {
    ...SCORED,
    night: true,
    scenario: missionStart('night', 'Night landing', {
      about: 'The ground is dark: rely on the instruments and the beacon.',
      initial: { ...PILOTED, height: 250, velocity: [5, 3, -6] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.08 } }],
    }),
    goal: 'Land by the beacon on instruments.',
    pads: [{ east: 60, north: 40, radius: 25 }],
    parSeconds: 100,
    parFuel: 450,
  },
  {
    ...SCORED,
    scenario: missionStart('forty-seconds', 'Fuel for forty seconds', {
      about: 'Fuel for forty seconds of hover: fall first, brake late.',
      initial: { ...PILOTED, height: 350, velocity: [0, 0, -5], fuelFraction: 0.0215 },
    }),
    goal: 'Land by the beacon before the tank is empty.',
    pads: [{ east: 0, north: 0, radius: 30 }],
    parSeconds: 45,
    parFuel: 140,
  },
  {
    ...SCORED,
    scenario: missionStart('half-engine', 'Half thrust', {
      about: 'Over Earth at half thrust, a tenth more than the weight.',
      body: 'Earth',
      engineShare: 0.5,
      initial: { ...PILOTED, height: 120, velocity: [0, 0, -4], fuelFraction: 0.15 },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.88 } }],
    }),
    goal: 'Land by the beacon with half the thrust.',
    pads: [{ east: 0, north: 0, radius: 25 }],
    parSeconds: 35,
    parFuel: 900,
  },
  {
    ...SCORED,
    scenario: missionStart('heavy-hauler', 'Heavy hauler', {
      about: 'A hundred and thirty tonnes, slow to turn.',
      shipClass: 'cargo_hauler',
      initial: { ...PILOTED, height: 250, velocity: [-4, 3, -6], fuelFraction: 0.5 },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.5 } }],
    }),
    goal: 'Land the hauler by the beacon.',
    pads: [{ east: -30, north: 20, radius: 30 }],
    parSeconds: 100,
    parFuel: 200,
  },
  {
    ...SCORED,
    scenario: missionStart('fast-rotator', 'Fast rotator', {
      about: 'Phobos with a day of three hours: its rotation nearly throws the ship off.',
      body: 'Phobos',
      spinFactor: 2.6,
      initial: { ...PILOTED, height: 40, velocity: [0.5, 0, 0] },
      inputs: [{ at: 0, controls: UPRIGHT }],
    }),
    goal: 'Land on a fast-spinning moon and stay on the ground.',
    pads: [{ east: 10, north: 0, radius: 25 }],
    parSeconds: 80,
    parFuel: 60,
  },
  {
    ...SCORED,
    scenario: missionStart('steep-slope', 'Slope of 25°', {
      about: 'A hillside as steep as a roof: friction holds a ship that touches down slowly.',
      settings: ON_THE_GROUND,
      site: { latitude: 28.48951, longitude: 42.71031 },
      initial: { ...PILOTED, height: 100, velocity: [1, 1, -3] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.09 } }],
    }),
    goal: 'Land on the slope without sliding off the pad.',
    pads: [{ east: 0, north: 0, radius: 20 }],
    slope: 25,
    parSeconds: 75,
    parFuel: 350,
  },
  {
    ...SCORED,
    scenario: missionStart('tumble', 'Tumble', {
      about: 'Tumbling at 20°/s, five hundred metres up.',
      initial: {
        ...PILOTED,
        height: 500,
        velocity: [3, -2, -4],
        tilt: 50,
        leanTo: 120,
        spin: [0.3, 0.15, 0.1],
      },
      inputs: [],
    }),
    goal: 'Stop the tumble and land by the beacon.',
    pads: [{ east: 20, north: -20, radius: 40 }],
    parSeconds: 90,
    parFuel: 450,
  },
  {
    ...SCORED,
    scenario: missionStart('relay', 'Relay', {
      about: 'Three pads, one tank.',
      initial: { ...PILOTED, height: 80, velocity: [0, 0, -2] },
      inputs: [{ at: 0, controls: { ...UPRIGHT, thrustLevel: 0.09 } }],
    }),
    goal: 'Land on three pads, one after the other.',
    pads: [
      { east: 0, north: 0, radius: 25 },
      { east: 110, north: 40, radius: 20 },
      { east: 60, north: 150, radius: 15 },
    ],
    parSeconds: 240,
    parFuel: 1300,
  },
];

/** No goal and no score: a full tank, and the ship waits for its pilot. */
export const FREE_FLIGHT: Scenario = missionStart('free-flight', 'Free flight', {
  about: 'No goal: fly where you like.',
  initial: { ...STILL, fuelFraction: 1, surfaceContactState: 'landed' },
});

/** The mission or lesson with this scenario name, or null. */
export function findMission(scenario: string): Mission | null {
  return [...MISSIONS, ...LESSONS].find((mission) => mission.scenario.name === scenario) ?? null;
}

/** The scenario with this name, of the catalogue, of a mission or of free flight, or null. */
export function findScenario(name: string): Scenario | null {
  return (
    [...SCENARIOS, FREE_FLIGHT].find((scenario) => scenario.name === name) ??
    findMission(name)?.scenario ??
    null
  );
}
