import { expect, it } from 'vitest';
import { heapFigures } from '../heapRun';

/** Bytes a call that count as none: one double boxed a call would be 16. */
const NONE = 4;
/** Each new run ahead of the law checks its bodies, in texts; a toppling ship on the Moon has one every other frame. */
const RUN_AHEAD = 1000;
/** One double boxed in every sixteenth ship. */
const FLEET = 1000;

// Target 0. Today 0, 650 where a run ahead begins; before, 16 to 128 for the own ship's and 8,000 for a fleet of 1,000.
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
