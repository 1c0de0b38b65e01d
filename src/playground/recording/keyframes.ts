import { createPredictor, forkPredictor, type Predictor } from '../../prediction';
import type { Recording, RecordingEntry } from '../../scenarios';
import type { Controls } from '../../dynamics';

/** A predictor that has read the entries before `next`. */
export interface Playhead {
  readonly predictor: Predictor;
  /** Index of the next entry. */
  next: number;
  /** Client wall s of the last frame drawn; the recording's start before the first. */
  shownAt: number;
  /** Controls of that frame. */
  controls: Controls | null;
}

/** Wall seconds between two keyframes: a step back reads at most that much again. */
const INTERVAL = 2;
/** Most bytes of all keyframes, and one ship's share of a keyframe. */
const MAX_BYTES = 200e6;
const SHIP_BYTES = 22_000;

/** Copies of the predictor along a recording, so that any moment of it is found from the nearest one before. */
export interface Keyframes {
  /** A copy at the nearest keyframe at or before `at`; whatever lies before it is read first. */
  readonly before: (at: number) => Playhead;
  /** Whether a keyframe lies between two times. */
  readonly hasBetween: (from: number, to: number) => boolean;
  /** Reads on until `isOver` returns true or the recording ends. */
  readonly prepare: (isOver: () => boolean) => void;
}

export function createKeyframes({ entries, header }: Recording): Keyframes {
  const from = entries[0]?.at ?? 0;
  const to = entries.at(-1)?.at ?? from;
  const interval = Math.max(INTERVAL, (to - from) / mostKeyframes(entries));
  let ahead: Playhead = {
    predictor: createPredictor({ ownShipId: header.shipId, plan: header.plan ?? [] }),
    next: 0,
    shownAt: from,
    controls: null,
  };
  const keyframes: Playhead[] = [copyPlayhead(ahead)];
  const readOne = () => {
    const isDrawn = entries[ahead.next]!.kind === 'advanced';
    readEntry(ahead, entries);
    if (!isDrawn || ahead.shownAt - keyframes.at(-1)!.shownAt < interval) return;
    // Continues with the copy: the code that reads ahead is then compiled for the same records as a step back.
    keyframes.push(ahead);
    ahead = copyPlayhead(ahead);
  };
  return {
    prepare(isOver) {
      while (ahead.next < entries.length && !isOver()) readOne();
    },
    before(at) {
      while (ahead.next < entries.length && entries[ahead.next]!.at <= at) readOne();
      return copyPlayhead(keyframes.findLast(({ shownAt }) => shownAt <= at) ?? keyframes[0]!);
    },
    hasBetween: (after, at) => keyframes.some(({ shownAt }) => shownAt > after && shownAt <= at),
  };
}

/** As many as the memory holds for the largest frame of the recording. */
function mostKeyframes(entries: readonly RecordingEntry[]): number {
  let ships = 1;
  for (const entry of entries)
    if (entry.kind === 'received' && entry.message.kind === 'frame')
      ships = Math.max(ships, entry.message.ships.length);
  return Math.max(1, MAX_BYTES / (ships * SHIP_BYTES));
}

export function copyPlayhead(playhead: Playhead): Playhead {
  return { ...playhead, predictor: forkPredictor(playhead.predictor) };
}

/** Feeds the next entry, exactly as it went through the predictor when it was recorded. */
export function readEntry(playhead: Playhead, entries: readonly RecordingEntry[]): void {
  const entry = entries[playhead.next++]!;
  const { predictor } = playhead;
  if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
  if (entry.kind !== 'advanced') return;
  predictor.advance(entry.controls, entry.at);
  predictor.view(entry.at);
  predictor.takeOutgoing();
  playhead.shownAt = entry.at;
  playhead.controls = entry.controls;
}
