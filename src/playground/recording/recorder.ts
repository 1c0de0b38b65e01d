import type { Recording, RecordingEntry, ScheduledInput } from '../../scenarios';

/** Entries that a recording holds at most: about half an hour of one ship. */
const MAX_ENTRIES = 250_000;
/** Bytes of memory that it takes at most, reckoned: a fleet's frames are large. */
const MAX_BYTES = 150_000_000;
/** Bytes of an entry, and of each ship in a frame: eleven vectors, a handful of numbers and their objects. */
const ENTRY_BYTES = 200;
const SHIP_BYTES = 1500;

/** Keeps what goes through the predictor from a world's beginning on, bounded by entries and bytes. */
export interface Recorder {
  readonly take: (entry: RecordingEntry) => void;
  /** A new world, and what its own ship does by itself. */
  readonly begin: (plan: readonly ScheduledInput[]) => void;
  readonly seconds: () => number;
  readonly full: () => boolean;
  readonly recording: (note: string) => Recording;
}

export function createRecorder(): Recorder {
  let entries: RecordingEntry[] = [];
  let plan: readonly ScheduledInput[] = [];
  let bytes = 0;
  const isFull = () => entries.length >= MAX_ENTRIES || bytes >= MAX_BYTES;
  return {
    take(entry) {
      if (isFull()) return;
      entries.push(entry);
      bytes += bytesOf(entry);
    },
    begin(next) {
      plan = next;
      entries = [];
      bytes = 0;
    },
    seconds: () => (entries.at(-1)?.at ?? 0) - (entries[0]?.at ?? 0),
    full: isFull,
    recording: (note) => ({ header: { note, shipId: 'own', plan }, entries: entries.slice() }),
  };
}

function bytesOf(entry: RecordingEntry): number {
  if (entry.kind !== 'received' || entry.message.kind !== 'frame') return ENTRY_BYTES;
  return ENTRY_BYTES + SHIP_BYTES * entry.message.ships.length;
}
