import { type AttitudeMode, type Controls, NEUTRAL_CONTROLS, type Quat, type Vec3 } from '../../dynamics';
import { ROTATION_ACTIONS, TRANSLATION_ACTIONS } from '../../readout';
import type { Action } from './keyTable';
import { type SteeringAxes, createSteeringAxes, pushInput, turnInput } from './steering';

/** The throttle is rounded to multiples of this. */
const THROTTLE_STEP = 0.005;
/** Throttle per second of holding its key: slow at first, for hovering, then fast. */
const FINE_RATE = 0.06;
const FAST_RATE = 0.6;
/** Seconds of holding after which the lever moves fast. */
const FINE_SECONDS = 0.6;
/** Throttle per tap of its key. */
const TAP = 0.01;

/** Deflections of a gamepad or of thumb sticks, −1 … 1, as seen on the screen; the lever's rate −1 … 1. */
export interface Deflection {
  /** Tilt to the right and away. */
  tiltRight: number;
  tiltAway: number;
  /** About the thrust axis, positive left. */
  turnLeft: number;
  pushRight: number;
  pushAway: number;
  pushUp: number;
  lever: number;
}

export function createDeflection(): Deflection {
  return { tiltRight: 0, tiltAway: 0, turnLeft: 0, pushRight: 0, pushAway: 0, pushUp: 0, lever: 0 };
}

/** The state of the pilot's controls: what is held, and the throttle. */
export interface Stick {
  readonly held: Set<Action>;
  readonly deflection: Deflection;
  readonly steering: SteeringAxes;
  throttle: number;
  damping: boolean;
  mode: AttitudeMode;
  target: Quat;
  /** Seconds that the lever's key has been held. */
  leverSeconds: number;
  /** The newest sample; the same object while nothing changed. */
  controls: Controls;
  /** False until the pilot has touched anything; until then a scenario's own inputs play. */
  touched: boolean;
}

export function createStick(): Stick {
  return {
    held: new Set(),
    deflection: createDeflection(),
    steering: createSteeringAxes(),
    throttle: 0,
    damping: false,
    mode: 'none',
    target: NEUTRAL_CONTROLS.targetAttitude,
    leverSeconds: 0,
    controls: NEUTRAL_CONTROLS,
    touched: false,
  };
}

/** Back to a spawn's controls, nothing held. */
export function resetStick(stick: Stick): void {
  releaseAll(stick);
  stick.throttle = 0;
  stick.damping = false;
  stick.mode = 'none';
  stick.controls = NEUTRAL_CONTROLS;
  stick.touched = false;
}

/** Releases everything held; throttle and modes stay. */
export function releaseAll(stick: Stick): void {
  stick.held.clear();
  Object.assign(stick.deflection, createDeflection());
  stick.leverSeconds = 0;
}

const MODES: Partial<Record<Action, AttitudeMode>> = {
  modeHold: 'hold',
  modeUpright: 'radial',
  modeRetrograde: 'surface_retrograde',
};

const FLIGHT_ACTIONS = new Set<Action>([
  ...ROTATION_ACTIONS.flat(),
  ...TRANSLATION_ACTIONS.flat(),
  'throttleUp',
  'throttleDown',
  'throttleFull',
  'throttleCut',
  'rateDamping',
  'modeHold',
  'modeUpright',
  'modeRetrograde',
  'killRates',
]);

export function isFlightAction(action: Action): boolean {
  return FLIGHT_ACTIONS.has(action);
}

/** The pilot takes over from the scenario or the autopilot. */
export function takeOver(stick: Stick, from: Controls): void {
  if (stick.touched) return;
  stick.touched = true;
  stick.throttle = from.thrustLevel;
  stick.damping = from.attitudeHold;
  stick.mode = from.attitudeMode;
  stick.target = from.targetAttitude;
}

/** A flight key or pad goes down. `attitude`: of the ship, for the mode that holds it. */
export function press(stick: Stick, action: Action, from: Controls, attitude?: Float64Array): void {
  takeOver(stick, from);
  const mode = MODES[action];
  if (mode !== undefined) {
    stick.mode = stick.mode === mode ? 'none' : mode;
    if (mode === 'hold' && attitude !== undefined)
      stick.target = [attitude[0]!, attitude[1]!, attitude[2]!, attitude[3]!];
  } else if (action === 'throttleFull') stick.throttle = 1;
  else if (action === 'throttleCut') stick.throttle = 0;
  else if (action === 'rateDamping') stick.damping = !stick.damping;
  else if (action === 'killRates') {
    stick.mode = 'none';
    stick.damping = true;
  } else {
    stick.held.add(action);
    if (action === 'throttleUp') moveLever(stick, TAP);
    if (action === 'throttleDown') moveLever(stick, -TAP);
    if (action === 'throttleUp' || action === 'throttleDown') stick.leverSeconds = 0;
  }
}

export function release(stick: Stick, action: Action): void {
  stick.held.delete(action);
}

/** Sets the lever as a slider does. */
export function setThrottle(stick: Stick, throttle: number, from: Controls): void {
  takeOver(stick, from);
  stick.throttle = Math.min(Math.max(throttle, 0), 1);
}

function moveLever(stick: Stick, by: number): void {
  stick.throttle = Math.min(Math.max(stick.throttle + by, 0), 1);
}

/** The present controls, `seconds` of wall time after the last sample. */
export function sampleStick(stick: Stick, seconds: number): Controls {
  const { held, deflection, steering } = stick;
  const lever = (held.has('throttleUp') ? 1 : 0) - (held.has('throttleDown') ? 1 : 0);
  if (lever !== 0) {
    const fine = Math.max(0, Math.min(seconds, FINE_SECONDS - stick.leverSeconds));
    moveLever(stick, lever * (FINE_RATE * fine + FAST_RATE * (seconds - fine)));
    stick.leverSeconds += seconds;
  } else if (deflection.lever !== 0) moveLever(stick, deflection.lever * FAST_RATE * 0.5 * seconds);
  const along = ([plus, minus]: readonly [Action, Action]) =>
    (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
  const [pitch, yaw, roll] = [0, 1, 2].map((i) => along(ROTATION_ACTIONS[i]!)) as [number, number, number];
  const [right, away, up] = [0, 1, 2].map((i) => along(TRANSLATION_ACTIONS[i]!)) as [number, number, number];
  const turn = turnInput(
    steering,
    pitch !== 0 ? pitch : -deflection.tiltAway,
    yaw !== 0 ? yaw : -deflection.tiltRight,
    roll !== 0 ? roll : deflection.turnLeft,
  );
  const push = pushInput(
    steering,
    right !== 0 ? right : deflection.pushRight,
    away !== 0 ? away : deflection.pushAway,
    up !== 0 ? up : deflection.pushUp,
  );
  return keep(stick, turn, push);
}

/** The last sample while nothing changed, so that nothing is sent. */
function keep(stick: Stick, turn: Vec3, push: Vec3): Controls {
  const last = stick.controls;
  const thrustLevel = Math.round(stick.throttle / THROTTLE_STEP) * THROTTLE_STEP;
  const same =
    last.thrustLevel === thrustLevel &&
    last.attitudeHold === stick.damping &&
    last.attitudeMode === stick.mode &&
    last.targetAttitude === stick.target &&
    equal(last.rotationInput, turn) &&
    equal(last.translationInput, push);
  if (!same)
    stick.controls = {
      thrustLevel,
      attitudeHold: stick.damping,
      attitudeMode: stick.mode,
      targetAttitude: stick.target,
      rotationInput: turn,
      translationInput: push,
    };
  return stick.controls;
}

function equal(a: Vec3, b: Vec3): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}
