import { expect, it } from 'vitest';
import { runSeed } from './run';
import { breaksOf } from './verdict';

/** A server written from the design page and faults drawn from a seed, against the public API alone. */

const SEEDS = { first: 1, count: 100 };

it('meets PREDICTION on any server, network and page', () => {
  const broken: string[] = [];
  for (let seed = SEEDS.first; seed < SEEDS.first + SEEDS.count; seed++) {
    try {
      const run = runSeed(seed);
      for (const line of breaksOf(run)) broken.push(`${line} (${run.label})`);
    } catch (error) {
      broken.push(`threw ${String(error)} (seed ${seed})`);
    }
  }
  expect(broken, `${broken[0] ?? ''}\n${broken.length} broke in ${SEEDS.count} runs`).toEqual([]);
});
