import type { ActionTargets } from './actionTargets';
import type { SavedControls } from '../flight/flightControls';

/** Wall seconds of hiding, and of a lag spike. */
const AWAY = 60;
const SPIKE = 1.5;
/** Kick of the player's ship: [east, north, up], m/s and rad/s. */
const KICK = { velocity: [2, 0, 3], spin: [0, 0.35, 0] } as const;

/** Commands of the built-in server's operator. */
export interface OperatorActions {
  readonly pause: () => void;
  readonly stepSubstep: () => void;
  readonly kick: () => void;
  readonly spike: () => void;
  readonly freeze: () => void;
  readonly drop: () => void;
  readonly away: () => void;
  readonly snapshot: () => void;
  readonly restore: () => void;
  readonly drag: () => void;
  readonly tick: (wall: number) => void;
  readonly reset: () => void;
}

interface OperatorState {
  isPaused: boolean;
  isFrozen: boolean;
  isDropped: boolean;
  awayUntil: number;
  /** The pilot's controls of the snapshot; the server keeps the ships. */
  saved: SavedControls | null;
}

const AT_FIRST: OperatorState = {
  isPaused: false,
  isFrozen: false,
  isDropped: false,
  awayUntil: NaN,
  saved: null,
};

type OperatorTargets = Pick<
  ActionTargets,
  'live' | 'panel' | 'banner' | 'choices' | 'markIntervention' | 'toggleDrag' | 'deck'
>;

/** The operator's commands; while a recording plays, the game behind it takes none. */
export function createOperatorActions(targets: OperatorTargets): OperatorActions {
  const { reset, tick, ...actions } = actionsOf(targets);
  const guarded = Object.entries(actions).map(([name, action]) => [
    name,
    () => {
      if (targets.deck.replay() === null) action();
      else targets.banner.flash('A recording is playing: go back to the game first.');
    },
  ]);
  return { ...(Object.fromEntries(guarded) as typeof actions), reset, tick };
}

function actionsOf(targets: OperatorTargets): OperatorActions {
  const { live, panel, banner } = targets;
  const state = { ...AT_FIRST };
  const pause = () => togglePause(targets, state);
  return {
    ...networkActions(targets, state),
    ...shipActions(targets, state),
    pause,
    stepSubstep() {
      if (isRemote(targets)) return;
      if (!state.isPaused) pause();
      targets.markIntervention('it was stepped');
      live.operate({ kind: 'step', unit: 'substep' });
    },
    reset() {
      Object.assign(state, AT_FIRST);
      live.suspend(false);
      for (const action of ['pause', 'freeze', 'drop', 'away'] as const) panel.press(action, false);
      panel.label('pause', 'Pause');
      panel.label('drop', 'Drop the connection');
      panel.label('away', 'Hide for a minute');
    },
    tick(wall) {
      if (Number.isNaN(state.awayUntil)) return;
      const left = Math.ceil(state.awayUntil - wall);
      if (left <= 0) toggleAway(targets, state, wall);
      else {
        banner.state(`Simulating a hidden tab: nothing received or drawn for ${left} s.`);
        panel.label('away', `Back now (${left} s)`);
      }
    },
  };
}

function networkActions(targets: OperatorTargets, state: OperatorState) {
  const { live, panel, banner } = targets;
  return {
    spike() {
      live.operate({ kind: 'spike', seconds: SPIKE });
      banner.flash(`Lag spike: nothing arrives for ${SPIKE} s.`);
    },
    freeze() {
      state.isFrozen = !state.isFrozen;
      panel.press('freeze', state.isFrozen);
      live.operate({ kind: 'freeze', frozen: state.isFrozen });
    },
    drop() {
      state.isDropped = !state.isDropped;
      panel.press('drop', state.isDropped);
      panel.label('drop', state.isDropped ? 'Reconnect' : 'Drop the connection');
      if (state.isDropped) live.operate({ kind: 'drop' });
      else live.reconnect();
    },
    away: () => toggleAway(targets, state, performance.now() / 1000),
  };
}

function shipActions(
  { live, panel, banner, markIntervention, toggleDrag }: OperatorTargets,
  state: OperatorState,
) {
  return {
    kick() {
      markIntervention('the ship was kicked');
      live.operate({ kind: 'kick', ...KICK });
    },
    snapshot() {
      state.saved = live.flightControls.save();
      live.operate({ kind: 'snapshot' });
      banner.flash('Snapshot taken. Restore puts back every ship, your throttle and your modes.');
    },
    restore() {
      markIntervention('a snapshot was restored');
      live.operate({ kind: 'restore' });
      if (state.saved === null) return;
      live.flightControls.restore(state.saved);
      live.steer();
    },
    drag() {
      const isOn = toggleDrag();
      panel.press('drag', isOn);
      if (isOn) markIntervention('the ship was moved');
      banner.flash(isOn ? 'Drag over the picture to move the ship.' : 'Dragging turns the camera again.');
    },
  };
}

function togglePause(targets: OperatorTargets, state: OperatorState): void {
  const { live, panel, banner } = targets;
  if (isRemote(targets)) return;
  state.isPaused = !state.isPaused;
  panel.press('pause', state.isPaused);
  panel.label('pause', state.isPaused ? 'Resume' : 'Pause');
  live.flightControls.setPaused(state.isPaused);
  live.operate({ kind: 'pause', paused: state.isPaused });
  banner.state(state.isPaused ? 'Paused: the server stops at its next tick. O steps one substep.' : '');
}

function toggleAway({ live, panel, banner }: OperatorTargets, state: OperatorState, wall: number): void {
  const isHiding = Number.isNaN(state.awayUntil);
  state.awayUntil = isHiding ? wall + AWAY : NaN;
  panel.press('away', isHiding);
  live.suspend(isHiding);
  if (isHiding) return;
  panel.label('away', 'Hide for a minute');
  banner.state('');
}

/** Reports that a real server takes no commands. */
export function isRemote({ choices, banner }: Pick<ActionTargets, 'choices' | 'banner'>): boolean {
  if (choices().server === '') return false;
  banner.flash('Only available with the built-in server.');
  return true;
}
