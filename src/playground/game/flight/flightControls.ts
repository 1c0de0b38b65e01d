import { type Controls, NEUTRAL_CONTROLS, type TerrainHeight } from '../../../dynamics';
import type { WorldView } from '../../../prediction';
import type { Action } from '../../input/keyTable';
import { alignSteeringAxes } from '../../input/steering';
import {
  createStick,
  releaseAll,
  press,
  release,
  resetStick,
  sampleStick,
  setThrottle,
  type Stick,
  takeOver,
} from '../../input/stick';
import { type Autopilot, createAutopilot } from './autopilot';

/** The controls of a moment, and whether the autopilot flew: what a snapshot keeps beside the ships. */
export interface SavedControls {
  readonly controls: Controls;
  readonly isAutopilotOn: boolean;
}

/** Who flies: the scenario's own plan, the pilot, or the autopilot. */
export interface FlightControls {
  readonly stick: Stick;
  readonly autopilot: Autopilot;
  /** While true, presses are ignored: the game is paused. */
  readonly setPaused: (paused: boolean) => void;
  readonly isPaused: () => boolean;
  /** A stick was moved: the pilot takes over, in the present axes. */
  readonly takeOver: () => void;
  readonly press: (action: Action) => void;
  readonly release: (action: Action) => void;
  readonly setThrottle: (throttle: number) => void;
  readonly releaseAll: () => void;
  readonly reset: () => void;
  readonly save: () => SavedControls;
  /** Lever, damping and mode as saved; what is held now is still held. */
  readonly restore: (saved: SavedControls) => void;
  /** Right, away and up on the screen in ICRF, or null: the ship's own axes. Read when a key goes down. */
  readonly steerInScreenAxes: (screen: (() => Float64Array | null) | null) => void;
  /** The present controls, `seconds` of wall time after the last sample; null while the plan flies. */
  readonly sample: (view: WorldView, now: number, seconds: number) => Controls | null;
}

interface FlightControlsState {
  readonly stick: Stick;
  readonly autopilot: Autopilot;
  readonly view: () => WorldView;
  isPaused: boolean;
  screen: (() => Float64Array | null) | null;
  /** The autopilot's commands until the pilot takes over; those in the view are a moment old. */
  commanded: Controls | null;
}

export function createFlightControls(
  view: () => WorldView,
  terrainHeight: () => TerrainHeight,
): FlightControls {
  const stick = createStick();
  const autopilot = createAutopilot(terrainHeight);
  const state: FlightControlsState = {
    stick,
    autopilot,
    view,
    isPaused: false,
    screen: null,
    commanded: null,
  };
  return {
    stick,
    autopilot,
    setPaused(paused) {
      state.isPaused = paused;
      if (paused) releaseAll(stick);
    },
    isPaused: () => state.isPaused,
    takeOver() {
      if (state.isPaused) releaseAll(stick);
      else {
        takeStick(state);
        takeOver(stick, currentControls(state));
      }
    },
    press(action) {
      if (state.isPaused) return;
      if (action === 'autopilot') toggleAutopilot(state);
      else {
        takeStick(state);
        press(stick, action, currentControls(state), view().own?.attitude);
      }
    },
    release: (action) => release(stick, action),
    setThrottle(throttle) {
      if (state.isPaused) return;
      if (autopilot.isOn()) takeOverFromAutopilot(state);
      setThrottle(stick, throttle, currentControls(state));
    },
    releaseAll: () => releaseAll(stick),
    ...savedControls(state),
    steerInScreenAxes: (screen) => (state.screen = screen),
    sample(seen, now, seconds) {
      if (autopilot.isOn()) return (state.commanded = autopilot.fly(seen, now));
      if (state.commanded !== null) takeOverFromAutopilot(state);
      if (stick.held.size === 0) alignSteering(state);
      const byHand = sampleStick(stick, state.isPaused ? 0 : seconds);
      return stick.touched ? byHand : null;
    },
  };
}

function savedControls(state: FlightControlsState): Pick<FlightControls, 'reset' | 'save' | 'restore'> {
  const { stick, autopilot } = state;
  return {
    reset() {
      resetStick(stick);
      autopilot.set(false);
      state.commanded = null;
      state.isPaused = false;
    },
    save: () => ({
      controls: stick.touched ? stick.controls : currentControls(state),
      isAutopilotOn: autopilot.isOn(),
    }),
    restore({ controls, isAutopilotOn }) {
      autopilot.set(isAutopilotOn);
      state.commanded = isAutopilotOn ? controls : null;
      stick.touched = false;
      takeOver(stick, controls);
    },
  };
}

function currentControls({ view }: FlightControlsState): Controls {
  return view().own?.controls ?? NEUTRAL_CONTROLS;
}

/** The pilot flies from here on, in the present axes. */
function takeStick(state: FlightControlsState): void {
  if (state.autopilot.isOn()) takeOverFromAutopilot(state);
  alignSteering(state);
}

function toggleAutopilot(state: FlightControlsState): void {
  if (state.autopilot.isOn()) takeOverFromAutopilot(state);
  else {
    releaseAll(state.stick);
    state.autopilot.set(true);
    state.commanded = currentControls(state);
  }
}

/** The pilot takes over from the autopilot. */
function takeOverFromAutopilot(state: FlightControlsState): void {
  const { stick, autopilot } = state;
  autopilot.set(false);
  const from = state.commanded ?? currentControls(state);
  state.commanded = null;
  stick.touched = false;
  takeOver(stick, { ...from, attitudeMode: 'none', attitudeHold: true });
}

function alignSteering({ stick, view, screen }: FlightControlsState): void {
  const ship = view().own;
  if (ship !== null)
    alignSteeringAxes(stick.steering, screen?.() ?? null, ship.attitude, ship.surfaceContactState === '');
}
