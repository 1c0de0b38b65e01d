/// <reference types="vitest/config" />
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { UserConfig } from 'vite';
import { listForOffline, OFFLINE_SCRIPT } from './.ci/offline.mjs';
import { bundledTests } from './test/bundle.mjs';

const BROWSER_TESTS = 'test/browser/**/*.test.ts';

/**
 * Top-level constants stay `const`: as `var`, vite's default, the engine loads the law's scratch arrays anew at every access
 * instead of building their addresses in, and a substep costs a quarter more instructions.
 */
const CONSTANTS = { topLevelVar: false };

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * Modules that only define things: what is fetched on demand then takes along what it alone needs from behind a folder's index.
 * Not so the two programs, and the index that brings a style sheet.
 */
const PURE = /\/src\/(?!playground\/(main|offline\/serviceWorker)\.ts|hud\/index\.ts).*\.ts$/;

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
  plugins: [listForOffline(here('public'))],
  worker: { format: 'es', rolldownOptions: { output: CONSTANTS } },
};

const library: UserConfig = {
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist/lib',
    emptyOutDir: true,
    minify: false,
    sourcemap: true,
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'touchdown' },
    rolldownOptions: {
      external: [/^three($|\/)/, /^gl-matrix($|\/)/, /^protobufjs($|\/)/, /^uplot($|\/)/],
      output: CONSTANTS,
    },
  },
  worker: { format: 'es' },
};

const tests: UserConfig = {
  publicDir: false,
  test: {
    projects: [
      {
        plugins: [bundledTests()],
        test: {
          name: 'node',
          environment: 'node',
          include: ['test/**/*.test.ts'],
          exclude: [BROWSER_TESTS],
          sequence: { groupOrder: 0 },
        },
      },
      {
        test: {
          name: 'browser',
          environment: 'node',
          include: [BROWSER_TESTS],
          globalSetup: ['test/browser/globalSetup.ts'],
          // After the node project and one file at a time: a software-rendered page takes a whole core.
          sequence: { groupOrder: 1 },
          fileParallelism: false,
          testTimeout: 60_000,
          hookTimeout: 120_000,
        },
      },
    ],
  },
};

export default defineConfig(({ mode }) => {
  if (mode === 'test') return tests;
  return mode === 'lib' ? library : page;
});
