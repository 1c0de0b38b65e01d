/** A recording's contents: each entry unchanged, up to its bounds; the oldest entries are dropped first. */
import { expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createRecorder } from '../../../src/playground/recording/recorder';
import type { RecordingEntry } from '../../../src/scenarios';
import { encodeServerMessage, type ServerFrame, type ServerMessage } from '../../../src/wire';

const advanced = (at: number, controls: Controls | null = null): RecordingEntry => ({
  kind: 'advanced',
  at,
  controls,
});
const received = (at: number, message: object): RecordingEntry => ({
  kind: 'received',
  at,
  message: message as ServerMessage,
});
/** Not whole, so kept as it is. */
const partial = (at: number, ships = 0) =>
  received(at, { kind: 'frame', tick: at, ships: Array.from({ length: ships }, () => ({})) });
const frameAt = (tick: number): ServerFrame => ({
  ...{ kind: 'frame', tick, tickRate: 1, timeScale: 1, paused: false },
  ...{ bodies: [], ships: [], events: [], lastInput: null },
});
const whole = (at: number) => received(at, frameAt(at));

it('keeps all entries, with the plan and a note', () => {
  const recorder = createRecorder();
  expect([recorder.seconds(), recorder.hasDropped()]).toEqual([0, false]);
  const plan = [{ at: 1 }] as never;
  recorder.begin(plan);
  const entries = [received(10, { kind: 'hello' }), partial(11, 2), advanced(12.5, NEUTRAL_CONTROLS)];
  for (const entry of entries) recorder.take(entry);
  expect(recorder.recording('a note')).toEqual({ header: { note: 'a note', shipId: 'own', plan }, entries });
  expect([recorder.seconds(), recorder.hasDropped()]).toEqual([2.5, false]);
  recorder.begin([]);
  expect([recorder.seconds(), recorder.recording('').entries]).toEqual([0, []]);
});

it('keeps one object for controls that are held, and another for any that differ', () => {
  const held = { ...NEUTRAL_CONTROLS, thrustLevel: 0.5 };
  const changes: Partial<Controls>[] = [
    ...[{ thrustLevel: 0.6 }, { attitudeHold: true }, { attitudeMode: 'hold' as const }],
    ...[{ translationInput: [0, 0, 1] as const }, { rotationInput: [0, -1, 0] as const }],
    { targetAttitude: [0, 0, 1, 0] },
    { translationInput: [0, 0, -0] },
  ];
  for (const change of changes) {
    const recorder = createRecorder();
    recorder.take(advanced(1, held));
    recorder.take(advanced(2, { ...held, rotationInput: [...held.rotationInput] }));
    recorder.take(advanced(3, { ...held, ...change }));
    recorder.take(advanced(4, null));
    recorder.take(advanced(5, null));
    const [first, same, other, none, still] = recorder
      .recording('')
      .entries.map((entry) => (entry.kind === 'advanced' ? entry.controls : undefined));
    expect(first).toBe(held);
    expect(same).toBe(first);
    expect(other, JSON.stringify(change)).toEqual({ ...held, ...change });
    expect([none, still]).toEqual([null, null]);
  }
});

it('packs complete frames and restores them unchanged', () => {
  const recorder = createRecorder();
  recorder.take(whole(7));
  const [entry] = recorder.recording('').entries;
  expect(entry).toEqual(whole(7));
  expect(entry).not.toBe(recorder.recording('').entries[0]);
});

it('keeps the received bytes of a frame instead of encoding it again', () => {
  const recorder = createRecorder();
  const entry = whole(7);
  recorder.take(entry, encodeServerMessage(frameAt(8)));
  expect(recorder.recording('').entries).toEqual([{ ...entry, message: frameAt(8) }]);
});

it('drops the oldest entries beyond 14 MB, down to nine tenths, and begins with a frame and its hello', () => {
  const recorder = createRecorder();
  const hello = received(0, { kind: 'hello', tickRate: 1 });
  // B: an entry has 60, of other kinds than held controls also 250, and 1000 a ship; a packed frame has 200 beside its own.
  const packed = 200 + encodeServerMessage(frameAt(1)).length;
  const left = 14_000_000 - 16 * (60 + 250) - 2 * packed;
  const slack = (held: number) => (left - 60 * held) % 1000;
  const held = Array.from({ length: 50 }, (_, i) => i).reduce((best, n) =>
    slack(n) < slack(best) ? n : best,
  );
  const ships = Math.floor((left - 60 * held) / 1000);
  for (const entry of [hello, partial(1, 1000), whole(1), partial(2, 1000), whole(2)]) recorder.take(entry);
  for (let at = 3; at <= 13; at++) recorder.take(partial(at, 1000));
  recorder.take(partial(14, ships - 13_000));
  for (let n = 0; n <= held; n++) recorder.take(advanced(15, NEUTRAL_CONTROLS));
  expect(recorder.hasDropped()).toBe(false);
  expect(recorder.recording('').entries).toHaveLength(18 + held);
  recorder.take(advanced(16, NEUTRAL_CONTROLS));
  expect(recorder.hasDropped()).toBe(true);
  const { entries } = recorder.recording('');
  // The first million is not enough, so the frame after the second is the first that is left.
  expect(entries.map(({ at }) => at).slice(0, 4)).toEqual([2, 2, 3, 4]);
  expect(entries.slice(0, 2)).toEqual([{ ...hello, at: 2 }, whole(2)]);
  expect(recorder.seconds()).toBe(14);
  recorder.begin([]);
  recorder.take(partial(20));
  expect([recorder.hasDropped(), recorder.recording('').entries]).toEqual([false, [partial(20)]]);
});

it('keeps the newest entry, however large', () => {
  const recorder = createRecorder();
  recorder.take(partial(1));
  recorder.take(partial(2, 14_000));
  expect(recorder.recording('').entries.map(({ at }) => at)).toEqual([2]);
});
