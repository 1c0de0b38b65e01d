import { type Choices, SCENARIO_NAMES } from '../panels/choices';
import type { Action } from '../input/keyTable';
import type { Live } from './live';
import type { Panel, PanelAct } from '../panels/panel';
import type { Banner } from '../panels/banner';
import { isFlight } from '../input/stick';

/** What keys, pads and buttons come to. */
export interface Acts {
  readonly press: (action: Action) => void;
  readonly release: (action: Action) => void;
  readonly act: (act: PanelAct) => void;
  /** Once a frame: what lasts a while ends by itself. */
  readonly tick: (wall: number) => void;
  /** A new world has begun: nothing is paused or frozen any more. */
  readonly reset: () => void;
}

export interface ActsPlace {
  readonly live: Live;
  readonly panel: Panel;
  readonly banner: Banner;
  readonly choices: () => Choices;
  /** Takes a choice and does what it asks. */
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly begin: () => void;
  readonly help: () => void;
  readonly resetCamera: () => void;
  readonly nextCamera: () => void;
  readonly copyLink: () => void;
  /** Lets another tab in, and hands out its link. */
  readonly invite: () => void;
  readonly toggleBare: () => void;
  readonly toggleAids: () => void;
  readonly toggleSound: () => void;
  /** A recording plays: the game behind it takes no commands. */
  readonly isReplaying: () => boolean;
  /** The flight no longer follows from the pilot's inputs alone. */
  readonly meddled: (how: string) => void;
}

/** Wall seconds of hiding, and of the throttle in "Hop". */
const AWAY = 60;
const HOP = 1;

export function createActs(place: ActsPlace): Acts {
  const { live, panel, banner } = place;
  const state = { paused: false, frozen: false, dropped: false, awayUntil: NaN, cutAt: NaN };
  const reset = () => {
    Object.assign(state, { paused: false, frozen: false, dropped: false, awayUntil: NaN, cutAt: NaN });
    live.hold(false);
    for (const act of ['pause', 'freeze', 'drop', 'away'] as const) panel.press(act, false);
    panel.label('pause', 'Pause');
    panel.label('drop', 'Drop the connection');
    panel.label('away', 'Hide for a minute');
  };
  const pause = () => {
    if (isRemote(place)) return;
    state.paused = !state.paused;
    panel.press('pause', state.paused);
    panel.label('pause', state.paused ? 'Resume' : 'Pause');
    live.hands.rest(state.paused);
    live.operate({ kind: 'pause', paused: state.paused });
    banner.state(state.paused ? 'Paused: the server stops at its next tick. O steps one substep.' : '');
  };
  const away = (wall: number) => {
    const hiding = Number.isNaN(state.awayUntil);
    state.awayUntil = hiding ? wall + AWAY : NaN;
    panel.press('away', hiding);
    live.hold(hiding);
    if (hiding) return;
    panel.label('away', 'Hide for a minute');
    banner.state('');
  };
  const acts = createPanelActs(place, { state, pause, away });
  const keys: Partial<Record<Action, () => void>> = {
    restart: acts.restart,
    pause,
    stepSubstep: acts.stepSubstep,
    previousScenario: () => scenarioBy(place, -1),
    nextScenario: () => scenarioBy(place, 1),
    landingAids: place.toggleAids,
    mute: place.toggleSound,
    nextCamera: place.nextCamera,
    hide: place.toggleBare,
    help: place.help,
  };
  /** What may be done while a recording plays: nothing that reaches the game behind it. */
  const HARMLESS = new Set<Action>(['hide', 'help', 'mute', 'landingAids', 'nextCamera']);

  return {
    reset,
    press(action) {
      if (place.isReplaying() && !HARMLESS.has(action)) return;
      if (isFlight(action) || action === 'autopilot') {
        state.cutAt = NaN;
        live.hands.press(action);
        live.steer();
      } else keys[action]?.();
    },
    release(action) {
      live.hands.release(action);
      if (isFlight(action)) live.steer();
    },
    act: (act) => acts[act](),
    tick(wall) {
      if (live.clock.now() >= state.cutAt) {
        state.cutAt = NaN;
        live.hands.press('throttleCut');
      }
      if (Number.isNaN(state.awayUntil)) return;
      const left = Math.ceil(state.awayUntil - wall);
      if (left <= 0) away(wall);
      else {
        banner.state(`Simulating a hidden tab: nothing received or drawn for ${left} s.`);
        panel.label('away', `Back now (${left} s)`);
      }
    },
  };
}

interface ActState {
  readonly state: { paused: boolean; frozen: boolean; dropped: boolean; awayUntil: number; cutAt: number };
  readonly pause: () => void;
  readonly away: (wall: number) => void;
}

/** What the panel's buttons do. */
function createPanelActs(
  place: ActsPlace,
  { state, pause, away }: ActState,
): Readonly<Record<PanelAct, () => void>> {
  const { live, panel } = place;
  return {
    restart: () => {
      if (!isRemote(place)) place.begin();
    },
    pause,
    stepSubstep: () => {
      if (isRemote(place)) return;
      if (!state.paused) pause();
      place.meddled('it was stepped');
      live.operate({ kind: 'step', unit: 'substep' });
    },
    kick: () => {
      place.meddled('the ship was kicked');
      live.operate({ kind: 'kick', velocity: [2, 0, 3], spin: [0, 0.35, 0] });
    },
    freeze: () => {
      state.frozen = !state.frozen;
      panel.press('freeze', state.frozen);
      live.operate({ kind: 'freeze', frozen: state.frozen });
    },
    drop: () => {
      state.dropped = !state.dropped;
      panel.press('drop', state.dropped);
      panel.label('drop', state.dropped ? 'Reconnect' : 'Drop the connection');
      if (state.dropped) live.operate({ kind: 'drop' });
      else live.reconnect();
    },
    away: () => away(performance.now() / 1000),
    copyLink: place.copyLink,
    invite: place.invite,
    help: place.help,
    sound: place.toggleSound,
    resetCamera: place.resetCamera,
    nextCamera: place.nextCamera,
    tryHop: () => {
      live.hands.press('throttleFull');
      state.cutAt = live.clock.now() + HOP;
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

/** A real server takes no orders: nothing is said to have happened that did not. */
function isRemote({ choices, banner }: ActsPlace): boolean {
  if (choices().server === '') return false;
  banner.flash('Only available with the built-in server.');
  return true;
}
