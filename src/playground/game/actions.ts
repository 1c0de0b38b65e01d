import { SCENARIO_NAMES } from '../panels/choices';
import type { Action } from '../input/keyTable';
import { isFlight } from '../input/stick';
import type { PanelAct } from '../panels/panel';
import type { ActsPlace } from './actsPlace';
import { createOperatorActs, isRemote, type OperatorActs } from './operatorActs';

/** The actions of keys, gamepads and buttons. */
export interface Acts {
  readonly press: (action: Action) => void;
  readonly release: (action: Action) => void;
  readonly act: (act: PanelAct) => void;
  /** Called once per frame: ends timed actions. */
  readonly tick: (wall: number) => void;
  /** A new world has begun: it is neither paused nor frozen. */
  readonly reset: () => void;
}

/** Seconds of full throttle in "Hop". */
const HOP = 1;

type KeyActs = Partial<Record<Action, () => void>>;

export function createActs(place: ActsPlace): Acts {
  const { live } = place;
  const operator = createOperatorActs(place);
  const hop = { endsAt: NaN };
  const buttons = buttonActs(place, operator, hop);
  const always: KeyActs = {
    landingAids: place.toggleAids,
    mute: place.toggleSound,
    nextCamera: place.nextCamera,
    hide: place.toggleBare,
    help: place.help,
  };
  const flying: KeyActs = {
    restart: buttons.restart,
    pause: operator.pause,
    stepSubstep: operator.stepSubstep,
    previousScenario: () => scenarioBy(place, -1),
    nextScenario: () => scenarioBy(place, 1),
  };
  const replaying: KeyActs = {
    pause: place.deck.togglePlay,
    stepSubstep: () => place.deck.step('substep', 1),
    stepBack: () => place.deck.step('substep', -1),
  };
  return {
    reset() {
      hop.endsAt = NaN;
      operator.reset();
    },
    press(action) {
      const isReplaying = place.deck.replay() !== null;
      if (!isReplaying && (isFlight(action) || action === 'autopilot')) {
        hop.endsAt = NaN;
        live.hands.press(action);
        live.steer();
      } else ({ ...always, ...(isReplaying ? replaying : flying) })[action]?.();
    },
    release(action) {
      live.hands.release(action);
      if (isFlight(action)) live.steer();
    },
    act: (act) => buttons[act](),
    tick(wall) {
      if (live.clock.now() >= hop.endsAt) {
        hop.endsAt = NaN;
        live.hands.press('throttleCut');
      }
      operator.tick(wall);
    },
  };
}

/** The actions of the panel's buttons. */
function buttonActs(
  place: ActsPlace,
  operator: OperatorActs,
  hop: { endsAt: number },
): Readonly<Record<PanelAct, () => void>> {
  const { live } = place;
  return {
    ...operator,
    restart: () => {
      if (!isRemote(place)) place.begin();
    },
    copyLink: place.copyLink,
    copyFlight: place.copyFlight,
    invite: place.invite,
    help: place.help,
    sound: place.toggleSound,
    resetCamera: place.resetCamera,
    nextCamera: place.nextCamera,
    tryHop: () => {
      live.hands.press('throttleFull');
      hop.endsAt = live.clock.now() + HOP;
    },
    tryTopple: () => place.choose('scenario', 'topple'),
    tryLastState: () => place.choose('mode', place.choices().mode === 'last' ? 'predicted' : 'last'),
  };
}

function scenarioBy(place: ActsPlace, step: number): void {
  if (isRemote(place)) return;
  const at = SCENARIO_NAMES.indexOf(place.choices().scenario);
  place.choose('scenario', SCENARIO_NAMES[(at + step + SCENARIO_NAMES.length) % SCENARIO_NAMES.length]!);
}
