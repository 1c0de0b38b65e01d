import { ok, type Result, err } from '../../dynamics';
import { DEFAULT_CHOICES } from '../panels/choices';
import { createRecordingWriter, readRecording, type Recording } from '../../scenarios';

/** Largest file accepted: several hours of frames. */
const MAX_FILE_SIZE = 200_000_000;

/** Writes a recording in slices and reports its progress (0 … 1), so that the page stays responsive. */
export async function writeInSlices(recording: Recording, progress: (share: number) => void): Promise<Blob> {
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

/** A recording's file name: its scenario and the time, so that two files differ. */
export function fileName({ header }: Recording, now: Date): string {
  const scenario = new URLSearchParams(header.note).get('scenario') ?? DEFAULT_CHOICES.scenario;
  const stamp = now.toISOString().slice(0, 19).replaceAll(/[:T]/g, '-');
  return `touchdown-${scenario.replaceAll(/[^\w-]/g, '')}-${stamp}.jsonl`;
}

/** Reads a recording from a file, or returns the reason why it cannot. */
export async function readFile(file: File): Promise<Result<Recording>> {
  if (file.size > MAX_FILE_SIZE)
    return err(`it is ${Math.round(file.size / 1e6)} MB; the limit is ${MAX_FILE_SIZE / 1e6} MB`);
  try {
    const checked = readRecording(await file.text());
    if (!checked.ok) return checked;
    return checked.value.entries.length === 0 ? err('it has no entries') : ok(checked.value);
  } catch (error) {
    return err(`the browser could not read it (${error instanceof Error ? error.message : String(error)})`);
  }
}

/** The message for a file that is not a recording. */
export function refusalText(name: string, checked: Result<Recording> & { ok: false }): string {
  return (
    `${name} cannot be played: ${checked.reason}. ` +
    'It must be an unmodified file from this page or a predictor’s recorder.'
  );
}
