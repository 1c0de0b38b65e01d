// Runs a TypeScript entry point in node as it would run on the page: bundled into one file by the
// same bundler, constants inlined across modules, so that what is measured is what is shipped.
//   node test/run.mjs ENTRY.ts [args]
// Inside the entry import.meta.url, .dirname and .filename are those of the source file.
import { mkdirSync, rmSync } from 'node:fs';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));

/** Vite plugin: a bundled module still knows the place of its source, e.g. to read the files beside it. */
const keepSourcePlaces = {
  name: 'keep-source-places',
  transform(code, id) {
    if (id.includes('node_modules') || !code.includes('import.meta.')) return null;
    const places = { url: pathToFileURL(id).href, dirname: dirname(id), filename: id };
    const placed = code.replace(/\bimport\.meta\.(url|dirname|filename)\b/g, (_, key) =>
      JSON.stringify(places[key]),
    );
    // No line moves: the source map made so far stays good to the line.
    return { code: placed, map: null };
  },
};

/** Bundles `entry` into the folder `outDir` and returns the path of the bundle. */
async function bundle(entry, outDir) {
  await build({
    configFile: false,
    root,
    logLevel: 'warn',
    publicDir: false,
    plugins: [keepSourcePlaces],
    // In the bundle, so that its constants and small functions are inlined as they are in the page's.
    ssr: { noExternal: ['gl-matrix', 'protobufjs', 'long'] },
    build: {
      ssr: entry,
      outDir,
      target: 'node20',
      minify: false,
      sourcemap: 'inline',
      rolldownOptions: {
        optimization: { inlineConst: { mode: 'all', pass: 3 } },
        // As vite.config.ts has it, and says why.
        output: { entryFileNames: 'entry.mjs', codeSplitting: false, topLevelVar: false },
      },
    },
  });
  return join(outDir, 'entry.mjs');
}

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
  await import(pathToFileURL(await bundle(source, outDir)).href);
} catch (error) {
  console.error(error);
  process.exit(1);
}
