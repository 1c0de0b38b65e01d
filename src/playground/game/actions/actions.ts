import { SCENARIO_NAMES } from '../../panels/choices';
import type { Action } from '../../input/keyTable';
import { isFlightAction } from '../../input/stick';
import type { PanelAction } from '../../panels/panelActions';
import type { ActionTargets } from './actionTargets';
import { createOperatorActions, isRemote, type OperatorActions } from './operatorActions';

/** The actions of keys, gamepads and buttons. */
export interface Actions {
  readonly press: (action: Action) => void;
  readonly release: (action: Action) => void;
  readonly runPanelAction: (action: PanelAction) => void;
  /** Called once per frame: ends timed actions. */
  readonly tick: (wall: number) => void;
  /** A new world has begun: it is neither paused nor frozen. */
  readonly reset: () => void;
}

/** Seconds of full throttle in "Hop". */
const HOP = 1;

type KeyActions = Partial<Record<Action, () => void>>;

export function createActions(targets: ActionTargets): Actions {
  const { live } = targets;
  const operator = createOperatorActions(targets);
  const hop = { endsAt: NaN };
  const buttons = buttonActions(targets, operator, hop);
  const always: KeyActions = {
    landingAids: targets.toggleAids,
    mute: targets.toggleSound,
    nextCamera: targets.nextCamera,
    hide: targets.toggleBare,
    help: targets.help,
  };
  const flying: KeyActions = {
    restart: buttons.restart,
    pause: operator.pause,
    stepSubstep: operator.stepSubstep,
    previousScenario: () => scenarioBy(targets, -1),
    nextScenario: () => scenarioBy(targets, 1),
  };
  const replaying: KeyActions = {
    pause: targets.deck.togglePlay,
    stepSubstep: () => targets.deck.step('substep', 1),
    stepBack: () => targets.deck.step('substep', -1),
  };
  return {
    reset() {
      hop.endsAt = NaN;
      operator.reset();
    },
    press(action) {
      const isReplaying = targets.deck.replay() !== null;
      if (!isReplaying && (isFlightAction(action) || action === 'autopilot')) {
        hop.endsAt = NaN;
        live.flightControls.press(action);
        live.steer();
      } else ({ ...always, ...(isReplaying ? replaying : flying) })[action]?.();
    },
    release(action) {
      live.flightControls.release(action);
      if (isFlightAction(action)) live.steer();
    },
    runPanelAction: (action) => buttons[action](),
    tick(wall) {
      if (live.clock.now() >= hop.endsAt) {
        hop.endsAt = NaN;
        live.flightControls.press('throttleCut');
      }
      operator.tick(wall);
    },
  };
}

/** The actions of the panel's buttons. */
function buttonActions(
  targets: ActionTargets,
  operator: OperatorActions,
  hop: { endsAt: number },
): Readonly<Record<PanelAction, () => void>> {
  const { live } = targets;
  return {
    ...operator,
    restart: () => {
      if (!isRemote(targets)) targets.begin();
    },
    copyLink: targets.copyLink,
    copyFlight: targets.copyFlight,
    invite: targets.invite,
    help: targets.help,
    sound: targets.toggleSound,
    resetCamera: targets.resetCamera,
    nextCamera: targets.nextCamera,
    tryHop: () => {
      live.flightControls.press('throttleFull');
      hop.endsAt = live.clock.now() + HOP;
    },
    tryTopple: () => targets.choose('scenario', 'topple'),
    tryLastState() {
      const isOn = targets.choices().mode !== 'last';
      targets.choose('mode', isOn ? 'last' : 'predicted');
      // A ship at rest is drawn the same by both: the flight begins again.
      if (isOn && !isRemote(targets) && targets.deck.replay() === null) targets.begin();
    },
  };
}

function scenarioBy(targets: ActionTargets, step: number): void {
  if (isRemote(targets)) return;
  const at = SCENARIO_NAMES.indexOf(targets.choices().scenario);
  targets.choose('scenario', SCENARIO_NAMES[(at + step + SCENARIO_NAMES.length) % SCENARIO_NAMES.length]!);
}
