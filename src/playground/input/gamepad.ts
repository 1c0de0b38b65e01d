import type { Action } from './keyTable';
import type { Deflection } from './stick';

/** The standard mapping of the Gamepad specification: buttons by number. */
const BUTTONS: readonly (readonly [number, Action | 'confirm'])[] = [
  [0, 'confirm'],
  [1, 'throttleCut'],
  [2, 'rateDamping'],
  [3, 'autopilot'],
  [8, 'restart'],
  [9, 'pause'],
  [12, 'modeUpright'],
  [13, 'killRates'],
  [14, 'modeRetrograde'],
  [15, 'modeHold'],
];
/** Buttons that deflect while they are held. */
const HELD = [4, 5, 6, 7, 10, 11] as const;
const [LEFT_SHOULDER, RIGHT_SHOULDER, LEFT_TRIGGER, RIGHT_TRIGGER, LEFT_STICK, RIGHT_STICK] = HELD;

/** Deflection below which a stick is at rest: worn sticks do not return to 0. */
const DEAD = 0.16;
/** Steps of a deflection: changes that the pilot cannot feel are not sent. */
const STEPS = 20;

/** A raw axis, −1 … 1, with its dead zone taken out and the rest spread over the whole range. */
export function withDeadZone(raw: number): number {
  const size = Math.abs(raw);
  if (!(size > DEAD)) return 0;
  const share = Math.min(1, (size - DEAD) / (1 - DEAD));
  return (Math.sign(raw) * Math.round(share * STEPS)) / STEPS;
}

/** The members of a Gamepad that are read. */
export interface PadState {
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** Fills the deflection from a gamepad with the standard mapping; false for an unknown mapping. */
export function readPad(out: Deflection, pad: PadState): boolean {
  if (pad.mapping !== 'standard') return false;
  const axis = (i: number) => withDeadZone(pad.axes[i] ?? 0) + 0;
  const button = (i: number) => withDeadZone(pad.buttons[i]?.value ?? 0);
  out.tiltRight = axis(0);
  out.tiltAway = -axis(1) + 0;
  out.pushRight = axis(2);
  out.pushAway = -axis(3) + 0;
  out.pushUp = button(RIGHT_STICK) - button(LEFT_STICK);
  out.turnLeft = button(LEFT_SHOULDER) - button(RIGHT_SHOULDER);
  out.lever = button(RIGHT_TRIGGER) - button(LEFT_TRIGGER);
  return true;
}

export interface GamepadListeners {
  readonly pressed: (action: Action) => void;
  readonly confirmed: () => void;
  /** A pad was connected or disconnected. */
  readonly changed: (name: string | null) => void;
}

/** Reads the first pad of the standard mapping once a frame; true while it is deflected. Nothing is read before one connects. */
export function createGamepads(
  window: Window,
  deflection: () => Deflection,
  listeners: GamepadListeners,
): () => boolean {
  const down = new Set<number>();
  let name: string | null = null;
  let wasActive = false;
  let isConnected = false;
  window.addEventListener('gamepadconnected', () => (isConnected = true));
  return () => {
    if (!isConnected) return false;
    const pad = padsOf(window.navigator).find((each) => each?.mapping === 'standard') ?? null;
    if ((pad?.id ?? null) !== name) {
      name = pad?.id ?? null;
      listeners.changed(name);
    }
    if (pad === null) {
      isConnected = false;
      return false;
    }
    // Sticks first, so that a released trigger does not change the value that a button sets. At rest the pad leaves thumb sticks alone.
    const isActive = isDeflected(pad);
    if (isActive || wasActive) readPad(deflection(), pad);
    wasActive = isActive;
    for (const [number, action] of BUTTONS) {
      const pressed = pad.buttons[number]?.pressed ?? false;
      if (pressed === down.has(number)) continue;
      if (!pressed) down.delete(number);
      else {
        down.add(number);
        if (action === 'confirm') listeners.confirmed();
        else listeners.pressed(action);
      }
    }
    return isActive;
  };
}

function isDeflected(pad: PadState): boolean {
  if (pad.axes.slice(0, 4).some((raw) => withDeadZone(raw) !== 0)) return true;
  return HELD.some((i) => withDeadZone(pad.buttons[i]?.value ?? 0) !== 0);
}

/** Browsers add the maker's numbers: `Xbox 360 Controller (XInput STANDARD GAMEPAD)`, `045e-028e-Xbox 360 Controller`. */
export function padName(id: string): string {
  return id.replace(/^([\da-f]{1,4}-){2}| *\(.*/g, '').slice(0, 40) || 'connected';
}

/** A page may be forbidden to read pads. */
function padsOf(navigator: Pick<Navigator, 'getGamepads'>): readonly (Gamepad | null)[] {
  try {
    return navigator.getGamepads();
  } catch {
    return [];
  }
}
