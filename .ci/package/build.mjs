// Builds dist/package, what `npm pack ./dist/package` packs: each entry of the library as an ES module, as CommonJS and as
// declarations, one style sheet, and a manifest. Each module is built twice: for development, and for production (production.mjs).
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { numbers } from './code/numbers.mjs';
import { production } from './production.mjs';
import { pure } from './code/pure.mjs';
import { shortenNames } from './code/shortNames.mjs';
import { texts } from './code/texts.mjs';
import { writeTypes } from './types.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const out = join(root, 'dist/package');

/** Entries of the package and their sources; `index` is the package's main entry. */
export const DOORS = {
  index: 'src/index.ts',
  protobuf: 'src/protobuf.ts',
  hud: 'src/hud/index.ts',
  scene: 'src/scene/index.ts',
  game: 'src/game/index.ts',
};

/** Packages bundled into the built files, with their licences: users need not install them. */
const BUNDLED = ['gl-matrix', 'protobufjs', 'long'];

const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
const names = Object.keys(DOORS).filter((door) => existsSync(join(root, DOORS[door])));
const doors = Object.fromEntries(names.map((door) => [door, DOORS[door]]));

/** Rooms that several entries need. */
const SHARED_ROOMS = ['dynamics', 'wire', 'readout'];

const SHARED = { configFile: false, root, logLevel: 'warn', publicDir: false };

/** One format at a time: a CommonJS file shares nothing with a module. */
async function buildCode({ format, folder = '', plugins = [] }) {
  const extension = format === 'es' ? 'js' : 'cjs';

  await build({
    ...SHARED,
    plugins: [...plugins, numbers(join(root, 'src/')), pure(join(root, 'src/'))],
    build: {
      target: 'es2022',
      outDir: join(out, folder),
      emptyOutDir: false,
      minify: false,
      sourcemap: true,
      lib: { entry: doors, formats: [format] },
      rolldownOptions: {
        external: [/^three($|\/)/],
        checks: { bundlerTimings: false },
        treeshake: { moduleSideEffects: [{ test: /\/src\/.*\.[jt]s$/, sideEffects: false }] },
        output: {
          entryFileNames: `[name].${extension}`,
          chunkFileNames: `chunks/[name].${extension}`,
          // Top-level constants stay `const`: as `var` the engine loads the law's scratch arrays anew at every access.
          topLevelVar: false,
          // Split by room, so that the law's loops stay within one file, and no room loads another.
          codeSplitting: {
            groups: SHARED_ROOMS.map((name) => ({ name, test: `/src/${name}/`, minShareCount: 2 })),
          },
        },
      },
    },
  });
}

async function buildStyles() {
  await build({
    ...SHARED,
    build: {
      outDir: out,
      emptyOutDir: false,
      cssMinify: false,
      rolldownOptions: {
        input: join(root, 'src/hud/styles/hud.css'),
        output: { assetFileNames: '[name][extname]' },
      },
    },
  });
}

/** URL of the code: the clone's origin if it is public, otherwise that of package.json. */
function repository() {
  const { stdout } = spawnSync('git', ['remote', 'get-url', 'origin'], { cwd: root, encoding: 'utf8' });
  const origin = (stdout ?? '').trim();
  return /^https:\/\/[^@]+$/.test(origin) ? { type: 'git', url: `git+${origin}` } : manifest.repository;
}

function writeManifest() {
  const conditions = (door) => ({
    import: { types: `./${door}.d.ts`, production: `./production/${door}.js`, default: `./${door}.js` },
    require: { types: `./${door}.d.cts`, default: `./${door}.cjs` },
  });
  const entries = names.map((door) => [door === 'index' ? '.' : `./${door}`, conditions(door)]);
  const { name, version, description, keywords, license, engines } = manifest;
  const packed = {
    name,
    version,
    description,
    keywords,
    license,
    repository: repository(),
    type: 'module',
    engines,
    sideEffects: ['./hud.css'],
    exports: {
      ...Object.fromEntries(entries),
      // TypeScript 6 requires a declaration for an imported style sheet.
      './hud.css': {
        import: { types: './hud.css.d.ts', default: './hud.css' },
        require: { types: './hud.css.d.cts', default: './hud.css' },
      },
      './package.json': './package.json',
    },
    main: './index.cjs',
    module: './index.js',
    types: './index.d.ts',
    files: [
      ...['*.js', '*.cjs', '*.map', '*.d.ts', '*.d.cts', 'hud.css', 'chunks', 'production'],
      ...['CHANGELOG.md', 'NOTICES.md'],
    ],
    peerDependencies: { three: '>=0.160.0' },
    peerDependenciesMeta: { three: { optional: true } },
  };
  writeFileSync(join(out, 'package.json'), `${JSON.stringify(packed, null, 2)}\n`);
}

/** The licences of the bundled packages, word for word. */
function writeNotices() {
  const notices = BUNDLED.map((name) => {
    const folder = join(root, 'node_modules', name);
    const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    return `## ${name} ${version}\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
  });
  writeFileSync(join(out, 'NOTICES.md'), `# Code of others in this package\n\n${notices.join('\n')}`);
}

/** Declarations without their comments: the package's, and those of JavaScript itself. */
function declarations() {
  const platform = join(root, 'node_modules/typescript/lib');
  const read = (folder, pattern) =>
    readdirSync(folder)
      .filter((file) => pattern.test(file))
      .map((file) => readFileSync(join(folder, file), 'utf8').replace(/\/\*[\s\S]*?\*\//g, ''));
  return { own: read(out, /\.d\.ts$/), language: read(platform, /^lib\.(es|decorators).*\.d\.ts$/) };
}

/** Builds the package. Throws if anything is wrong. */
export async function buildPackage() {
  rmSync(out, { recursive: true, force: true });
  await buildCode({ format: 'es' });
  await buildCode({ format: 'cjs' });
  await buildCode({
    format: 'es',
    folder: 'production',
    plugins: [production(join(root, 'src')), texts(join(root, 'src/'))],
  });
  await buildStyles();
  for (const file of ['hud.css.d.ts', 'hud.css.d.cts']) writeFileSync(join(out, file), 'export {};\n');
  await writeTypes(root, doors, out);
  shortenNames(join(out, 'production'), declarations());
  writeManifest();
  writeNotices();
  for (const file of ['LICENSE', 'CHANGELOG.md']) cpSync(join(root, file), join(out, file));
  cpSync(join(root, '.ci/package/README.md'), join(out, 'README.md'));
}
