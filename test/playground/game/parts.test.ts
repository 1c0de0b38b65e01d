import { describe, expect, it } from 'vitest';
import { createPageClock } from '../../../src/playground/game/live/pageClock';
import { createRecorder } from '../../../src/playground/recording/recorder';
import { axisRange } from '../../../src/playground/panels/workshop/plots';
import { createReplay } from '../../../src/playground/recording/replay';
import { createSamples, summarise } from '../../../src/playground/game/samples';
import { createPredictor, type WorldView } from '../../../src/prediction';
import { readRecording, type RecordingEntry, writeRecording } from '../../../src/scenarios';
import type { PartialFrame } from '../../../src/wire';
import { type Play, recordPlay } from './recordPlay';

describe('page clock', () => {
  it('changes its speed without a jump, within 0.1 to 4', () => {
    let wall = 100;
    const clock = createPageClock(() => wall);
    wall = 110;
    expect(clock.now()).toBe(110);
    clock.setSpeed(0.25);
    expect(clock.now()).toBe(110);
    wall = 114;
    expect(clock.now()).toBe(111);
    clock.setSpeed(5);
    clock.setSpeed(NaN);
    expect(clock.speed()).toBe(0.25);
  });
});

describe('a plot', () => {
  it('scales its axis to the data: errors of zero are not drawn on an axis from 1 to 100', () => {
    const errors = { base: 0, least: 0.001 };
    expect(axisRange(errors, 0, 0)[1]).toBeLessThan(0.0011);
    expect(axisRange(errors, NaN, NaN)).toEqual(axisRange(errors, 0, 0));
    expect(axisRange(errors, 0.2, 4)[0]).toBe(0);
    expect(axisRange(errors, 0.2, 4)[1]).toBeCloseTo(4.2, 12);
    expect(axisRange({ base: 1, least: 0.001 }, 0.98, 0.99)[0]).toBe(0.98);
  });
});

describe('figures', () => {
  it('are last, mean, 95th percentile and largest of the finite values', () => {
    const values = Array.from({ length: 100 }, (_, i) => i + 1);
    expect(summarise([...values, NaN])).toEqual({ last: 100, mean: 50.5, p95: 95, max: 100 });
    expect(summarise([NaN]).max).toBeNaN();
  });

  it('are sampled ten times per second and kept for thirty seconds', () => {
    const samples = createSamples();
    const { diagnosis } = createPredictor().view(0);
    let taken = 0;
    for (let n = 0; n < 60 * 40; n++)
      taken += samples.take({ ...diagnosis, roundTrip: n / 1000 }, n / 60) ? 1 : 0;
    expect(taken).toBeGreaterThan(340);
    expect(taken).toBeLessThanOrEqual(401);
    const times = samples.times();
    expect(times).toHaveLength(300);
    expect(times.every((time, i) => i === 0 || time > times[i - 1]!)).toBe(true);
    expect(samples.values(0).at(-1)).toBeGreaterThan(2390);
  });
});

/** A recorded landing, and the pose of each of its frames. */
function play(seconds: number, before: NonNullable<Play['before']>) {
  const poses: number[] = [];
  const onView = (view: WorldView) => poses.push(poseOf(view));
  const recording = recordPlay({ scenario: 'settle', others: 0, seconds, before, onView });
  return { recording, poses };
}

function poseOf(view: WorldView): number {
  return view.own === null ? NaN : view.own.easedPosition.reduce((sum, value, i) => sum + value * (i + 1), 0);
}

type FrameEntry = Extract<RecordingEntry, { kind: 'received' }> & { readonly message: PartialFrame };

function isFrame(entry: RecordingEntry): entry is FrameEntry {
  return entry.kind === 'received' && entry.message.kind === 'frame';
}

describe('a recorder', () => {
  it('drops the oldest at a bound of bytes: of a fleet of a thousand the last hundred frames are kept, of one ship all', () => {
    const { recording } = play(2, () => undefined);
    const frame = recording.entries.find(isFrame)!;
    const { message } = frame;
    const ships = Array.from({ length: 1000 }, (_, n) => ({ ...message.ships[0]!, shipId: `ship-${n}` }));
    const recorder = createRecorder();
    recorder.begin([]);
    for (let n = 0; n < 200; n++) recorder.take({ ...frame, at: n, message: { ...message, tick: n, ships } });
    expect(recorder.hasDropped()).toBe(true);
    const kept = recorder.recording('').entries;
    expect(kept.length).toBeLessThan(120);
    expect(kept.at(-1)!.at).toBe(199);
    expect(recorder.seconds()).toBe(kept.length - 1);
    recorder.begin([]);
    for (let n = 0; n < 1000; n++) recorder.take(frame);
    expect(recorder.hasDropped()).toBe(false);
    expect(recorder.recording('').entries).toHaveLength(1000);
  });

  it('that has dropped its beginning still replays to the poses of the flight', () => {
    const { recording, poses } = play(12, () => undefined);
    const recorder = createRecorder();
    recorder.begin([]);
    // A fleet's frames between the first seconds and the rest push the beginning out; their world is another.
    const begun = recording.entries.filter(({ at }) => at < 3);
    const { message, ...frame } = recording.entries.find(isFrame)!;
    const ships = Array.from({ length: 1000 }, (_, n) => ({ ...message.ships[0]!, shipId: `ship-${n}` }));
    for (const entry of begun) recorder.take(entry);
    for (let n = 0; n < 70; n++) recorder.take({ ...frame, at: 3, message: { ...message, ships } });
    for (const entry of recording.entries.slice(begun.length)) recorder.take(entry);
    expect(recorder.hasDropped()).toBe(true);
    const { header, entries } = recorder.recording('');
    const first = entries.findIndex((entry) => isFrame(entry) && entry.message.ships.length === 1);
    const replay = createReplay({ header, entries: [entries[0]!, ...entries.slice(first)] });
    expect(entries[0]).toMatchObject({ kind: 'received', message: { kind: 'hello' } });
    // Its clock began anew, 0.1 s apart at most, and the ground turns at 4.6 m/s.
    expect(Math.abs(poseOf(replay.seek(11)) - poses[660]!)).toBeLessThan(1);
    expect(replay.view().own!.shownState).toBe('landed');
  });

  it('returns the frames, controls and messages that it recorded', () => {
    const { recording } = play(4, () => undefined);
    const recorder = createRecorder();
    recorder.begin([]);
    for (const entry of recording.entries) recorder.take(entry);
    expect(recorder.recording('').entries).toEqual(recording.entries);
  });
});

describe('replay', () => {
  it('shows each moment as recorded, forward and backward, also from a file', () => {
    const { recording, poses } = play(6, () => undefined);
    const read = readRecording(writeRecording(recording));
    if (!read.ok) throw new Error(read.reason);
    const replay = createReplay(read.value);
    expect(replay.divergence).toMatchObject({ at: null });
    expect(replay.divergence.words).toMatch(/^No divergence: \d+ states/);
    for (const n of [40, 41, 200, 130, 359, 60, 61])
      expect(poseOf(replay.seek(n / 60 + 1e-9))).toBe(poses[n]);
    expect(replay.generation()).toBeGreaterThan(2);
  });

  it('steps to the next tick and substep, forward and back, with the same pose both ways', () => {
    const { recording } = play(6, () => undefined);
    const replay = createReplay(recording);
    replay.seek(2.5);
    const label = ({ tick, sinceTick }: WorldView) => tick + sinceTick;
    const ways = ['tick', 'substep'] as const;
    for (const unit of ways) {
      const size = unit === 'tick' ? 1 : 0.01;
      const start = label(replay.step(unit, 1));
      expect(start / size).toBeCloseTo(Math.round(start / size), 2);
      const seen = [poseOf(replay.view())];
      for (let n = 1; n <= 2; n++) {
        const view = replay.step(unit, 1);
        expect(label(view)).toBeCloseTo(start + n * size, 4);
        seen.push(poseOf(view));
      }
      for (let n = 1; n >= 0; n--) {
        const view = replay.step(unit, -1);
        expect(label(view)).toBeCloseTo(start + n * size, 4);
        expect(poseOf(view) / seen[n]!).toBeCloseTo(1, 9);
      }
    }
    expect(replay.step('tick', -1).own).not.toBeNull();
    for (let n = 0; n < 20; n++) replay.step('tick', -1);
    expect(replay.position()).toBe(replay.from);
  });

  it('finds every moment from keyframes made in advance', () => {
    const { recording, poses } = play(12, () => undefined);
    const replay = createReplay(recording);
    replay.prepare(() => false);
    for (const n of [700, 10, 360, 359, 239, 121]) expect(poseOf(replay.seek(n / 60 + 1e-9))).toBe(poses[n]);
  });

  it('marks the first divergence where the server left the law', () => {
    let kicked = false;
    const { recording } = play(8, (session, now) => {
      if (kicked || now < 3.5) return;
      kicked = true;
      expect(session.operate({ kind: 'kick', velocity: [2, 0, 3], spin: [0, 0.35, 0] }, now)).toBeNull();
    });
    const { divergence } = createReplay(recording);
    expect(divergence.words).toMatch(/^First divergence at tick 4: /);
    expect(divergence.at).toBeGreaterThan(4);
    expect(divergence.at).toBeLessThan(4.2);
  });
});
