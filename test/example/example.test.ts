/** The example client is small, and the guide's code is the example's. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';

const FOLDER = join(import.meta.dirname, '../../src/example');
const sources = readdirSync(FOLDER)
  .filter((file) => file.endsWith('.js'))
  .map((file) => readFileSync(join(FOLDER, file), 'utf8'));

/** Lines without their indentation: a guide shows a function's inside as well as the whole. */
const lines = (text: string) => text.split('\n').map((line) => line.trim());

it('has at most 200 lines, with the game’s module names', () => {
  expect(sources.flatMap((text) => text.trimEnd().split('\n')).length).toBeLessThanOrEqual(200);
  const files = readdirSync(FOLDER);
  expect(files).toEqual(
    expect.arrayContaining(['cockpitExtrapolation.js', 'cockpitLandingHud.js', 'fleetHud.js']),
  );
});

it('is what the guide shows: each block of code occurs in a file, line by line', () => {
  const guide = readFileSync(join(FOLDER, 'GUIDE.md'), 'utf8');
  const blocks = [...guide.matchAll(/^```js\n([^]*?)^```/gm)].map((match) => match[1]!);
  expect(blocks.length).toBeGreaterThan(5);
  for (const block of blocks) {
    const wanted = lines(block.trimEnd()).join('\n');
    expect(
      sources.some((text) => lines(text).join('\n').includes(wanted)),
      block,
    ).toBe(true);
  }
});
