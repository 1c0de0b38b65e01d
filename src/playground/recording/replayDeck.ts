import { timingOfTick } from '../../dynamics';
import type { WorldView } from '../../prediction';
import type { Recording } from '../../scenarios';
import type { RecordingListeners, RecordingPanel } from './recordingPanel';
import type { Replay, StepUnit } from './replay';

/** Plays one replay: at its speed, by seeking, or step by step. */
export interface ReplayDeck {
  readonly replay: () => Replay | null;
  /** The recording that plays; null without one. */
  readonly recording: () => Recording | null;
  readonly insert: (recording: Recording, replay: Replay) => void;
  readonly eject: () => void;
  readonly togglePlay: () => void;
  readonly step: (unit: StepUnit, direction: 1 | -1) => void;
  readonly controls: Pick<RecordingListeners, 'seek' | 'play' | 'step'>;
  /** The replay's view after `seconds` of playing, once a frame; null without a replay. */
  readonly frame: (seconds: number) => WorldView | null;
}

/** ms of a frame that go into keyframes for later steps back. */
const PREPARING = 6;

export function createReplayDeck(panel: () => RecordingPanel): ReplayDeck {
  let inserted: { readonly recording: Recording; readonly replay: Replay } | null = null;
  let isPlaying = true;
  const replay = () => inserted?.replay ?? null;
  const seek = (at: number) => {
    isPlaying = false;
    replay()?.seek(at);
  };
  const play = (next: boolean) => {
    isPlaying = next;
    const playing = replay();
    if (isPlaying && playing !== null && playing.position() >= playing.to) playing.seek(playing.from);
  };
  const step = (unit: StepUnit, direction: 1 | -1) => {
    isPlaying = false;
    replay()?.step(unit, direction);
  };
  return {
    replay,
    recording: () => inserted?.recording ?? null,
    insert(recording, next) {
      inserted = { recording, replay: next };
      isPlaying = true;
    },
    eject() {
      inserted = null;
    },
    togglePlay: () => play(!isPlaying),
    step,
    controls: { seek, play, step },
    frame(seconds) {
      const playing = replay();
      if (playing === null) return null;
      const until = performance.now() + PREPARING;
      playing.prepare(() => performance.now() > until);
      const view = isPlaying ? playing.seek(playing.position() + seconds) : playing.view();
      if (playing.position() >= playing.to) isPlaying = false;
      panel().showPosition(playing.position(), isPlaying, placeOf(view));
      return view;
    },
  };
}

/** The position of a view in its tick, in words: the end of a tick is the beginning of the next. */
export function placeOf({ tick, sinceTick, tickRate, timeScale, settings }: WorldView): string {
  const { dt, substeps } = timingOfTick(timeScale / tickRate, settings.contactLongestSubstep);
  const substep = Math.round(sinceTick / dt);
  return substep === substeps ? `tick ${tick + 1}, substep 0` : `tick ${tick}, substep ${substep}`;
}
