import type { Recording, RecordingEntry, StagedInput } from '../../scenarios';

/** Keeps what goes through the predictor from a world's beginning on: about half an hour. */
const MAX_ENTRIES = 250_000;

export interface Recorder {
  readonly take: (entry: RecordingEntry) => void;
  /** A new world, and what its own ship does by itself. */
  readonly begin: (plan: readonly StagedInput[]) => void;
  readonly seconds: () => number;
  readonly full: () => boolean;
  readonly recording: (note: string) => Recording;
}

export function createRecorder(): Recorder {
  let entries: RecordingEntry[] = [];
  let plan: readonly StagedInput[] = [];
  return {
    take(entry) {
      if (entries.length < MAX_ENTRIES) entries.push(entry);
    },
    begin(next) {
      plan = next;
      entries = [];
    },
    seconds: () => (entries.at(-1)?.at ?? 0) - (entries[0]?.at ?? 0),
    full: () => entries.length >= MAX_ENTRIES,
    recording: (note) => ({ header: { note, shipId: 'own', plan }, entries: entries.slice() }),
  };
}
