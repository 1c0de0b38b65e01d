import type { Controls } from '../../dynamics';
import type { Recording, RecordingEntry, ScheduledInput } from '../../scenarios';
import { decodeServerMessage, encodeServerMessage, type PartialFrame, type ServerFrame } from '../../wire';

/** Entries that a recording holds at most: more than an hour of one ship. */
const MAX_ENTRIES = 250_000;
/** Bytes of memory that it takes at most: about four minutes of 200 ships at 1 Hz. */
const MAX_BYTES = 14_000_000;
/** Bytes of an entry, of a set of controls, and of each ship in a frame that is not packed. */
const ENTRY_BYTES = 60;
const CONTROLS_BYTES = 250;
const SHIP_BYTES = 1000;
/** Of a packed frame, beside its own: the array and what holds it. */
const PACKED_BYTES = 200;

/** Keeps what goes through the predictor from a world's beginning on, bounded by entries and bytes. */
export interface Recorder {
  readonly take: (entry: RecordingEntry) => void;
  /** A new world, and what its own ship does by itself. */
  readonly begin: (plan: readonly ScheduledInput[]) => void;
  readonly seconds: () => number;
  readonly full: () => boolean;
  readonly recording: (note: string) => Recording;
}

/** A whole frame as the protocol's bytes: a fifth of what its records take. */
interface PackedFrame {
  readonly kind: 'packed';
  readonly at: number;
  readonly bytes: Uint8Array;
}

export function createRecorder(): Recorder {
  let entries: (RecordingEntry | PackedFrame)[] = [];
  let plan: readonly ScheduledInput[] = [];
  let bytes = 0;
  let controls: Controls | null | undefined;
  const isFull = () => entries.length >= MAX_ENTRIES || bytes >= MAX_BYTES;

  /** Controls are held for many frames: those of one hold are kept once. */
  const takeControls = (entry: RecordingEntry & { kind: 'advanced' }) => {
    bytes += ENTRY_BYTES;
    if (controls === undefined || !areSame(controls, entry.controls)) {
      controls = entry.controls;
      bytes += CONTROLS_BYTES;
    }
    entries.push({ ...entry, controls });
  };
  const takeFrame = (at: number, frame: ServerFrame) => {
    const packed = encodeServerMessage(frame);
    bytes += PACKED_BYTES + packed.length;
    entries.push({ kind: 'packed', at, bytes: packed });
  };

  return {
    take(entry) {
      if (isFull()) return;
      if (entry.kind === 'advanced') takeControls(entry);
      else if (entry.kind === 'received' && entry.message.kind === 'frame' && isWhole(entry.message))
        takeFrame(entry.at, entry.message);
      else {
        entries.push(entry);
        bytes += bytesOf(entry);
      }
    },
    begin(next) {
      plan = next;
      entries = [];
      bytes = 0;
      controls = undefined;
    },
    seconds: () => (entries.at(-1)?.at ?? 0) - (entries[0]?.at ?? 0),
    full: isFull,
    recording: (note) => ({ header: { note, shipId: 'own', plan }, entries: entries.map(unpacked) }),
  };
}

/** Only a frame with all its fields comes back from bytes as it was. */
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
