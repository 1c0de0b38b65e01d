// Which files are tests and how they run. A new test file anywhere under test/ is picked up by its name alone.
import { mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { BaseSequencer } from 'vitest/node';
import { bundledTests, bundleRun } from './bundle.mjs';

const BROWSER_TESTS = 'test/browser/**/*.test.ts';
/** Those that wait for programs that they start: Python, Redis, a C compiler, node. */
const PROGRAM_TESTS = [
  ...['service', 'exact'].map((room) => `test/${room}/**/*.test.ts`),
  'test/**/heap.test.ts',
  ...[
    'architecture/setup',
    'dynamics/bodies/day',
    'gateway/gateway',
    'parity/main',
    'wire/protobuf/codec',
  ].map((name) => `test/${name}.test.ts`),
];
/** Minutes each: run by `npm run test:long` and by .ci/run, not by `npm test`. */
const LONG_TESTS = 'test/**/*.long.test.ts';
/** Those that measure in real time, which a busy machine would change. */
const ALONE = [
  'test/browser/pilot/firstMinute*.long.test.ts',
  'test/live/{bounce,hostile,pages}.long.test.ts',
  'test/prediction/harness/inChromium.long.test.ts',
];

const cores = availableParallelism();

/** Whether this is a runner of test/mutants: one of several, and killed at its end. */
const isOfMutants = process.env.TOUCHDOWN_MUTANT !== undefined;

/**
 * ms, for hangs only: ten times the slowest test's time on two cores, so that no test fails on a busy machine. With a change by
 * test/mutants, polled conditions often never occur.
 */
const HANGS = {
  testTimeout: 300_000,
  hookTimeout: 300_000,
  expect: { poll: { timeout: isOfMutants ? 15_000 : 120_000 } },
};

/** Puts what tests, and the programs that they start, leave in the temporary folder into one that goes with the run. */
function ownTemporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-tests-'));
  process.env.TMPDIR = folder;
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
}
if (!isOfMutants) ownTemporaryFolder();

/** Projects whose files share most of what they import. */
const SHARING = new Set(['node', 'programs']);

/**
 * Bundles the run's files before it begins: those of SHARING together, so that what they share is compiled once in each process. Files
 * of the browser share little, and each has a connection to a Chromium that ends with it.
 */
class Bundled extends BaseSequencer {
  async sort(files) {
    const pathsOf = (isSharing) =>
      files.filter(({ project }) => SHARING.has(project.name) === isSharing).map(({ moduleId }) => moduleId);
    bundleRun([pathsOf(true), ...pathsOf(false).map((path) => [path])]);
    return super.sort(files);
  }
}

/** Those that wait for half a minute, or compute for seconds, the longest first, so that none ends long after the others. */
const FIRST = [
  ...['service/service', 'pageRuns', 'pageDevices', 'pageReturns', 'pageGame', 'offline', 'hudFits', 'page'],
  ...['pageAxe', 'pagesTogether', 'pageKeys', 'hudPictures', 'pageFits', 'hudFleet', 'pageTroubles'],
  ...['ground/ground', 'game/live', 'simulation/law', 'package/examples', 'game/parts', 'leanPredictor'],
].map((name) => `/${name}.test.ts`);

/** The longest first, then those of the browser: a worker changes from one kind to the other once, since each change starts a process. */
class LongestFirst extends Bundled {
  async sort(files) {
    const rank = ({ project, moduleId }) => {
      const found = FIRST.findIndex((name) => moduleId.endsWith(name));
      if (found >= 0) return found;
      return FIRST.length + (project.name === 'programs' ? 1 : 0);
    };
    return (await super.sort(files)).sort((a, b) => rank(a) - rank(b));
  }
}

/**
 * Files that compute come first, one worker a core: each worker compiles the law anew. Then those that wait for pages and programs most of
 * the time, more of them at once; a run of test/mutants is one of several.
 */
const COMPUTING = { isolate: false, ...HANGS };
const WAITING = {
  isolate: false,
  maxWorkers: isOfMutants ? 1 : 4 * cores,
  sequence: { groupOrder: 1 },
  ...HANGS,
};

export const tests = {
  publicDir: false,
  test: {
    maxWorkers: cores,
    sequence: { sequencer: LongestFirst },
    projects: [
      {
        plugins: [bundledTests()],
        test: {
          name: 'node',
          include: ['test/**/*.test.ts'],
          exclude: [BROWSER_TESTS, ...PROGRAM_TESTS, LONG_TESTS],
          ...COMPUTING,
        },
      },
      {
        plugins: [bundledTests()],
        test: { name: 'programs', include: PROGRAM_TESTS, exclude: [LONG_TESTS], ...WAITING },
      },
      {
        plugins: [bundledTests()],
        test: {
          name: 'browser',
          include: [BROWSER_TESTS],
          exclude: [LONG_TESTS],
          globalSetup: ['test/browser/globalSetup.ts'],
          ...WAITING,
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
          globalSetup: ['test/browser/globalSetup.ts'],
          // One after the other, after the rest. The browsers and servers that the newcomers share run from the first group on; idle, all
          // of them take less than a thousandth of a core.
          maxWorkers: 1,
          sequence: { groupOrder: 2 },
          ...LONG_HANGS,
        },
      },
    ],
  },
};
