// The package's code for pages in use, which bundlers take in production mode: without the checks that tell a developer of mistakes.
// What is refused, corrected and counted is the same, bit for bit (test/package/production.ts).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** What `createChecks` is replaced with: no checks, as where there is no listener. */
const NO_CHECKS = 'export const createChecks = () => null;\n';

/** The vite plugin, for the sources in the folder `src`. */
export function production(src) {
  const checks = join(src, 'prediction/checks/checks.ts');
  if (!readFileSync(checks, 'utf8').includes('export function createChecks('))
    throw new Error(`${checks}: createChecks is not there`);
  return { name: 'production', enforce: 'pre', load: (id) => (id === checks ? NO_CHECKS : null) };
}
