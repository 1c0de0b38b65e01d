import { expect, it } from 'vitest';
import { heapFigures } from '../heapRun';

/** Bytes per call that count as no allocation: one boxed double per call is 16. */
const NONE = 4;
/** Copying a ship into a new run ahead takes some 90 bytes; a toppling ship starts one in every fourth or fifth call. */
const RUN_AHEAD = 32;
/** One boxed double for every sixteenth ship. */
const FLEET = 1000;

// Target 0. Today 0, 20 where runs ahead begin and 0.1 for a fleet of 1,000. A boxed terrain look-up would be 64 per substep.
const boundOf = (name: string) =>
  name.startsWith('fleet') ? FLEET : name === 'toppling, frame after frame' ? RUN_AHEAD : NONE;

it('a readout allocates nothing, for an unchanged view or the next one', () => {
  // Makes the engine compile at the same calls in each run, regardless of load.
  const figures = Object.entries(heapFigures('test/readout/heapOfReadouts.ts', ['--single-threaded']));
  expect(figures).toHaveLength(16);
  for (const [name, grown] of figures) expect(grown, `bytes per call: ${name}`).toBeLessThan(boundOf(name));
});
