import type { Controls } from '../../dynamics';
import type { Recording, RecordingEntry, ScheduledInput } from '../../scenarios';
import { decodeServerMessage, encodeServerMessage, type PartialFrame, type ServerFrame } from '../../wire';

/** Bytes of memory that a recording takes at most: the last hour of one ship, or the last four minutes of 200 ships at 1 Hz. */
const MAX_BYTES = 14_000_000;
/** Bytes of an entry, of a set of controls, and of each ship in a frame that is not packed. */
const ENTRY_BYTES = 60;
const CONTROLS_BYTES = 250;
const SHIP_BYTES = 1000;
/** Bytes of a packed frame besides its contents: the array and its record. */
const PACKED_BYTES = 200;

/** Share of the bound that remains after dropping the oldest entries, so that drops are rare. */
const LEFT = 0.9;

/** Records the predictor's input, bounded in bytes: the oldest entries are dropped first. */
export interface Recorder {
  /** `bytes`: of a received message, if it is exactly what they decode to. */
  readonly take: (entry: RecordingEntry, bytes?: Uint8Array) => void;
  /** A new world, and the scheduled inputs of the player's ship in it. */
  readonly begin: (plan: readonly ScheduledInput[]) => void;
  readonly seconds: () => number;
  /** Entries were dropped: the recording no longer begins with its world. */
  readonly hasDropped: () => boolean;
  readonly recording: (note: string) => Recording;
}

/** A whole frame as the protocol's bytes: a fifth of the size of its records. */
interface PackedFrame {
  readonly kind: 'packed';
  readonly at: number;
  readonly bytes: Uint8Array;
}

type Kept = RecordingEntry | PackedFrame;

export function createRecorder(): Recorder {
  let entries: Kept[] = [];
  /** Bytes of each entry. */
  let weights: number[] = [];
  let plan: readonly ScheduledInput[] = [];
  let bytes = 0;
  let controls: Controls | null | undefined;
  /** The last hello dropped: the frames after it cannot be read without it. */
  let hello: (RecordingEntry & { kind: 'received' }) | null = null;
  let dropped = 0;

  const push = (entry: Kept, weight: number) => {
    entries.push(entry);
    weights.push(weight);
    bytes += weight;
    if (bytes > MAX_BYTES) dropOldest();
  };
  /** The rest begins with a frame, so that a replay has a picture from its first moment. */
  const dropOldest = () => {
    let count = 0;
    while (count < entries.length - 1 && (bytes > LEFT * MAX_BYTES || entries[count]!.kind !== 'packed')) {
      const entry = entries[count]!;
      if (entry.kind === 'received' && entry.message.kind === 'hello') hello = entry;
      bytes -= weights[count++]!;
    }
    entries = entries.slice(count);
    weights = weights.slice(count);
    dropped += count;
  };
  /** Controls are held for many frames: equal ones share one record. */
  const takeControls = (entry: RecordingEntry & { kind: 'advanced' }) => {
    const isHeld = controls !== undefined && areSame(controls, entry.controls);
    if (!isHeld) controls = entry.controls;
    push({ ...entry, controls: controls ?? null }, ENTRY_BYTES + (isHeld ? 0 : CONTROLS_BYTES));
  };
  const takeFrame = (at: number, packed: Uint8Array) => {
    push({ kind: 'packed', at, bytes: packed }, PACKED_BYTES + packed.length);
  };

  return {
    take(entry, bytes) {
      if (entry.kind === 'advanced') takeControls(entry);
      else if (entry.kind === 'received' && entry.message.kind === 'frame' && isWhole(entry.message))
        takeFrame(entry.at, bytes ?? encodeServerMessage(entry.message));
      else push(entry, bytesOf(entry));
    },
    begin(next) {
      plan = next;
      entries = [];
      weights = [];
      bytes = 0;
      controls = undefined;
      hello = null;
      dropped = 0;
    },
    seconds: () => (entries.at(-1)?.at ?? 0) - (entries[0]?.at ?? 0),
    hasDropped: () => dropped > 0,
    recording: (note) => ({
      header: { note, shipId: 'own', plan },
      entries: withHello(hello, entries.map(unpacked)),
    }),
  };
}

/** Entries from their world's hello on, which is as old as the first of them. */
function withHello(
  hello: (RecordingEntry & { kind: 'received' }) | null,
  entries: readonly RecordingEntry[],
): readonly RecordingEntry[] {
  return hello === null || entries.length === 0 ? entries : [{ ...hello, at: entries[0]!.at }, ...entries];
}

/** Only a frame with all its fields is restored exactly from bytes. */
function isWhole(frame: PartialFrame): frame is ServerFrame {
  const { tickRate, timeScale, paused, bodies, events, lastInput } = frame;
  return [tickRate, timeScale, paused, bodies, events, lastInput].every((field) => field !== undefined);
}

function unpacked(entry: RecordingEntry | PackedFrame): RecordingEntry {
  if (entry.kind !== 'packed') return entry;
  const message = decodeServerMessage(entry.bytes);
  if (!message.ok) throw new Error(`a recorded frame does not decode: ${message.reason}`);
  return { kind: 'received', at: entry.at, message: message.value };
}

function areSame(a: Controls | null, b: Controls | null): boolean {
  if (a === null || b === null) return a === b;
  return (
    Object.is(a.thrustLevel, b.thrustLevel) &&
    a.attitudeHold === b.attitudeHold &&
    a.attitudeMode === b.attitudeMode &&
    areSameNumbers(a.translationInput, b.translationInput) &&
    areSameNumbers(a.rotationInput, b.rotationInput) &&
    areSameNumbers(a.targetAttitude, b.targetAttitude)
  );
}

function areSameNumbers(a: readonly number[], b: readonly number[]): boolean {
  for (let k = 0; k < a.length; k++) if (!Object.is(a[k], b[k])) return false;
  return true;
}

function bytesOf(entry: RecordingEntry): number {
  const ships = entry.kind === 'received' && entry.message.kind === 'frame' ? entry.message.ships.length : 0;
  return ENTRY_BYTES + CONTROLS_BYTES + SHIP_BYTES * ships;
}
