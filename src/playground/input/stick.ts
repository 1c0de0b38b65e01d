import { type Controls, NEUTRAL_CONTROLS, type Vec3 } from '../../dynamics';
import { ROTATION_ACTIONS, TRANSLATION_ACTIONS } from '../../readout';
import type { Action } from './keyTable';

/** Throttle a second of holding its key. */
const THROTTLE_RATE = 0.6;

/** The pilot's hands: what is held down, where the throttle stands. */
export interface Stick {
  readonly held: Set<Action>;
  throttle: number;
  damping: boolean;
  /** The newest sample; the same object while nothing changed. */
  controls: Controls;
  /** False until the pilot has touched anything: a scenario's own inputs play as long. */
  touched: boolean;
}

export function createStick(): Stick {
  return { held: new Set(), throttle: 0, damping: false, controls: NEUTRAL_CONTROLS, touched: false };
}

/** Back to a spawn's controls, nothing held. */
export function resetStick(stick: Stick): void {
  stick.held.clear();
  stick.throttle = 0;
  stick.damping = false;
  stick.controls = NEUTRAL_CONTROLS;
  stick.touched = false;
}

const FLIGHT = new Set<Action>([
  ...ROTATION_ACTIONS.flat(),
  ...TRANSLATION_ACTIONS.flat(),
  'throttleUp',
  'throttleDown',
  'throttleFull',
  'throttleCut',
  'rateDamping',
]);

export function isFlight(action: Action): boolean {
  return FLIGHT.has(action);
}

/** A flight key or pad goes down. */
export function press(stick: Stick, action: Action, from: Controls): void {
  if (!stick.touched) {
    // The pilot takes over what the scenario was doing.
    stick.touched = true;
    stick.throttle = from.thrustLevel;
    stick.damping = from.attitudeHold;
  }
  if (action === 'throttleFull') stick.throttle = 1;
  else if (action === 'throttleCut') stick.throttle = 0;
  else if (action === 'rateDamping') stick.damping = !stick.damping;
  else stick.held.add(action);
}

export function release(stick: Stick, action: Action): void {
  stick.held.delete(action);
}

/** Controls as the hands are now, `seconds` of wall time after the last sample. */
export function sampleStick(stick: Stick, seconds: number): Controls {
  const { held } = stick;
  const lever = (held.has('throttleUp') ? 1 : 0) - (held.has('throttleDown') ? 1 : 0);
  stick.throttle = Math.min(Math.max(stick.throttle + lever * THROTTLE_RATE * seconds, 0), 1);
  const turn = axes(held, ROTATION_ACTIONS);
  const push = axes(held, TRANSLATION_ACTIONS);
  const last = stick.controls;
  const same =
    last.thrustLevel === stick.throttle &&
    last.attitudeHold === stick.damping &&
    last.attitudeMode === 'none' &&
    equal(last.rotationInput, turn) &&
    equal(last.translationInput, push);
  if (!same)
    stick.controls = {
      ...NEUTRAL_CONTROLS,
      thrustLevel: stick.throttle,
      attitudeHold: stick.damping,
      rotationInput: turn,
      translationInput: push,
    };
  return stick.controls;
}

const NONE: Vec3 = [0, 0, 0];

function axes(held: ReadonlySet<Action>, actions: readonly (readonly [Action, Action])[]): Vec3 {
  if (held.size === 0) return NONE;
  const along = ([plus, minus]: readonly [Action, Action]) =>
    (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
  return [along(actions[0]!), along(actions[1]!), along(actions[2]!)];
}

function equal(a: Vec3, b: Vec3): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}
