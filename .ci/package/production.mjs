// The package's production code, which bundlers use in production mode: without the checks that warn developers of mistakes.
// Everything else, including refusals and counters, is the same, bit for bit (test/package/production.ts).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Replaces `createChecks`: no checks, as without a listener. */
const NO_CHECKS = 'export const createChecks = () => null;\n';

/** The vite plugin, for the sources in the folder `src`. */
export function production(src) {
  const checks = join(src, 'prediction/checks/checks.ts');
  if (!readFileSync(checks, 'utf8').includes('export function createChecks('))
    throw new Error(`${checks}: createChecks is not there`);
  return { name: 'production', enforce: 'pre', load: (id) => (id === checks ? NO_CHECKS : null) };
}
