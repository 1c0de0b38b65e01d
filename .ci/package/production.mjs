// The package's code for pages in use, which bundlers take in production mode: without the checks that tell a developer of mistakes.
// What is refused, corrected and counted is the same, bit for bit (test/package/production.ts).
import { readFileSync } from 'node:fs';
import { posix } from 'node:path';

/** Functions of each module without which there are no checks, as where there is no listener. */
export const CALL_CHECKS = { 'prediction/checks/checks.ts': ['createChecks'] };

/**
 * A plugin of vite and rolldown: of these modules in the folder `src` only these functions are left, and they return null.
 * @throws when one is not there: under another name it would stay in, with all behind it
 */
export function withoutChecks(src, functions) {
  const left = Object.entries(functions).map(([module, names]) => {
    const path = posix.join(src.replaceAll('\\', '/'), module);
    const source = readFileSync(path, 'utf8');
    const missing = names.find((name) => !source.includes(`export function ${name}(`));
    if (missing) throw new Error(`${path}: ${missing} is not there`);
    return [path, names.map((name) => `export const ${name} = () => null;\n`).join('')];
  });
  const codeOf = new Map(left);
  return { name: 'without-checks', enforce: 'pre', load: (id) => codeOf.get(id) ?? null };
}

/** The plugin of the package, for the sources in the folder `src`. */
export const production = (src) => withoutChecks(src, CALL_CHECKS);
