import { expect, it } from 'vitest';
import { heapFigures } from '../../heapRun';

/** Bytes over 200,000 substeps: one boxed double for every twelfth of them. One per substep would be 3.2 MB. Target 0; measured under 5,000. */
const BOUND = 250_000;

it('a substep allocates nothing, in any state, on any terrain, however many worlds came before', () => {
  const bytes = heapFigures('test/dynamics/heap/heapOfSubsteps.ts');
  expect(Object.keys(bytes)).toEqual([
    'flying',
    'sliding',
    'landed',
    'tipped',
    'toppling',
    'over hills',
    'over a heightmap',
    'over flat ground again',
    'sliding after other worlds',
  ]);
  for (const [state, grown] of Object.entries(bytes)) expect(grown, state).toBeLessThan(BOUND);
});
