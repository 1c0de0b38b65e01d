// Builds what is handed on:
//   node .ci/build.mjs page    dist/page: the playground, for any static host
//   node .ci/build.mjs lib     dist/lib: an ES module with its types, for the game's client
//   node .ci/build.mjs         both
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));
const configFile = join(root, 'vite.config.ts');

/** Declarations beside generated JavaScript are input to the type checker, which therefore does not copy them. */
function copyGeneratedTypes() {
  const generated = join(root, 'src/wire/generated');
  if (!existsSync(generated)) return;
  const isFolderOrTypes = (path) => !/\.\w+$/.test(path) || path.endsWith('.d.ts');
  cpSync(generated, join(root, 'dist/lib/types/wire/generated'), {
    recursive: true,
    filter: isFolderOrTypes,
  });
}

/** The library's own manifest: what it leaves to its user's bundler, in the versions that it was tested with. */
function writeLibraryManifest() {
  const { name, version, license, type, dependencies } = JSON.parse(
    readFileSync(join(root, 'package.json'), 'utf8'),
  );
  const code = readFileSync(join(root, 'dist/lib/touchdown.js'), 'utf8');
  const isImported = ([dependency]) => new RegExp(`from "${dependency}["/]`).test(code);
  const needed = Object.fromEntries(Object.entries(dependencies).filter(isImported));
  const exports = {
    '.': { types: './types/index.d.ts', default: './touchdown.js' },
    './touchdown.css': './touchdown.css',
  };
  const sideEffects = ['./touchdown.css'];
  const manifest = { name, version, license, type, sideEffects, exports, dependencies: needed };
  writeFileSync(join(root, 'dist/lib/package.json'), `${JSON.stringify(manifest, null, 2)}\n`);
}

function emitTypes() {
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const run = spawnSync(process.execPath, [tsc, '-p', '.ci/tsconfig.lib.json'], {
    cwd: root,
    stdio: 'inherit',
  });
  if (run.status !== 0) throw new Error('the library’s types do not check');
}

/** The style sheets are in touchdown.css: their imports mean nothing to the types' reader. */
function dropStyleImports() {
  const types = join(root, 'dist/lib/types/hud/index.d.ts');
  writeFileSync(types, readFileSync(types, 'utf8').replace(/^import '\.\/\w+\.css';\n/gm, ''));
}

async function buildPage() {
  await build({ configFile, logLevel: 'warn' });
}

async function buildLibrary() {
  await build({ configFile, mode: 'lib', logLevel: 'warn' });
  emitTypes();
  copyGeneratedTypes();
  dropStyleImports();
  writeLibraryManifest();
}

const BUILDS = { page: [buildPage], lib: [buildLibrary] };
const wished = process.argv[2];
const builds = wished === undefined ? [buildPage, buildLibrary] : BUILDS[wished];
if (!builds) {
  console.error('usage: node .ci/build.mjs [page | lib]');
  process.exit(2);
}
process.chdir(root);
try {
  for (const one of builds) await one();
} catch (error) {
  console.error(`build: ${error.message}`);
  process.exit(1);
}
