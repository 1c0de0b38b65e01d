// Runs a TypeScript entry point in node as it would run on the page: bundled into one file by the
// same bundler, constants inlined across modules, so that what is measured is what is shipped.
//   node test/run.mjs ENTRY.ts [args]
// Inside the entry import.meta.url, .dirname and .filename are those of the source file.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative, resolve, sep } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { bundle } from './bundle.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));

/** In the bundle, so that their constants and small functions are inlined as they are in the page's. */
const INSIDE = /^(gl-matrix|protobufjs|long)($|\/)/;

const [entry, ...args] = process.argv.slice(2);
if (!entry) {
  console.error('usage: node test/run.mjs ENTRY.ts [args]');
  process.exit(2);
}
const source = resolve(entry);
// A folder of its own for each run: two runs of one entry must not write over each other's bundle.
const name = relative(root, source)
  .split(sep)
  .join('-')
  .replace(/\.\w+$/, '');
const outDir = join(root, 'node_modules/.cache/touchdown/run', `${name}-${process.pid}`);
mkdirSync(outDir, { recursive: true });
process.on('exit', () => rmSync(outDir, { recursive: true, force: true }));
process.setSourceMapsEnabled(true);
process.argv = [process.argv[0], source, ...args];
try {
  const { code, map } = await bundle(source, { inside: INSIDE });
  const path = join(outDir, 'entry.mjs');
  writeFileSync(path, `${code}\n//# sourceMappingURL=${map.toUrl()}\n`);
  await import(pathToFileURL(path).href);
} catch (error) {
  console.error(error);
  process.exit(1);
}
