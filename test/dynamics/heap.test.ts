import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

// Target 0 bytes a substep: one double boxed a substep would be 16 MB. Today 0.2 flying, 0.02 and less else.
it('a substep allocates nothing, in any state', { timeout: 60_000 }, () => {
  const printed = execFileSync(
    process.execPath,
    [
      '--expose-gc',
      // MB: no collection during a run, so that the heap's growth is all that was allocated.
      '--min-semi-space-size=256',
      '--max-semi-space-size=256',
      'test/run.mjs',
      'test/dynamics/heapOfSubsteps.ts',
    ],
    { cwd: ROOT, encoding: 'utf8' },
  );
  const bytes = JSON.parse(printed) as Record<string, number>;
  expect(Object.keys(bytes)).toEqual(['flying', 'sliding', 'landed', 'tipped', 'toppling']);
  for (const [state, grown] of Object.entries(bytes)) expect(grown, state).toBeLessThan(250_000);
});
