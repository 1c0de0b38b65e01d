// The package's production code, which bundlers use in production mode: without the checks that warn developers of mistakes.
// Everything else, including refusals and counters, is the same, bit for bit (test/package/production.ts); texts are shorter (code/texts.mjs).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Replaces the named functions of each file: no checks, as without a listener. */
const CHECKS = {
  'prediction/checks/checks.ts': ['createChecks'],
  'prediction/checks/features.ts': ['checkFeatures'],
  'prediction/checks/options.ts': [
    'requireOptions',
    'requireLeanOptions',
    'checkDefaults',
    'faultOfDefaults',
  ],
  // Advice about a value that is no message. It is refused in any case, by the field that it lacks.
  'wire/fields/sentObject.ts': ['notPlain', 'wrapped'],
};

function without(file, names) {
  const code = readFileSync(file, 'utf8');
  const missing = names.find((name) => !code.includes(`export function ${name}(`));
  if (missing !== undefined) throw new Error(`${file}: ${missing} is not there`);
  return `const none = () => null;\nexport { ${names.map((name) => `none as ${name}`).join(', ')} };\n`;
}

/** The vite plugin, for the sources in the folder `src`; the playground's page is built with it too (vite.config.ts). */
export function production(src) {
  const files = new Map(
    Object.entries(CHECKS).map(([path, names]) => [join(src, path), without(join(src, path), names)]),
  );
  return { name: 'production', enforce: 'pre', load: (id) => files.get(id) ?? null };
}
