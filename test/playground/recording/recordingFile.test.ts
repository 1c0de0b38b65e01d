/** The file of a recording. */
import { expect, it } from 'vitest';
import { writeRecording } from '../../../src/scenarios';
import {
  fileName,
  readFile,
  refusalText,
  writeInSlices,
} from '../../../src/playground/recording/recordingFile';

const NOON = new Date('2031-05-06T12:00:09.5Z');
const nameOf = (note: string) => fileName({ header: { note, shipId: 'own' }, entries: [] }, NOON);

it('a recording’s file is named after its scenario and the time', () => {
  expect(nameOf('?scenario=settle&seed=7')).toBe('touchdown-settle-2031-05-06-12-00-09.jsonl');
  expect(nameOf('')).toBe('touchdown-first-landing-2031-05-06-12-00-09.jsonl');
});

it('a note from a file puts no path into the name', () => {
  expect(nameOf('?scenario=../../a%2Fb.html')).toBe('touchdown-abhtml-2031-05-06-12-00-09.jsonl');
});

const fileOf = (text: string | Error, size = 10) => {
  const read = () => (typeof text === 'string' ? Promise.resolve(text) : Promise.reject(text));
  return { size, text: read } as unknown as File;
};
const EMPTY = writeRecording({ header: { note: '', shipId: 'own' }, entries: [] });

it.each([
  ['of more than 200 MB', fileOf('', 200_600_000), 'it is 201 MB; the limit is 200 MB'],
  ['without entries', fileOf(EMPTY, 200_000_000), 'it has no entries'],
  ['that has gone', fileOf(new Error('not found')), 'the browser could not read it (not found)'],
  ['of something else', fileOf('<b>'), 'line 1: not JSON'],
])('a file %s is refused with the reason', async (_what, file, reason) => {
  const read = await readFile(file);
  expect(read).toEqual({ ok: false, reason: expect.stringContaining(reason) as string });
  expect(refusalText('a.jsonl', read as Extract<typeof read, { ok: false }>)).toMatch(
    /^a\.jsonl cannot be played: .*\. It must be an unmodified file/,
  );
});

it('a file is written in slices, with the share that is done', async () => {
  const entry = { kind: 'advanced', at: 1, controls: null } as const;
  const recording = { header: { note: '', shipId: 'own' }, entries: Array<typeof entry>(4500).fill(entry) };
  const shares: number[] = [];
  const blob = await writeInSlices(recording, (share) => shares.push(share));
  expect(shares).toEqual([2000 / 4500, 4000 / 4500, 1]);
  expect(await blob.text()).toBe(writeRecording(recording));
});
