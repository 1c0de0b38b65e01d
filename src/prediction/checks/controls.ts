import { type Controls, loadControls, NEUTRAL_CONTROLS } from '../../dynamics';
import type { Warn } from '../warnings';
import { warnOfUnknown } from './names';

const NAMING = {
  code: 'unknown-control',
  path: 'controls',
  known: Object.keys(NEUTRAL_CONTROLS),
};

/** Warns of controls that are ignored or clamped; `given` is whatever `advance` was called with. */
export function checkControls(warn: Warn, given: Controls | null): void {
  if (given === null) return;
  if (typeof given !== 'object') {
    warn('controls-ignored', `controls: expected an object or null, got ${String(given)}.`, { value: given });
    return;
  }
  warnOfUnknown(warn, NAMING, given);
  const loaded = loadControls(given);
  if (!loaded.ok) {
    const message = `The controls are ignored, the last good ones hold: ${loaded.reason}. Start from NEUTRAL_CONTROLS.`;
    warn('controls-ignored', message, { reason: loaded.reason, value: given });
    return;
  }
  const { thrustLevel, translationInput, rotationInput } = given;
  const largest = Math.max(thrustLevel, ...[...translationInput, ...rotationInput].map(Math.abs));
  if (largest > 1 + 1e-9 || thrustLevel < 0) {
    const message = `Controls go from 0 (thrustLevel) or −1 to 1, got ${largest}: they are clamped. Percent?`;
    warn('controls-clamped', message, { value: given });
  }
}
