import { expect, it } from 'vitest';
import { heapFigures } from '../heapRun';

/** Bytes a call that count as none: one double boxed a call would be 16. */
const NONE = 4;
/** Each new run ahead of the law checks its bodies, in texts; a toppling ship on the Moon has one every other frame. */
const RUN_AHEAD = 1000;
/** One double boxed in every sixteenth ship. */
const FLEET = 1000;

// Target 0. Today 0, 650 where a run ahead begins; before, 16 to 128 for the own ship's and 8,000 for a fleet of 1,000.
it('a readout allocates nothing, of a view that stays or goes on', { timeout: 120_000 }, () => {
  const bytes = Object.entries(heapFigures('test/readout/heapOfReadouts.ts'));
  expect(bytes).toHaveLength(16);
  for (const [name, grown] of bytes) {
    const bound = name.startsWith('fleet')
      ? FLEET
      : name === 'toppling, frame after frame'
        ? RUN_AHEAD
        : NONE;
    expect(grown, name).toBeLessThan(bound);
  }
});
