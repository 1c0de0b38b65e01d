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
  /** While true nothing that is pressed is taken: the game is paused. */
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
  /** What is commanded now, `seconds` of wall time after the last sample; null while the plan flies. */
  readonly controls: (view: WorldView, now: number, seconds: number) => Controls | null;
}

export function createHands(view: () => WorldView, terrainHeight: () => TerrainHeight): Hands {
  const stick = createStick();
  const autopilot = createAutopilot(terrainHeight);
  let resting = false;
  let screen: (() => Float64Array | null) | null = null;
  let wasOn = false;
  const flown = () => view().own?.controls ?? NEUTRAL_CONTROLS;
  /** The pilot takes over what the autopilot was doing. */
  const giveBack = () => {
    autopilot.set(false);
    wasOn = false;
    stick.touched = false;
    takeOver(stick, { ...flown(), attitudeMode: 'none', attitudeHold: true });
  };
  const aim = () => {
    const ship = view().own;
    if (ship !== null) takeAim(stick.aim, screen?.() ?? null, ship.attitude, ship.surfaceContactState === '');
  };
  return {
    stick,
    autopilot,
    rest(next) {
      resting = next;
      if (next) letGo(stick);
    },
    isResting: () => resting,
    deflect() {
      if (resting) {
        letGo(stick);
        return;
      }
      if (autopilot.isOn()) giveBack();
      aim();
      takeOver(stick, flown());
    },
    press(action) {
      if (resting) return;
      if (action === 'autopilot') {
        if (autopilot.isOn()) giveBack();
        else {
          letGo(stick);
          autopilot.set(true);
          wasOn = true;
        }
        return;
      }
      if (autopilot.isOn()) giveBack();
      aim();
      press(stick, action, flown(), view().own?.attitude);
    },
    release: (action) => release(stick, action),
    setThrottle(throttle) {
      if (resting) return;
      if (autopilot.isOn()) giveBack();
      setThrottle(stick, throttle, flown());
    },
    letGo: () => letGo(stick),
    reset() {
      resetStick(stick);
      autopilot.set(false);
      wasOn = false;
      resting = false;
    },
    aimBy: (next) => (screen = next),
    controls(seen, now, seconds) {
      if (autopilot.isOn()) return autopilot.fly(seen, now);
      if (wasOn) giveBack();
      if (stick.held.size === 0) aim();
      const byHand = sampleStick(stick, resting ? 0 : seconds);
      return stick.touched ? byHand : null;
    },
  };
}
