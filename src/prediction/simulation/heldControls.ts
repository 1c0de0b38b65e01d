import { ROTATION_INPUT, THRUST_LEVEL, TRANSLATION_INPUT } from '../../dynamics';
import type { Track } from './track';

/** Other pilots' last known controls, held for a while and then released (PREDICTION, Other ships). */

/** Whether another pilot's controls are released at (tick, substep). */
export function isReleased(track: Track, tick: number, substep: number): boolean {
  return track.releaseTick === tick && track.releaseSubstep === substep;
}

/** Centres the sticks and turns the engine off; the attitude mode stays. */
export function release(rows: Float64Array, at: number): void {
  rows[at + THRUST_LEVEL] = 0;
  for (let k = 0; k < 3; k++) {
    rows[at + TRANSLATION_INPUT + k] = 0;
    rows[at + ROTATION_INPUT + k] = 0;
  }
}

/** Whether a row commands anything that `release` would change. */
export function commandsAnything(rows: Float64Array, at: number): boolean {
  if (rows[at + THRUST_LEVEL] !== 0) return true;
  for (let k = 0; k < 3; k++) {
    if (rows[at + TRANSLATION_INPUT + k] !== 0 || rows[at + ROTATION_INPUT + k] !== 0) return true;
  }
  return false;
}
