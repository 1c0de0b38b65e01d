import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

// Target 0 bytes a substep: one double boxed a substep would be 16 MB. What is left of a million substeps is the measuring's own.
it('a substep allocates nothing, in any state', { timeout: 60_000 }, () => {
  const printed = execFileSync(
    process.execPath,
    ['--expose-gc', 'test/run.mjs', 'test/dynamics/heapOfSubsteps.ts'],
    { cwd: ROOT, encoding: 'utf8' },
  );
  const bytes = JSON.parse(printed) as Record<string, number>;
  expect(Object.keys(bytes)).toEqual(['flying', 'sliding', 'landed', 'tipped']);
  for (const [state, grown] of Object.entries(bytes)) expect(grown, state).toBeLessThan(100_000);
});
