// One file of a TypeScript entry point and of all source behind it, by the bundler that ships the page, with constants inlined
// across modules. Unbundled, the test runner turns every import into a property look-up at each use, which slows the law's inner
// loops up to 13 times, and loads each of hundreds of modules by itself.
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { rolldown } from 'rolldown';
import { mutation } from './mutants/plugins.mjs';
import { reportingTest } from './mutants/probes.mjs';

/** Members of `import.meta`, and the constants in their place, which refer to the source's folder, e.g. to read the files beside it. */
const PLACES = {
  'import.meta.url': 'sourceUrl',
  'import.meta.dirname': 'sourceDirname',
  'import.meta.filename': 'sourceFilename',
};

const declareSourcePlace = {
  name: 'declare-source-place',
  transform: {
    filter: { id: { exclude: /node_modules/ }, code: /import\.meta\.(url|dirname|filename)/ },
    handler(code, id) {
      const [url, folder, file] = [pathToFileURL(id).href, dirname(id), id].map((text) =>
        JSON.stringify(text),
      );
      const place = `const sourceUrl = ${url}, sourceDirname = ${folder}, sourceFilename = ${file};`;
      // On the first line: the source map made so far stays good to the line.
      return { code: `${place} ${code}`, map: null };
    },
  },
};

/** As for the page; vite.config.ts has the reasons. */
const OUTPUT = { sourcemap: true, topLevelVar: false };

/** Input of the bundler: entries (absolute paths) by name, the packages to take into the bundle. */
function inputOf(entries, inside) {
  const isPackage = (id) => /^[^./]/.test(id) && !Object.values(entries).includes(id);
  return {
    input: entries,
    platform: 'node',
    external: (id, _, isResolved) => !isResolved && isPackage(id) && !inside.test(id),
    plugins: [...mutation(), declareSourcePlace],
    optimization: { inlineConst: { mode: 'all', pass: 3 } },
    // As in the built page.
    transform: { define: { ...PLACES, 'import.meta.env.PROD': 'true' } },
    moduleTypes: { '.css': 'empty' },
  };
}

/**
 * Bundles `entry` (absolute path): { code, map, modules }, the last the paths of what is inside.
 * @param {string} entry
 * @param {{ inside?: RegExp }} options packages to take into the bundle; the rest are imported by it
 */
export async function bundle(entry, { inside = /^$/ } = {}) {
  const build = await rolldown(inputOf({ entry }, inside));
  try {
    const { output } = await build.generate({ ...OUTPUT, dir: dirname(entry), codeSplitting: false });
    const { code, map, moduleIds } = output[0];
    return { code, map, modules: moduleIds };
  } finally {
    await build.close();
  }
}

/**
 * Bundles test files (absolute paths) into `folder`, what they share into files of its own: so it is bundled once, and compiled once
 * in each process. Returns { file, modules, isShared } by test file.
 */
async function bundleTogether(tests, folder) {
  const names = new Map(tests.map((test, n) => [`${basename(test, '.ts')}-${n}`, test]));
  const build = await rolldown(inputOf(Object.fromEntries(names), /^$/));
  try {
    const { output } = await build.write({ ...OUTPUT, dir: folder, entryFileNames: '[name].mjs' });
    const chunks = new Map(output.map((chunk) => [chunk.fileName, chunk]));
    const made = [...names].map(([name, test]) => [test, behind(`${name}.mjs`, chunks)]);
    return new Map(
      made.map(([test, all]) => [
        test,
        {
          file: join(folder, all[0].fileName),
          modules: all.flatMap(({ moduleIds }) => moduleIds),
          isShared: tests.length > 1,
        },
      ]),
    );
  } finally {
    await build.close();
  }
}

/** The chunk and all that it imports. */
function behind(fileName, chunks) {
  const found = new Set([fileName]);
  for (const name of found)
    for (const next of chunks.get(name)?.imports ?? []) if (chunks.has(next)) found.add(next);
  return [...found].map((name) => chunks.get(name));
}

/** Bundles of this process: another run in this folder, or a changed file, must not be mistaken for them. */
function bundlesFolder() {
  const folders = fileURLToPath(new URL('../node_modules/.cache/touchdown/tests/', import.meta.url));
  const mine = join(folders, String(process.pid));
  mkdirSync(mine, { recursive: true });
  // A run that was killed has left its own.
  for (const pid of readdirSync(folders)) if (!isRunning(Number(pid))) remove(join(folders, pid));
  process.on('exit', () => remove(mine));
  return mine;
}

function remove(folder) {
  rmSync(folder, { recursive: true, force: true });
}

function isRunning(pid) {
  try {
    return process.kill(pid, 0);
  } catch (error) {
    return error.code === 'EPERM';
  }
}

/** Calls of the test runner that work on its own module graph. */
const REFUSED = /\bvi\.(mock|doMock|resetModules)\b/;
const TESTS = dirname(fileURLToPath(import.meta.url));
/** Of the test runner, at the top of a module. */
const HOOK = /^(before|after)(Each|All)\(/m;

let folder;
let count = 0;
let together = Promise.resolve(new Map());

/** Bundles the test files (absolute paths) of a run, each group together: call before the run loads them. */
export function bundleRun(groups) {
  folder ??= bundlesFolder();
  // A new folder: a process that continues from the previous run must not use that run's files.
  // If a group cannot be bundled, each file is bundled by itself: the faulty one reports its error, and the others run.
  const made = groups.map((tests) =>
    bundleTogether(tests, join(folder, String(count++))).catch(() => new Map()),
  );
  together = Promise.all(made).then((maps) => new Map(maps.flatMap((map) => [...map])));
}

/** @throws where a module that several test files share would run a hook for the first of them alone */
function refuseSharedHooks(modules) {
  for (const path of modules) {
    if (path.endsWith('.test.ts') || !HOOK.test(readFileSync(path, 'utf8'))) continue;
    throw new Error(
      `${path}: a hook at the top is set once for all test files; set it in a function that each calls`,
    );
  }
}

/**
 * Vite plugin: each test file is the bundle that bundleRun made of it, which node imports as it is. The runner's own transform of it,
 * and the look-ups that this makes of each import, would cost more than the bundle itself.
 */
export function bundledTests() {
  return {
    name: 'bundled-tests',
    enforce: 'pre',
    async load(id) {
      if (!id.endsWith('.test.ts')) return null;
      const refused = REFUSED.exec(readFileSync(id, 'utf8'));
      if (refused)
        throw new Error(`${id}: ${refused[0]} cannot reach into a bundle; pass what differs as an argument`);
      const made = (await together).get(id);
      const { code, map, modules } = made ?? (await bundle(id));
      if (made?.isShared) refuseSharedHooks(modules.filter((path) => path.startsWith(TESTS)));
      for (const module of modules) this.addWatchFile(module);
      if (!made) return { code, map };
      const url = pathToFileURL(made.file).href;
      const probes = process.env.TOUCHDOWN_PROBES;
      return probes ? reportingTest(id, url, probes) : `import ${JSON.stringify(url)};`;
    },
  };
}
