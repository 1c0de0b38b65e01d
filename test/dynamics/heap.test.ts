import { expect, it } from 'vitest';
import { heapFigures } from '../heapRun';

// Target 0 bytes a substep: one double boxed a substep would be 16 MB. Today 0.2 flying, 0.02 and less else.
it('a substep allocates nothing, in any state', () => {
  const bytes = heapFigures('test/dynamics/heapOfSubsteps.ts');
  expect(Object.keys(bytes)).toEqual(['flying', 'sliding', 'landed', 'tipped', 'toppling']);
  for (const [state, grown] of Object.entries(bytes)) expect(grown, state).toBeLessThan(250_000);
});
