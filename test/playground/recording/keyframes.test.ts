import { describe, expect, it } from 'vitest';
import { createKeyframes, readEntry, type Keyframes } from '../../../src/playground/recording/keyframes';
import { createReplay } from '../../../src/playground/recording/replay';
import { recordPlay } from '../game/recordPlay';

const SHIPS = 5;
/** Frames and ships' substeps of the two wall seconds from one keyframe to the next, and one frame more. */
const FRAMES = 2 * 60 + 1;
const SUBSTEPS = (2 * 100 + 2) * SHIPS;

const recording = recordPlay({ scenario: 'bounce', others: SHIPS - 1, seconds: 40 });
const { entries } = recording;
/** Spread over the recording, the first near its end. */
const TIMES = Array.from({ length: 30 }, (_, n) => 39.9 - ((n * 7.3) % 39));

/** The computation that seeking a time of the recording takes. */
function workTo(keyframes: Keyframes, at: number) {
  const playhead = keyframes.before(at);
  const counted = () => playhead.predictor.view(playhead.shownAt).diagnosis;
  const { steppedSubsteps, replayedSubsteps } = counted();
  let frames = 0;
  while (playhead.next < entries.length && entries[playhead.next]!.at <= at) {
    if (entries[playhead.next]!.kind === 'advanced') frames++;
    readEntry(playhead, entries);
  }
  const after = counted();
  return {
    frames,
    substeps: after.steppedSubsteps - steppedSubsteps + after.replayedSubsteps - replayedSubsteps,
  };
}

describe('keyframes', () => {
  it('made in advance, leave at most two seconds to compute for any step back, the first like the others', () => {
    const keyframes = createKeyframes(recording);
    keyframes.prepare(() => false);
    const work = TIMES.map((at) => workTo(keyframes, at));
    expect(Math.max(...work.map(({ frames }) => frames))).toBeLessThanOrEqual(FRAMES);
    expect(Math.max(...work.map(({ substeps }) => substeps))).toBeLessThanOrEqual(SUBSTEPS);
    // Ships that sleep take no substeps; those in flight do.
    expect(Math.max(...work.map(({ substeps }) => substeps))).toBeGreaterThan(SHIPS * 10);
  });

  it('are the same if made in slices, each continuing where the last one stopped', () => {
    const sliced = createKeyframes(recording);
    let slices = 0;
    for (let left = 0; slices * 100 < entries.length; slices++) {
      left = 100;
      sliced.prepare(() => left-- === 0);
    }
    const whole = createKeyframes(recording);
    whole.prepare(() => false);
    for (const at of TIMES) expect(workTo(sliced, at)).toEqual(workTo(whole, at));
  });
});

describe('a replay', () => {
  it('steps back to the same pose with keyframes made in advance and without', () => {
    const prepared = createReplay(recording);
    prepared.prepare(() => false);
    const unprepared = createReplay(recording);
    for (const at of [39.5, 12.2, 25]) {
      prepared.seek(at);
      unprepared.seek(at);
      expect(prepared.step('tick', -1).own!.easedPosition).toEqual(
        unprepared.step('tick', -1).own!.easedPosition,
      );
    }
  });

  it('returns to the same position after a step forward and one back, also between two frames', () => {
    const replay = createReplay(recording);
    replay.prepare(() => false);
    for (const at of [39.5, 12.2, 25]) {
      replay.seek(at);
      const boundary = replay.step('substep', 1);
      const { generation } = replay;
      const [position, jumps] = [[...boundary.own!.easedPosition], generation()];
      // A frame of 60 Hz holds one or two substeps: some of these steps cross a frame, some do not.
      for (let n = 0; n < 4; n++) replay.step('substep', 1);
      for (let n = 0; n < 4; n++) replay.step('substep', -1);
      expect(replay.view().own!.easedPosition).toEqual(Float64Array.from(position));
      expect(generation()).toBeGreaterThanOrEqual(jumps + 4);
    }
  });
});
