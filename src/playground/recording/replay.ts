import { timingOfTick } from '../../dynamics';
import type { WorldView } from '../../prediction';
import { compareRecording, type Recording, type RecordingEntry } from '../../scenarios';
import { type Baseline, createBaseline } from '../game/live/baseline';
import { copyPlayhead, createKeyframes, type Playhead, readEntry } from './keyframes';

export type StepUnit = 'substep' | 'tick';

/** A recording being played: predictors read the recorded input again, so that every moment is the same. */
export interface Replay {
  /** Wall seconds of the recording. */
  readonly from: number;
  readonly to: number;
  readonly baseline: Baseline;
  readonly divergence: Divergence;
  /** The frame that was drawn last at a time. */
  readonly seek: (at: number) => WorldView;
  /** Forward (+1) or back (−1) to the next boundary of a tick or substep. */
  readonly step: (unit: StepUnit, direction: 1 | -1) => WorldView;
  /** The last result of `seek` or `step`. */
  readonly view: () => WorldView;
  readonly position: () => number;
  /** Counts jumps and skips: readouts with memory must start again after each. */
  readonly generation: () => number;
  /** Makes keyframes ahead until `isOver` returns true. */
  readonly prepare: (isOver: () => boolean) => void;
}

export interface Divergence {
  /** Wall seconds of the recording, or null: the recorded server followed the dynamics throughout. */
  readonly at: number | null;
  readonly words: string;
}

/** Wall seconds: a longer move ahead than a frame of playing starts from a keyframe. */
const JUMP = 1;

export function createReplay(recording: Recording): Replay {
  const { entries } = recording;
  const keyframes = createKeyframes(recording);
  const from = entries[0]?.at ?? 0;
  const to = entries.at(-1)?.at ?? from;
  const baseline = createBaseline();
  let generation = 1;
  let playhead = keyframes.before(from);
  let position = from;
  let view = playhead.predictor.view(from);

  const moveTo = (at: number) => {
    const wanted = Math.min(Math.max(at, from), to);
    const isUndone = playhead.next > 0 && entries[playhead.next - 1]!.at > wanted;
    const isSkip = isUndone || keyframes.hasBetween(playhead.shownAt + JUMP, wanted);
    if (isSkip || wanted < position) generation++;
    position = wanted;
    // No entry lies between: the same predictor serves.
    if (isSkip) goFrom(keyframes.before(wanted));
    while (playhead.next < entries.length && entries[playhead.next]!.at <= wanted) {
      const entry = entries[playhead.next]!;
      readEntry(playhead, entries);
      if (isFrame(entry)) baseline.take(entry.message, entry.at);
    }
  };
  const goFrom = (keyframe: Playhead) => {
    playhead = keyframe;
    baseline.forget();
    const frame = lastFrameBefore(entries, playhead.next);
    if (frame !== null) baseline.take(frame.message, frame.at);
  };
  return {
    from,
    to,
    baseline,
    divergence: findDivergence(recording),
    position: () => position,
    generation: () => generation,
    prepare: keyframes.prepare,
    view: () => view,
    seek(at) {
      moveTo(at);
      // No picture was drawn between two frames: the earlier one's stays.
      view = playhead.predictor.view(playhead.shownAt);
      return view;
    },
    step(unit, direction) {
      for (let tries = 0; tries < MAX_TRIES; tries++) {
        const off = secondsTo(view, unit, tries === 0 ? direction : 0);
        if (Math.abs(off) < CLOSE) break;
        moveTo(position + off);
        view = viewBetween(playhead, position);
      }
      return view;
    },
  };
}

/** A step's first try is off by the clock's steering in between, a fraction of a per cent. */
const MAX_TRIES = 2;
/** Differences in wall time up to this are not visible, s. */
const CLOSE = 1e-5;

type FrameEntry = Extract<RecordingEntry, { kind: 'received' }> & {
  readonly message: { readonly kind: 'frame' };
};

function isFrame(entry: RecordingEntry): entry is FrameEntry {
  return entry.kind === 'received' && entry.message.kind === 'frame';
}

function lastFrameBefore(entries: readonly RecordingEntry[], next: number): FrameEntry | null {
  for (let i = next - 1; i >= 0; i--) {
    const entry = entries[i]!;
    if (isFrame(entry)) return entry;
  }
  return null;
}

/** The view at a time between two recorded frames: of a copy, so that the recorded ones stay as they were. */
function viewBetween(playhead: Playhead, at: number): WorldView {
  if (at <= playhead.shownAt) return playhead.predictor.view(playhead.shownAt);
  const { predictor, controls } = copyPlayhead(playhead);
  predictor.advance(controls, at);
  return predictor.view(at);
}

/** Wall seconds from a view to the boundary that is `direction` boundaries away; 0: to the nearest. Paused, time is wall time. */
function secondsTo(view: WorldView, unit: StepUnit, direction: -1 | 0 | 1): number {
  const { sinceTick, tickRate, timeScale, paused, settings, diagnosis } = view;
  const { tickSeconds, dt } = timingOfTick(timeScale / tickRate, settings.contactLongestSubstep);
  const span = unit === 'tick' ? tickSeconds : dt;
  const share = sinceTick / span;
  const isAt = Math.abs(share - Math.round(share)) < ON_BOUNDARY;
  const target =
    direction === 0 || isAt
      ? Math.round(share) + direction
      : direction > 0
        ? Math.ceil(share)
        : Math.floor(share);
  const wall = ((target - share) * span) / timeScale;
  return paused ? direction / tickRate : wall / (diagnosis.clockRate || 1);
}

/** Share of a span within which a position counts as on the boundary. */
const ON_BOUNDARY = 0.02;

/** The first tick at which the recorded server left the dynamics. */
function findDivergence(recording: Recording): Divergence {
  const compared = compareRecording(recording);
  if (!compared.ok) return { at: null, words: `Nothing to check against the physics: ${compared.reason}.` };
  const { outOfTolerance, disagreement, statesCompared } = compared.value;
  const first = Math.min(outOfTolerance?.tick ?? Infinity, disagreement?.tick ?? Infinity);
  if (first === Infinity)
    return { at: null, words: `No divergence: ${statesCompared} states match the physics.` };
  const how =
    disagreement?.tick === first ? disagreement.how : `${outOfTolerance?.field ?? 'state'} out of tolerance`;
  const entry = recording.entries.find((each) => isFrame(each) && each.message.tick >= first);
  return { at: entry?.at ?? null, words: `First divergence at tick ${first}: ${how}.` };
}
