import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('..', import.meta.url));

/**
 * What a bundled script (path from the root, like "test/readout/heapOfReadouts.ts") prints of the heap that its cases leave behind.
 * @param flags further flags of node
 */
export function heapFigures(script: string, flags: readonly string[] = []): Record<string, number> {
  const printed = execFileSync(
    process.execPath,
    [
      '--expose-gc',
      ...flags,
      // MB: no collection during a run, so that the heap's growth is all that was allocated.
      '--min-semi-space-size=256',
      '--max-semi-space-size=256',
      'test/run.mjs',
      script,
    ],
    { cwd: ROOT, encoding: 'utf8' },
  );
  return JSON.parse(printed) as Record<string, number>;
}
