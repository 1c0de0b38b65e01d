import { readQuat, readVec3 } from '../../../dynamics';
import type { ShipView, WorldView } from '../../../prediction';
import type { LandingAids } from '../../../readout';
import { cosineOfTilt, type Mission } from '../../../scenarios';
import type { Action } from '../../input/keyTable';

/** The pilot's device, which hints name. */
export type Device = 'keys' | 'gamepad' | 'thumbs';

/** Names of the controls on devices without keys; keys are named by their printed character. */
const GAMEPAD: Partial<Record<Action, string>> = {
  throttleUp: 'RT',
  throttleDown: 'LT',
  throttleCut: 'B',
  rateDamping: 'X',
  autopilot: 'Y',
  modeUpright: 'D-pad up',
  killRates: 'D-pad down',
  modeRetrograde: 'D-pad left',
  modeHold: 'D-pad right',
  pitchMinus: 'Left stick up',
  pitchPlus: 'Left stick down',
  yawPlus: 'Left stick left',
  yawMinus: 'Left stick right',
  rollPlus: 'LB',
  rollMinus: 'RB',
  translateYPlus: 'Right stick up',
  translateYMinus: 'Right stick down',
  translateXMinus: 'Right stick left',
  translateXPlus: 'Right stick right',
  translateZPlus: 'Right stick press',
  translateZMinus: 'Left stick press',
  restart: 'Back',
  pause: 'Start',
};
const THUMBS: Partial<Record<Action, string>> = {
  throttleUp: 'Engine lever right',
  throttleDown: 'Engine lever left',
  throttleCut: 'Cut',
  rateDamping: 'Damping',
  autopilot: 'Auto',
  modeUpright: 'Upright',
  pitchMinus: 'Tilt up',
  pitchPlus: 'Tilt down',
  yawPlus: 'Tilt left',
  yawMinus: 'Tilt right',
  translateYPlus: 'Push up',
  translateYMinus: 'Push down',
  translateXMinus: 'Push left',
  translateXPlus: 'Push right',
  translateZPlus: 'Lift up',
  translateZMinus: 'Lift down',
};

/** The control for an action on a device; '' if there is none. */
export function controlName(device: Device, action: Action, keyCap: (action: Action) => string): string {
  if (device === 'keys') return keyCap(action);
  return (device === 'gamepad' ? GAMEPAD : THUMBS)[action] ?? '';
}

const FIRST: Readonly<Record<Device, string>> = {
  keys: 'You fly: {throttleUp} more thrust, {throttleDown} less, {throttleCut} cut the engine.',
  gamepad: 'You fly: {throttleUp} more thrust, {throttleDown} less, {throttleCut} cut the engine.',
  thumbs: 'You fly: slide Engine for thrust, {throttleCut} stops it.',
};
const LATER: Readonly<Record<Device, string>> = {
  keys: 'Tilt {pitchMinus}{yawPlus}{pitchPlus}{yawMinus} · push {translateYPlus}{translateXMinus}{translateYMinus}{translateXPlus} · thrust {throttleUp} {throttleDown} · cut {throttleCut} · upright {modeUpright} · autopilot {autopilot}',
  gamepad:
    'Left stick tilts, right stick pushes · thrust {throttleUp} {throttleDown} · cut {throttleCut} · upright {modeUpright} · autopilot {autopilot}',
  thumbs: 'Tilt, Push and Lift are under your thumbs · Engine is the lever · Upright levels the ship',
};
/** Lessons in other words than for keys, whose names are short. */
const LESSON_TEXTS: Readonly<Record<string, Partial<Record<Device, string>>>> = {
  'school-hover': { thumbs: 'Slide Engine until it reads the same as hover.' },
  'school-translate': {
    gamepad: 'The right stick pushes the ship. Push the other way to stop.',
    thumbs: 'The Push stick moves the ship. Push the other way to stop.',
  },
  'school-land': { thumbs: 'Follow AIM with the Engine lever. {throttleCut} stops it at touchdown.' },
  'school-right': {
    gamepad: 'Hold the control shown. Release it below the angle shown.',
    thumbs: 'Hold Tilt as the display says. Release it below the angle shown.',
  },
  'school-phobos': {
    thumbs: 'Hold {translateZMinus} briefly, and {translateZPlus} before touchdown to slow down.',
  },
};

/** How to fly a mission, in the words of the device, its controls in braces. */
export function howToFly(
  mission: Mission | null,
  device: Device,
  keyCap: (action: Action) => string,
): string {
  const name = mission?.scenario.name ?? '';
  const lesson = LESSON_TEXTS[name]?.[device] ?? mission?.how ?? '';
  const text = lesson !== '' ? lesson : (name === 'first-landing' ? FIRST : LATER)[device];
  return named(text, device, keyCap);
}

/** Replaces actions in braces by their names on a device. */
function named(text: string, device: Device, keyCap: (action: Action) => string): string {
  return text.replace(/\{(\w+)\}/g, (_, action: string) => {
    const control = controlName(device, action as Action, keyCap);
    return control === '' ? '' : `{${control}}`;
  });
}

/** An advice: the corridor that it agrees with, its words there, and its words in another, since it is about the speed in a moment. */
const ADVICE: Readonly<
  Record<LandingAids['advice'], readonly [LandingAids['corridor'], same: string, other: string]>
> = {
  more: ['fast', 'Too fast: more thrust {throttleUp}', 'More thrust {throttleUp}'],
  hold: ['good', 'Good speed', 'Keep this thrust'],
  less: ['slow', 'Too slow: less thrust {throttleDown}', 'Less thrust {throttleDown}'],
  push: ['slow', 'Too slow: push down {translateZMinus}', 'Push down {translateZMinus}'],
  none: ['none', '', ''],
};

/** Cosine of the tilt past which the engine pushes more sideways than up: more thrust would not help. */
const MIN_UPRIGHT = 0.5;

function isUpright({ attitude, position }: ShipView): boolean {
  return cosineOfTilt(readQuat(attitude, 0), readVec3(position, 0)) >= MIN_UPRIGHT;
}

/** Advice for the landing now, in the words of the device. */
export function adviceText(
  { advice, corridor }: LandingAids,
  { own }: WorldView,
  device: Device,
  keyCap: (action: Action) => string,
): string {
  if (own?.shownState === 'contact' && own.controls.thrustLevel > 0)
    return named('Cut the engine now {throttleCut}', device, keyCap);
  if (own?.shownState === '' && own.fuel <= 0)
    return named('Out of fuel: try again {restart}', device, keyCap).trim();
  if (own?.shownState === '' && !isUpright(own))
    return own.controls.attitudeMode === 'radial' ? '' : named('Turn upright {modeUpright}', device, keyCap);
  const [agreeing, same, other] = ADVICE[advice];
  return named(corridor === agreeing ? same : other, device, keyCap);
}
