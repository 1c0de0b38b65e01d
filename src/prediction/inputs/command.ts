import {
  ATTITUDE_HOLD,
  ATTITUDE_MODE,
  type Controls,
  modeName,
  ROTATION_INPUT,
  SHIP_STRIDE,
  TARGET_ATTITUDE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
} from '../../dynamics';
import type { StateControls } from '../../wire';

/** Commands are compared within single precision, in which a server may send them. */
const TOLERANCE = 1e-6;

/** Whether two rows hold the same command. */
export function sameCommand(a: Float64Array, i: number, b: Float64Array, j: number): boolean {
  for (let k = THRUST_LEVEL; k < SHIP_STRIDE; k++) {
    const tolerance = k === ATTITUDE_HOLD ? 0 : TOLERANCE;
    if (!(Math.abs(a[i + k]! - b[j + k]!) <= tolerance)) return false;
  }
  return true;
}

/** Whether two records hold the same command. */
export function sameControls(a: Controls, b: StateControls): boolean {
  return (
    near(a.thrustLevel, b.thrustLevel) &&
    a.attitudeHold === b.attitudeHold &&
    a.attitudeMode === b.attitudeMode &&
    nearAll(a.rotationInput, 0, b.rotationInput) &&
    nearAll(a.translationInput, 0, b.translationInput) &&
    nearAll(a.targetAttitude, 0, b.targetAttitude)
  );
}

/** Whether the row at `at` holds the command of a record, which need not be checked. */
export function holdsCommand(rows: Float64Array, at: number, given: Controls): boolean {
  return (
    near(rows[at + THRUST_LEVEL]!, given.thrustLevel) &&
    rows[at + ATTITUDE_HOLD] === (given.attitudeHold ? 1 : 0) &&
    modeName(rows[at + ATTITUDE_MODE]!) === given.attitudeMode &&
    nearAll(rows, at + TRANSLATION_INPUT, given.translationInput) &&
    nearAll(rows, at + ROTATION_INPUT, given.rotationInput) &&
    nearAll(rows, at + TARGET_ATTITUDE, given.targetAttitude)
  );
}

function near(a: number, b: number): boolean {
  return Math.abs(a - b) <= TOLERANCE;
}

function nearAll(values: ArrayLike<number>, at: number, others: readonly number[]): boolean {
  for (let k = 0; k < others.length; k++) if (!near(values[at + k]!, others[k]!)) return false;
  return true;
}
