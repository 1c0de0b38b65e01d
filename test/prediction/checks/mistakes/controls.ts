/** Mistakes in controls: the mistake, the expected code, and a part of the expected message. */
import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import { type Mistake, flown } from './given';

export const CONTROLS: readonly Mistake[] = [
  [
    'thrust_level',
    'unknown-control',
    /mean thrustLevel/,
    () => flown({ ...NEUTRAL_CONTROLS, thrust_level: 1 }),
  ],
  ['part of the controls', 'controls-ignored', /translationInput/, () => flown({ thrustLevel: 1 })],
  ['a number as controls', 'controls-ignored', /object/, () => flown(1)],
  ['percent', 'controls-clamped', /not percent/, () => flown({ ...NEUTRAL_CONTROLS, thrustLevel: 50 })],
  ['throttle', 'unknown-control', /Known:.*thrustLevel/, () => flown({ ...NEUTRAL_CONTROLS, throttle: 1 })],
  [
    'pitch, yaw and roll',
    'controls-ignored',
    /rotationInput/,
    () => flown({ ...NEUTRAL_CONTROLS, rotationInput: { pitch: 1, yaw: 0, roll: 0 } }),
  ],
  [
    'two of three axes',
    'controls-ignored',
    /rotationInput/,
    () => flown({ ...NEUTRAL_CONTROLS, rotationInput: [1, 0] }),
  ],
  [
    'a Float32Array for axes',
    'controls-ignored',
    /lists of numbers/,
    () => flown({ ...NEUTRAL_CONTROLS, rotationInput: new Float32Array(3) }),
  ],
  [
    'a string for the throttle',
    'controls-ignored',
    /thrustLevel/,
    () => flown({ ...NEUTRAL_CONTROLS, thrustLevel: '1' }),
  ],
  [
    'NaN for the throttle',
    'controls-ignored',
    /thrustLevel/,
    () => flown({ ...NEUTRAL_CONTROLS, thrustLevel: NaN }),
  ],
  ['1 for true', 'controls-ignored', /attitudeHold/, () => flown({ ...NEUTRAL_CONTROLS, attitudeHold: 1 })],
  ['undefined for null', 'controls-ignored', /object or null/, () => flown(undefined)],
  [
    'an attitude mode of another name',
    'attitude-mode',
    /mean|Known:/,
    () => flown({ ...NEUTRAL_CONTROLS, attitudeMode: 'autopilot' }),
  ],
  [
    'a target attitude in degrees',
    'attitude-not-unit',
    /not degrees/,
    () => flown({ ...NEUTRAL_CONTROLS, targetAttitude: [0, 90, 0, 0] }),
  ],
  [
    'a target attitude [w, x, y, z]',
    'quaternion-order',
    /\[x, y, z, w\]/,
    () => flown({ ...NEUTRAL_CONTROLS, targetAttitude: [1, 0, 0, 0] }),
  ],
];
