import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { UserConfig } from 'vite';
import { compactShaders } from './.ci/page/compactShaders.mjs';
import { writeNotices } from './.ci/page/notices.mjs';
import { listForOffline, OFFLINE_SCRIPT } from './.ci/page/offline.mjs';
import { production } from './.ci/package/production.mjs';
import { leanThree } from './.ci/page/leanThree.mjs';
import type * as TestProjects from './test/projects.mjs';

/**
 * Top-level constants stay `const`: as `var`, vite's default, the engine loads the law's scratch arrays anew at every access
 * instead of building their addresses in, and a substep costs a quarter more instructions.
 */
const CONSTANTS = { topLevelVar: false };

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * Modules that only define things: what is fetched on demand then takes along what it alone needs from behind a folder's index.
 * Not so the two programs.
 */
const PURE = /\/src\/(?!playground\/(main|offline\/serviceWorker)\.ts).*\.ts$/;

/**
 * The page does without the checks of a predictor's caller, as the package does in production: it listens to no warnings, hands in
 * options of its own making, and never calls `configure`.
 */
const withoutChecks = { ...production(here('src')), apply: 'build' as const };

const page: UserConfig = {
  root: 'src/playground',
  publicDir: '../../public',
  // Relative addresses: the built page works from any static host and any sub-path.
  base: './',
  cacheDir: '../../node_modules/.vite',
  build: {
    target: 'es2022',
    outDir: '../../dist/page',
    emptyOutDir: true,
    // `default-src 'self'` blocks data: addresses and inline scripts.
    assetsInlineLimit: 0,
    // Its loader asks for the document, which the worker, started from the same program, does not have.
    modulePreload: false,
    // three alone is most of a megabyte, and a page that draws from its first frame cannot put it off.
    chunkSizeWarningLimit: 1500,
    rolldownOptions: {
      input: {
        index: here('src/playground/index.html'),
        offline: here('src/playground/offline/serviceWorker.ts'),
      },
      treeshake: {
        moduleSideEffects: [{ test: PURE, sideEffects: false }],
        // What three tells its developers of outdated calls weighs more than a kilobyte; its errors stay.
        manualPureFunctions: ['warn', 'warnOnce'],
      },
      output: {
        ...CONSTANTS,
        entryFileNames: ({ name }) => (name === 'offline' ? OFFLINE_SCRIPT : 'assets/[name]-[hash].js'),
      },
    },
  },
  plugins: [withoutChecks, leanThree(), compactShaders(), writeNotices(), listForOffline(here('public'))],
  worker: { format: 'es', rolldownOptions: { output: CONSTANTS } },
};

/** Named at run time: a config that named it would be bundled with the test runner, which `npm start` does not install. */
const testProjects = new URL('./test/projects.mjs', import.meta.url).href;

export default defineConfig(async ({ mode }) => {
  if (mode !== 'test' && mode !== 'long') return page;
  const { tests, longTests } = (await import(testProjects)) as typeof TestProjects;
  return mode === 'test' ? tests : longTests;
});
