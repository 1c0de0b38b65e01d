import { type Controls, NEUTRAL_CONTROLS, type TerrainHeight } from '../../dynamics';
import type { WorldView } from '../../prediction';
import type { Action } from '../input/keyTable';
import { takeAim } from '../input/steering';
import {
  createStick,
  letGo,
  press,
  release,
  resetStick,
  sampleStick,
  setThrottle,
  type Stick,
  takeOver,
} from '../input/stick';
import { type Autopilot, createAutopilot } from './autopilot';

/** Who flies: the scenario's own plan, the pilot's hands, or the autopilot. */
export interface Hands {
  readonly stick: Stick;
  readonly autopilot: Autopilot;
  /** While true, presses are ignored: the game is paused. */
  readonly rest: (resting: boolean) => void;
  readonly isResting: () => boolean;
  /** A stick was moved: the pilot takes over, in the axes of the moment. */
  readonly deflect: () => void;
  readonly press: (action: Action) => void;
  readonly release: (action: Action) => void;
  readonly setThrottle: (throttle: number) => void;
  readonly letGo: () => void;
  readonly reset: () => void;
  /** Right, away and up on the screen in ICRF, or null: the ship's own axes. Asked when a key goes down. */
  readonly aimBy: (screen: (() => Float64Array | null) | null) => void;
  /** The present controls, `seconds` of wall time after the last sample; null while the plan flies. */
  readonly controls: (view: WorldView, now: number, seconds: number) => Controls | null;
}

interface HandsState {
  readonly stick: Stick;
  readonly autopilot: Autopilot;
  readonly view: () => WorldView;
  isResting: boolean;
  screen: (() => Float64Array | null) | null;
  /** The autopilot flew at the last sample. */
  wasOn: boolean;
}

export function createHands(view: () => WorldView, terrainHeight: () => TerrainHeight): Hands {
  const stick = createStick();
  const autopilot = createAutopilot(terrainHeight);
  const state: HandsState = { stick, autopilot, view, isResting: false, screen: null, wasOn: false };
  return {
    stick,
    autopilot,
    rest(resting) {
      state.isResting = resting;
      if (resting) letGo(stick);
    },
    isResting: () => state.isResting,
    deflect() {
      if (state.isResting) letGo(stick);
      else {
        takeStick(state);
        takeOver(stick, flown(state));
      }
    },
    press(action) {
      if (state.isResting) return;
      if (action === 'autopilot') toggleAutopilot(state);
      else {
        takeStick(state);
        press(stick, action, flown(state), view().own?.attitude);
      }
    },
    release: (action) => release(stick, action),
    setThrottle(throttle) {
      if (state.isResting) return;
      if (autopilot.isOn()) giveBack(state);
      setThrottle(stick, throttle, flown(state));
    },
    letGo: () => letGo(stick),
    reset() {
      resetStick(stick);
      autopilot.set(false);
      state.wasOn = false;
      state.isResting = false;
    },
    aimBy: (screen) => (state.screen = screen),
    controls(seen, now, seconds) {
      if (autopilot.isOn()) return autopilot.fly(seen, now);
      if (state.wasOn) giveBack(state);
      if (stick.held.size === 0) aim(state);
      const byHand = sampleStick(stick, state.isResting ? 0 : seconds);
      return stick.touched ? byHand : null;
    },
  };
}

function flown({ view }: HandsState): Controls {
  return view().own?.controls ?? NEUTRAL_CONTROLS;
}

/** The pilot flies from here on, in the axes of the moment. */
function takeStick(state: HandsState): void {
  if (state.autopilot.isOn()) giveBack(state);
  aim(state);
}

function toggleAutopilot(state: HandsState): void {
  if (state.autopilot.isOn()) giveBack(state);
  else {
    letGo(state.stick);
    state.autopilot.set(true);
    state.wasOn = true;
  }
}

/** The pilot takes over from the autopilot. */
function giveBack(state: HandsState): void {
  const { stick, autopilot } = state;
  autopilot.set(false);
  state.wasOn = false;
  stick.touched = false;
  takeOver(stick, { ...flown(state), attitudeMode: 'none', attitudeHold: true });
}

function aim({ stick, view, screen }: HandsState): void {
  const ship = view().own;
  if (ship !== null) takeAim(stick.aim, screen?.() ?? null, ship.attitude, ship.surfaceContactState === '');
}
