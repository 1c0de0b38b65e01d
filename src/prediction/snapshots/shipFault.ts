import type { ShipState } from '../../wire';
import { describe } from '../checks/describe';

/**
 * Why a plain record is not a ShipState, or null. The wire has checked its messages; a JavaScript caller may pass anything (PREDICTION, Invalid messages).
 */
export function shipFault(given: unknown): string | null {
  if (typeof given !== 'object' || given === null) return 'expected an object';
  const state = given as ShipState;
  if (typeof state.shipId !== 'string' || state.shipId === '') return 'shipId: expected a string';
  if (!areNumbers(state.position, 3)) return expectation('position', 3, state.position);
  if (!areNumbers(state.velocity, 3)) return expectation('velocity', 3, state.velocity);
  if (!areNumbers(state.attitude, 4)) return expectation('attitude', 4, state.attitude);
  if (!areNumbers(state.angularVelocity, 3)) return expectation('angularVelocity', 3, state.angularVelocity);
  if (!areNumbers(state.rotationInput, 3)) return expectation('rotationInput', 3, state.rotationInput);
  if (!areNumbers(state.translationInput, 3))
    return expectation('translationInput', 3, state.translationInput);
  if (!areNumbers(state.targetAttitude, 4)) return expectation('targetAttitude', 4, state.targetAttitude);
  if (!Number.isFinite(state.thrustLevel)) return expectation('thrustLevel', 1, state.thrustLevel);
  if (!Number.isFinite(state.fuel)) return expectation('fuel', 1, state.fuel);
  const { relativePosition, relativeVelocity } = state;
  if (relativePosition !== null && !areNumbers(relativePosition, 3))
    return expectation('relativePosition', 3, relativePosition);
  if (relativeVelocity !== null && !areNumbers(relativeVelocity, 3))
    return expectation('relativeVelocity', 3, relativeVelocity);
  return null;
}

/** Whether `value` is an array of `count` finite numbers. */
export function areNumbers(value: unknown, count: number): boolean {
  if (!Array.isArray(value) || value.length !== count) return false;
  for (let k = 0; k < count; k++) if (!Number.isFinite(value[k])) return false;
  return true;
}

function expectation(name: string, count: number, value: unknown): string {
  const expected = count === 1 ? 'a finite number' : `a list of ${count} finite numbers`;
  return `${name}: expected ${expected}, got ${describe(value)}`;
}
