import type { Mission } from './mission';
import { STILL } from '../start';
import { missionStart, PILOTED } from './starts';

const LESSON = { isLesson: true, night: false, parSeconds: 60, parFuel: 300 } as const;

/** The flight school: six short lessons of one skill each. */
export const LESSONS: readonly Mission[] = [
  {
    ...LESSON,
    scenario: missionStart('school-hover', 'Lesson 1: hover', {
      about: 'At the hover mark, thrust equals weight.',
      initial: { ...PILOTED, height: 60, velocity: [0, 0, -4] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.07, attitudeHold: true } }],
    }),
    goal: 'Stay between 20 and 60 m for ten seconds.',
    how: 'Set the lever to the hover mark: {throttleUp} for more thrust, {throttleDown} for less.',
    done: { kind: 'hover', low: 20, high: 60, seconds: 10 },
    pads: [{ east: 0, north: 0, radius: 15 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-translate', 'Lesson 2: translate', {
      about: 'Thrusters push the ship sideways while it stays upright.',
      initial: { ...PILOTED, height: 40 },
      inputs: [{ at: 0, controls: { thrustLevel: 0.08, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Fly over the beacon at less than 3 m/s.',
    how: 'Move away with {translateYPlus}, towards you with {translateYMinus}, left with {translateXMinus} and right with {translateXPlus}. Push the other way to stop.',
    done: { kind: 'reach', below: 120, speed: 3 },
    pads: [{ east: 30, north: 10, radius: 12 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-land', 'Lesson 3: land', {
      about: 'Slow down, touch down softly, cut the engine.',
      initial: { ...PILOTED, height: 50, velocity: [0, 0, -3] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.09, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land by the beacon, softer than 2 m/s.',
    how: 'Follow AIM: {throttleUp} when too fast, {throttleDown} when too slow. Press {throttleCut} to cut the engine at touchdown.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 25 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-slope', 'Lesson 4: stand on a slope', {
      about: 'On a slope of 15°, friction holds a ship that touches down slowly.',
      settings: { surfaceNormal: 'terrain' },
      site: { latitude: 28.64978, longitude: 42.70355 },
      initial: { ...PILOTED, height: 25, velocity: [0, 0, -2] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.086, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land on the slope and stay there.',
    how: 'Follow AIM without drifting. Press {throttleCut} to cut the engine at touchdown.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 30 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-right', 'Lesson 5: right a fallen ship', {
      about: 'RCS rotation turns a fallen ship back onto its legs.',
      settings: { touchdownAttitude: 'kept' },
      initial: { ...STILL, height: 3, velocity: [0, 0, -1], tilt: 42, leanTo: 90 },
    }),
    goal: 'Right the ship until the display says LANDED.',
    how: 'Hold the key shown on the display. Release it below the angle shown.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 60 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-phobos', 'Lesson 6: land on Phobos', {
      about: 'The ship weighs almost nothing: the thrusters push it down.',
      body: 'Phobos',
      initial: { ...PILOTED, height: 20 },
      inputs: [{ at: 0, controls: { attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land by the beacon on Phobos.',
    how: 'Push down briefly with {translateZMinus}, and slow down with {translateZPlus} before touchdown.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 25 }],
  },
];
