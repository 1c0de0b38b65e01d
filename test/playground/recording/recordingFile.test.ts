/** The file of a recording. */
import { expect, it } from 'vitest';
import { fileName } from '../../../src/playground/recording/recordingFile';

const NOON = new Date('2031-05-06T12:00:09.5Z');
const nameOf = (note: string) => fileName({ header: { note, shipId: 'own' }, entries: [] }, NOON);

it('a recording’s file is named after its scenario and the time', () => {
  expect(nameOf('?scenario=settle&seed=7')).toBe('touchdown-settle-2031-05-06-12-00-09.jsonl');
  expect(nameOf('')).toBe('touchdown-first-landing-2031-05-06-12-00-09.jsonl');
});

it('a note from a file puts no path into the name', () => {
  expect(nameOf('?scenario=../../a%2Fb.html')).toBe('touchdown-abhtml-2031-05-06-12-00-09.jsonl');
});
