import type { ActsPlace } from './actsPlace';

/** Wall seconds of hiding, and of a lag spike. */
const AWAY = 60;
const SPIKE = 1.5;

/** Commands of the built-in server's operator. */
export interface OperatorActs {
  readonly pause: () => void;
  readonly stepSubstep: () => void;
  readonly kick: () => void;
  readonly spike: () => void;
  readonly freeze: () => void;
  readonly drop: () => void;
  readonly away: () => void;
  readonly snapshot: () => void;
  readonly restore: () => void;
  readonly carry: () => void;
  readonly tick: (wall: number) => void;
  readonly reset: () => void;
}

interface OperatorState {
  isPaused: boolean;
  isFrozen: boolean;
  isDropped: boolean;
  awayUntil: number;
}

const AT_FIRST: OperatorState = { isPaused: false, isFrozen: false, isDropped: false, awayUntil: NaN };

type OperatorPlace = Pick<
  ActsPlace,
  'live' | 'panel' | 'banner' | 'choices' | 'meddled' | 'toggleCarry' | 'deck'
>;

/** The operator's commands; while a recording plays, the game behind it takes none. */
export function createOperatorActs(place: OperatorPlace): OperatorActs {
  const { reset, tick, ...acts } = actsOf(place);
  const guarded = Object.entries(acts).map(([name, act]) => [
    name,
    () => {
      if (place.deck.replay() === null) act();
      else place.banner.flash('A recording plays: go back to the game first.');
    },
  ]);
  return { ...(Object.fromEntries(guarded) as typeof acts), reset, tick };
}

function actsOf(place: OperatorPlace): OperatorActs {
  const { live, panel, banner } = place;
  const state = { ...AT_FIRST };
  const pause = () => togglePause(place, state);
  return {
    ...networkActs(place, state),
    ...shipActs(place),
    pause,
    stepSubstep() {
      if (isRemote(place)) return;
      if (!state.isPaused) pause();
      place.meddled('it was stepped');
      live.operate({ kind: 'step', unit: 'substep' });
    },
    reset() {
      Object.assign(state, AT_FIRST);
      live.hold(false);
      for (const act of ['pause', 'freeze', 'drop', 'away'] as const) panel.press(act, false);
      panel.label('pause', 'Pause');
      panel.label('drop', 'Drop the connection');
      panel.label('away', 'Hide for a minute');
    },
    tick(wall) {
      if (Number.isNaN(state.awayUntil)) return;
      const left = Math.ceil(state.awayUntil - wall);
      if (left <= 0) toggleAway(place, state, wall);
      else {
        banner.state(`Simulating a hidden tab: nothing received or drawn for ${left} s.`);
        panel.label('away', `Back now (${left} s)`);
      }
    },
  };
}

function networkActs(place: OperatorPlace, state: OperatorState) {
  const { live, panel, banner } = place;
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
    away: () => toggleAway(place, state, performance.now() / 1000),
  };
}

function shipActs({ live, panel, banner, meddled, toggleCarry }: OperatorPlace) {
  return {
    kick() {
      meddled('the ship was kicked');
      live.operate({ kind: 'kick', velocity: [2, 0, 3], spin: [0, 0.35, 0] });
    },
    snapshot() {
      live.operate({ kind: 'snapshot' });
      banner.flash('Snapshot taken. Restore puts every ship back.');
    },
    restore() {
      meddled('a snapshot was restored');
      live.operate({ kind: 'restore' });
    },
    carry() {
      const isOn = toggleCarry();
      panel.press('carry', isOn);
      if (isOn) meddled('the ship was moved');
      banner.flash(isOn ? 'Drag over the picture to move the ship.' : 'Dragging turns the camera again.');
    },
  };
}

function togglePause(place: OperatorPlace, state: OperatorState): void {
  const { live, panel, banner } = place;
  if (isRemote(place)) return;
  state.isPaused = !state.isPaused;
  panel.press('pause', state.isPaused);
  panel.label('pause', state.isPaused ? 'Resume' : 'Pause');
  live.hands.rest(state.isPaused);
  live.operate({ kind: 'pause', paused: state.isPaused });
  banner.state(state.isPaused ? 'Paused: the server stops at its next tick. O steps one substep.' : '');
}

function toggleAway({ live, panel, banner }: OperatorPlace, state: OperatorState, wall: number): void {
  const isHiding = Number.isNaN(state.awayUntil);
  state.awayUntil = isHiding ? wall + AWAY : NaN;
  panel.press('away', isHiding);
  live.hold(isHiding);
  if (isHiding) return;
  panel.label('away', 'Hide for a minute');
  banner.state('');
}

/** A real server takes no commands; the page says so. */
export function isRemote({ choices, banner }: Pick<ActsPlace, 'choices' | 'banner'>): boolean {
  if (choices().server === '') return false;
  banner.flash('Only available with the built-in server.');
  return true;
}
