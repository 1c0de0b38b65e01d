import { accepted, type Checked, refused } from '../dynamics';
import {
  createRecordingWriter,
  readRecording,
  type Recording,
  type RecordingEntry,
  type StagedInput,
} from '../rehearsal';
import { LARGEST_FILE } from './replay';

/** Keeps what goes through the predictor from a world's beginning on: about half an hour. */
const MOST_ENTRIES = 250_000;

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
      if (entries.length < MOST_ENTRIES) entries.push(entry);
    },
    begin(next) {
      plan = next;
      entries = [];
    },
    seconds: () => (entries.at(-1)?.at ?? 0) - (entries[0]?.at ?? 0),
    full: () => entries.length >= MOST_ENTRIES,
    recording: (note) => ({ header: { note, shipId: 'own', plan }, entries: entries.slice() }),
  };
}

/** Writes a recording in slices, telling how far it is (0 … 1), so that the page stays alive. */
export async function writeSlowly(recording: Recording, progress: (share: number) => void): Promise<Blob> {
  const writer = createRecordingWriter();
  const parts = [writer.header(recording.header)];
  const { entries } = recording;
  const slice = 2000;
  for (let i = 0; i < entries.length; i += slice) {
    parts.push(
      entries
        .slice(i, i + slice)
        .map((entry) => writer.entry(entry))
        .join(''),
    );
    progress(Math.min(1, (i + slice) / entries.length));
    await new Promise((resolve) => setTimeout(resolve));
  }
  return new Blob(parts, { type: 'application/jsonl' });
}

/** A recording from a file, or why it is none. */
export async function readFile(file: File): Promise<Checked<Recording>> {
  if (file.size > LARGEST_FILE)
    return refused(`it is ${Math.round(file.size / 1e6)} MB, and at most ${LARGEST_FILE / 1e6} MB are read`);
  try {
    const checked = readRecording(await file.text());
    if (!checked.ok) return checked;
    return checked.value.entries.length === 0 ? refused('it holds no entries') : accepted(checked.value);
  } catch (error) {
    return refused(
      `the browser could not read it (${error instanceof Error ? error.message : String(error)})`,
    );
  }
}
