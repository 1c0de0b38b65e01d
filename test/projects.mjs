// Which files are tests and how they run. A new test file anywhere under test/ is picked up by its name alone.
import { availableParallelism } from 'node:os';
import { BaseSequencer } from 'vitest/node';
import { bundledTests, bundleRun } from './bundle.mjs';

const BROWSER_TESTS = 'test/browser/**/*.test.ts';
/** Minutes each: run by `npm run test:long` and by .ci/run, not by `npm test`. */
const LONG_TESTS = 'test/**/*.long.test.ts';
/** Those that measure in real time what a busy machine would change. */
const ALONE = ['test/live/**/*.long.test.ts', 'test/prediction/harness/inChromium.long.test.ts'];

/** ms. For hangs alone: ten times what the slowest test takes on two cores, so that no test fails on a busy machine. */
const HANGS = { testTimeout: 300_000, hookTimeout: 300_000, expect: { poll: { timeout: 120_000 } } };

/**
 * More than cores: a browser test waits for its page most of the time, and the node files behind it would wait too. Not many more: each
 * worker compiles what node files share anew.
 */
const maxWorkers = 3 * availableParallelism();

/**
 * Bundles the run's files before it begins: those of node together, so that what they share is compiled once in each process. Files
 * of the browser share little, and each has a connection to a Chromium that ends with it.
 */
class Bundled extends BaseSequencer {
  async sort(files) {
    const pathsOf = (isNode) =>
      files.filter(({ project }) => (project.name === 'node') === isNode).map(({ moduleId }) => moduleId);
    bundleRun([pathsOf(true), ...pathsOf(false).map((path) => [path])]);
    return super.sort(files);
  }
}

/** Those that wait for a minute, or compute for seconds: what starts last ends last. */
const FIRST_OF_BROWSER = /(pageRuns|pagesTogether|pageDevices|pageGame)\.test\.ts$/;
const FIRST_OF_NODE =
  /(service\/(service|recorder)|exact\/\w+|game\/live|simulation\/law|ground\/ground|heap|bodies\/day|examples)\.test\.ts$/;

/**
 * Browser files first: node files compute while they wait. A worker changes from one kind to the other once, since each change starts
 * a process.
 */
class BrowserFirst extends Bundled {
  async sort(files) {
    const rank = ({ project, moduleId }) =>
      project.name === 'browser'
        ? Number(!FIRST_OF_BROWSER.test(moduleId))
        : 2 + Number(!FIRST_OF_NODE.test(moduleId));
    return (await super.sort(files)).sort((a, b) => rank(a) - rank(b));
  }
}

export const tests = {
  publicDir: false,
  test: {
    maxWorkers,
    sequence: { sequencer: BrowserFirst },
    projects: [
      {
        plugins: [bundledTests()],
        test: {
          name: 'node',
          include: ['test/**/*.test.ts'],
          exclude: [BROWSER_TESTS, LONG_TESTS],
          // Files of a process share the source: it keeps nothing from one call to the next but scratch, and a worker’s program, which its
          // tests load anew.
          isolate: false,
          ...HANGS,
        },
      },
      {
        plugins: [bundledTests()],
        test: {
          name: 'browser',
          include: [BROWSER_TESTS],
          exclude: [LONG_TESTS],
          globalSetup: ['test/browser/globalSetup.ts'],
          isolate: false,
          ...HANGS,
        },
      },
    ],
  },
};

/** ms. Minutes of flight, or a series of restarts. */
const LONG_HANGS = { testTimeout: 1_800_000, hookTimeout: 1_800_000 };

export const longTests = {
  publicDir: false,
  test: {
    sequence: { sequencer: Bundled },
    reporters: ['default', ['json', { outputFile: 'node_modules/.cache/touchdown/long-tests.json' }]],
    projects: [
      {
        plugins: [bundledTests()],
        test: {
          name: 'long',
          include: [LONG_TESTS],
          exclude: ALONE,
          globalSetup: ['test/browser/globalSetup.ts'],
          maxWorkers: availableParallelism(),
          sequence: { groupOrder: 1 },
          ...LONG_HANGS,
        },
      },
      {
        plugins: [bundledTests()],
        test: {
          name: 'alone',
          include: ALONE,
          // One after the other, after the rest, and without the browsers and servers that the page's tests share.
          maxWorkers: 1,
          sequence: { groupOrder: 2 },
          ...LONG_HANGS,
        },
      },
    ],
  },
};
