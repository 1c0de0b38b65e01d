// What `npm run mutants` does to the source while the tests' bundles and the page are built.
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { withProbes } from './probes.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** The change to make: { path from the root, start, end, text } as JSON in TOUCHDOWN_MUTANT. */
function changed(code, path) {
  const mutant = JSON.parse(process.env.TOUCHDOWN_MUTANT || '{}');
  if (mutant.path !== path) return null;
  return { code: code.slice(0, mutant.start) + mutant.text + code.slice(mutant.end), map: null };
}

/** TOUCHDOWN_PROBES: the file into which the test files report the blocks that they reach. */
function probed(code, path) {
  if (!path.startsWith('src/') || !path.endsWith('.ts') || path.includes('/generated/')) return null;
  return { code: withProbes(path, code), map: null };
}

/** Plugins for a bundler or a server; none in a run of the tests by themselves. */
export function mutation() {
  if (process.env.TOUCHDOWN_MUTANT === undefined) return [];
  const change = process.env.TOUCHDOWN_PROBES ? probed : changed;
  const transform = (code, id) => change(code, relative(ROOT, id).replaceAll('\\', '/'));
  return [{ name: 'mutation', enforce: 'pre', transform }];
}
