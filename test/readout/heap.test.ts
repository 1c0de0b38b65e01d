import { expect, it } from 'vitest';
import { heapFigures } from '../heapRun';

/** Bytes per call that count as none: one boxed double per call is 16. */
const NONE = 4;
/** Copying a ship into a new run ahead takes some 90 bytes; a toppling ship starts one in every fourth or fifth call. */
const RUN_AHEAD = 32;
/** One boxed double for every sixteenth ship. */
const FLEET = 1000;

// Target 0. Today 0, 20 where runs ahead begin and 0.1 for a fleet of 1,000. A boxed terrain look-up would be 64 per substep.
const boundOf = (name: string) =>
  name.startsWith('fleet') ? FLEET : name === 'toppling, frame after frame' ? RUN_AHEAD : NONE;

/** Runs of the measurement: beside a busy machine the compiler's own garbage falls into one now and then, a readout's into all. */
const RUNS = 3;

it('a readout allocates nothing, of a view that stays or goes on', () => {
  const least: Record<string, number> = {};
  const isOver = () => Object.entries(least).some(([name, grown]) => grown >= boundOf(name));
  for (let run = 0; run < RUNS && (run === 0 || isOver()); run++)
    for (const [name, grown] of Object.entries(heapFigures('test/readout/heapOfReadouts.ts')))
      least[name] = Math.min(grown, least[name] ?? Infinity);
  expect(Object.keys(least)).toHaveLength(16);
  for (const [name, grown] of Object.entries(least)) expect(grown, name).toBeLessThan(boundOf(name));
});
