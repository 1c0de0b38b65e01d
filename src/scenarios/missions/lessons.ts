import type { Mission } from './mission';
import { STILL } from '../start';
import { missionStart, PILOTED } from './starts';

const LESSON = { isLesson: true, night: false, parSeconds: 60, parFuel: 300 } as const;

/** The flight school: six short steps, each one thing to learn. */
export const LESSONS: readonly Mission[] = [
  {
    ...LESSON,
    scenario: missionStart('school-hover', 'Lesson 1: hover', {
      about: 'The engine carries the weight at the hover mark.',
      initial: { ...PILOTED, height: 60, velocity: [0, 0, -4] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.1, attitudeHold: true } }],
    }),
    goal: 'Stay between 20 and 60 m for five seconds.',
    how: 'Set the lever to the hover mark: {throttleUp} for more thrust, {throttleDown} for less.',
    done: { kind: 'hover', low: 20, high: 60, seconds: 5 },
    pads: [{ east: 0, north: 0, radius: 15 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-translate', 'Lesson 2: translate', {
      about: 'Thrusters push the ship sideways while it stays upright.',
      initial: { ...PILOTED, height: 40 },
      inputs: [{ at: 0, controls: { thrustLevel: 0.105, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Fly over the beacon, slower than 3 m/s.',
    how: 'Push with {translateYPlus} away, {translateYMinus} towards you, {translateXMinus} left and {translateXPlus} right. Push back in time to stop.',
    done: { kind: 'reach', below: 120, speed: 3 },
    pads: [{ east: 30, north: 10, radius: 12 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-land', 'Lesson 3: land', {
      about: 'Slow down, touch softly, cut the engine.',
      initial: { ...PILOTED, height: 50, velocity: [0, 0, -3] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.1, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land by the beacon, softer than 2 m/s.',
    how: 'Follow AIM: {throttleUp} when too fast, {throttleDown} when too slow. Cut the engine with {throttleCut} at the touch.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 25 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-slope', 'Lesson 4: stand on a slope', {
      about: 'A slope of 15°: touch slowly, and friction holds the ship.',
      settings: { surfaceNormal: 'terrain' },
      site: { latitude: 28.64978, longitude: 42.70355 },
      initial: { ...PILOTED, height: 25, velocity: [0, 0, -2] },
      inputs: [{ at: 0, controls: { thrustLevel: 0.1, attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land on the slope and stay.',
    how: 'Come down slower than 1 m/s with no drift, then cut the engine with {throttleCut}.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 30 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-right', 'Lesson 5: right a fallen ship', {
      about: 'The ship lies on its side: turn it up again.',
      settings: { touchdownAttitude: 'kept' },
      initial: { ...STILL, height: 3, velocity: [0, 0, -1], tilt: 42, leanTo: 90 },
    }),
    goal: 'Stand the ship up until it says LANDED.',
    how: 'Hold the key that the display names. Release it below the angle shown, then press {rateDamping}.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 60 }],
  },
  {
    ...LESSON,
    scenario: missionStart('school-phobos', 'Lesson 6: land on Phobos', {
      about: 'Almost no weight: the thrusters push the ship down.',
      body: 'Phobos',
      initial: { ...PILOTED, height: 20 },
      inputs: [{ at: 0, controls: { attitudeMode: 'radial', attitudeHold: true } }],
    }),
    goal: 'Land by the beacon on Phobos.',
    how: 'Push down with {translateZMinus} for a moment, and slow down with {translateZPlus} before the ground.',
    done: { kind: 'land' },
    pads: [{ east: 0, north: 0, radius: 25 }],
  },
];
