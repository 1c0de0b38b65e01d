// Which files are tests and how they run. A new test file anywhere under test/ is picked up by its name alone.
import { availableParallelism } from 'node:os';
import { bundledTests } from './bundle.mjs';

const BROWSER_TESTS = 'test/browser/**/*.test.ts';
/** Minutes each: run by `npm run test:long` and by .ci/run, not by `npm test`. */
const LONG_TESTS = 'test/**/*.long.test.ts';

/** ms. For hangs alone: ten times what the slowest test takes on two cores, so that no test fails on a busy machine. */
const HANGS = { testTimeout: 120_000, hookTimeout: 180_000 };

/** All cores: vitest by itself leaves one to its main process, which has little to do. */
const maxWorkers = Math.max(2, availableParallelism());

export const tests = {
  publicDir: false,
  test: {
    maxWorkers,
    projects: [
      {
        plugins: [bundledTests()],
        test: {
          name: 'node',
          include: ['test/**/*.test.ts'],
          exclude: [BROWSER_TESTS, LONG_TESTS],
          sequence: { groupOrder: 0 },
          ...HANGS,
        },
      },
      {
        plugins: [bundledTests()],
        test: {
          name: 'browser',
          include: [BROWSER_TESTS],
          globalSetup: ['test/browser/globalSetup.ts'],
          // After the node project and one file at a time: a software-rendered page takes a whole core.
          sequence: { groupOrder: 1 },
          fileParallelism: false,
          ...HANGS,
        },
      },
    ],
  },
};

export const longTests = {
  publicDir: false,
  plugins: [bundledTests()],
  test: { maxWorkers, include: [LONG_TESTS], testTimeout: 1_800_000, hookTimeout: 1_800_000 },
};
