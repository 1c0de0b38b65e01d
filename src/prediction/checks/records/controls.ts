import { ATTITUDE_MODES, type Controls, loadControls, NEUTRAL_CONTROLS } from '../../../dynamics';
import type { Warn } from '../../warnings';
import { describe } from '../describe';
import { nearestName, warnOfUnknown } from '../names';

const NAMING = {
  code: 'unknown-control',
  path: 'controls',
  known: Object.keys(NEUTRAL_CONTROLS),
};

/** Warns of controls that are ignored or clamped; `given` is the argument of `advance`. */
export function checkControls(warn: Warn, given: Controls | null): void {
  if (given === null) return;
  if (typeof given !== 'object') {
    warn('controls-ignored', `controls: expected an object or null, got ${describe(given)}.`, {
      value: given,
    });
    return;
  }
  warnOfUnknown(warn, NAMING, given);
  const loaded = loadControls(given);
  if (!loaded.ok) {
    const message = `The controls are ignored and the last valid ones stay in force: ${loaded.reason}. Start from NEUTRAL_CONTROLS, and set numbers and lists of numbers.`;
    warn('controls-ignored', message, { reason: loaded.reason, value: given });
    return;
  }
  checkAttitude(warn, given);
  const { thrustLevel, translationInput, rotationInput } = given;
  const largest = Math.max(thrustLevel, ...[...translationInput, ...rotationInput].map(Math.abs));
  if (largest > 1 + 1e-9 || thrustLevel < 0) {
    const message = `Controls range from 0 (thrustLevel) or −1 to 1, got ${largest}: they are clamped. Pass shares, not percent.`;
    warn('controls-clamped', message, { value: given });
  }
}

function checkAttitude(warn: Warn, { attitudeMode, targetAttitude }: Controls): void {
  const modes: readonly string[] = ATTITUDE_MODES;
  if (!modes.includes(attitudeMode)) {
    const nearest = nearestName(attitudeMode, modes);
    const hint = nearest === '' ? `Known: ${modes.join(', ')}.` : `Did you mean ${nearest}?`;
    const message = `controls.attitudeMode is ${describe(attitudeMode)}, which is unknown: the ship does not turn. ${hint}`;
    warn('attitude-mode', message, { value: attitudeMode, nearest });
  }
  const [x, y, z, w] = targetAttitude;
  if (x === 1 && y === 0 && z === 0 && w === 0) {
    const message =
      'controls.targetAttitude is [1, 0, 0, 0]: the identity is [0, 0, 0, 1], in the order [x, y, z, w].';
    warn('quaternion-order', message, { field: 'controls.targetAttitude', value: targetAttitude });
  }
  const length = Math.hypot(...targetAttitude);
  if (Math.abs(length - 1) > 0.01) {
    const message = `controls.targetAttitude has length ${length}: pass a unit quaternion [x, y, z, w], not degrees.`;
    warn('attitude-not-unit', message, { field: 'controls.targetAttitude', value: targetAttitude });
  }
}
