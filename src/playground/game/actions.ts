import { SCENARIOS } from '../../scenarios';
import type { Choices } from '../panels/choices';
import type { Action } from '../input/keyTable';
import type { Live } from './live';
import type { Panel, PanelAct } from '../panels/panel';
import { isFlight, press, release } from '../input/stick';

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
  readonly choices: () => Choices;
  /** Takes a choice and does what it asks. */
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly begin: () => void;
  readonly help: () => void;
  readonly resetCamera: () => void;
  readonly copyLink: () => void;
  readonly banner: (text: string) => void;
  readonly toggleBare: () => void;
}

/** Wall seconds of hiding, and of the throttle in "Hop". */
const AWAY = 60;
const HOP = 1;

export function createActs(place: ActsPlace): Acts {
  const { live, panel } = place;
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
    state.paused = !state.paused;
    panel.press('pause', state.paused);
    panel.label('pause', state.paused ? 'Go on' : 'Pause');
    live.operate({ kind: 'pause', paused: state.paused });
    place.banner(state.paused ? 'Paused: the server stops at its next tick. O steps one substep.' : '');
  };
  const away = (wall: number) => {
    const hiding = Number.isNaN(state.awayUntil);
    state.awayUntil = hiding ? wall + AWAY : NaN;
    panel.press('away', hiding);
    live.hold(hiding);
    if (!hiding) {
      panel.label('away', 'Hide for a minute');
      place.banner('');
    }
  };
  const drop = () => {
    state.dropped = !state.dropped;
    panel.press('drop', state.dropped);
    panel.label('drop', state.dropped ? 'Connect again' : 'Drop the connection');
    if (state.dropped) live.operate({ kind: 'drop' });
    else live.reconnect();
  };
  const scenarioBy = (step: number) => {
    const at = SCENARIOS.findIndex(({ name }) => name === place.choices().scenario);
    const next = SCENARIOS[(at + step + SCENARIOS.length) % SCENARIOS.length]!;
    place.choose('scenario', next.name);
  };

  const acts: Readonly<Record<PanelAct, () => void>> = {
    restart: place.begin,
    pause,
    stepSubstep: () => {
      if (!state.paused) pause();
      live.operate({ kind: 'step', unit: 'substep' });
    },
    kick: () => live.operate({ kind: 'kick', velocity: [2, 0, 3], spin: [0, 0.35, 0] }),
    freeze: () => {
      state.frozen = !state.frozen;
      panel.press('freeze', state.frozen);
      live.operate({ kind: 'freeze', frozen: state.frozen });
    },
    drop,
    away: () => away(performance.now() / 1000),
    copyLink: place.copyLink,
    help: place.help,
    resetCamera: place.resetCamera,
    tryHop: () => {
      press(live.stick, 'throttleFull', live.flown());
      state.cutAt = live.clock.now() + HOP;
    },
    tryTopple: () => place.choose('scenario', 'topple'),
    tryLastState: () => place.choose('mode', place.choices().mode === 'last' ? 'predicted' : 'last'),
  };
  const keys: Partial<Record<Action, () => void>> = {
    restart: acts.restart,
    pause,
    stepSubstep: acts.stepSubstep,
    previousScenario: () => scenarioBy(-1),
    nextScenario: () => scenarioBy(1),
    hide: place.toggleBare,
    help: place.help,
  };

  return {
    reset,
    press(action) {
      if (isFlight(action)) {
        state.cutAt = NaN;
        press(live.stick, action, live.flown());
        live.steer();
      } else keys[action]?.();
    },
    release(action) {
      release(live.stick, action);
      if (isFlight(action)) live.steer();
    },
    act: (act) => acts[act](),
    tick(wall) {
      if (live.clock.now() >= state.cutAt) {
        state.cutAt = NaN;
        press(live.stick, 'throttleCut', live.flown());
      }
      if (Number.isNaN(state.awayUntil)) return;
      const left = Math.ceil(state.awayUntil - wall);
      if (left <= 0) away(wall);
      else {
        place.banner(`As in a hidden tab: nothing is taken or drawn for ${left} s.`);
        panel.label('away', `Back now (${left} s)`);
      }
    },
  };
}
