// npm run mutants: changes the source in one place at a time and checks whether the room's tests fail.
//   npm run mutants -- [ROOM …] [--count 24] [--seed 1] [--workers 2] [--no-pages]
//   npm run mutants -- --at src/wire/messages/frame.ts:41    all changes of one line; without :41 of the file
// --no-pages leaves out the tests in a browser, which take minutes: the score is then at least what is printed.
// Prints the survivors by file and line, and "killed/tried" of each room. The changes are drawn by the seed: the same ones each time.
// Nothing is written to the source: the change is made while the tests' bundles and the page are built (plugins.mjs).
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { bundle } from '../bundle.mjs';
import { createLane } from './lanes.mjs';
import { changesOf, sampleOf } from './mutate.mjs';
import { blockAt, blocksOf } from './probes.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
/** Rooms, and the folders of the tests that hold each. */
const ROOMS = {
  dynamics: ['dynamics', 'exact', 'engines', 'parity'],
  protocol: ['wire'],
  wire: ['wire'],
  prediction: ['prediction'],
  readout: ['readout'],
  authority: ['authority', 'scenarios'],
  scenarios: ['scenarios', 'parity', 'playground/game/mission'],
  game: ['game', 'example'],
  gateway: ['gateway'],
  hud: ['hud', 'browser/hud'],
  scene: ['scene', 'browser/playground'],
  playground: ['playground', 'browser/playground', 'browser/pilot'],
};
/** ms; a loop without an end is noticed too. */
const TIME_LIMIT = 300_000;
/** ms that the first group of tests takes at most, unless its one test takes longer. */
const FIRST_STAGE = 1500;

function filesUnder(folder, matching) {
  return readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => join(folder, name).replaceAll('\\', '/'))
    .filter((path) => matching.test(path) && !path.includes('/generated/'))
    .sort();
}

const isOnPages = (test) => test.startsWith('test/browser/');

/** The room's source files that each test file loads: [[test, Set of sources], …]. A page may load any of them. */
async function sourcesBehind(room) {
  const all = new Set(filesUnder(`src/${room}`, /\.ts$/));
  const tests = ROOMS[room]
    .flatMap((folder) => filesUnder(`test/${folder}`, /(?<!\.long)\.test\.ts$/))
    .filter((test) => values.pages || !isOnPages(test));
  const behind = [];
  for (const test of tests) {
    if (isOnPages(test)) behind.push([test, all]);
    else {
      const { modules } = await bundle(join(ROOT, test));
      behind.push([test, new Set(modules.map((module) => relative(ROOT, module).replaceAll('\\', '/')))]);
    }
  }
  return behind.filter(([, sources]) => [...all].some((path) => sources.has(path)));
}

/** Calls `work` with each item, `values.workers` at a time; each worker has a lane per project. */
async function forEach(items, work) {
  const left = [...items];
  const lane = async () => {
    const lanes = { node: createLane('node'), browser: createLane('browser') };
    for (let item = left.shift(); item !== undefined; item = left.shift()) await work(item, lanes);
    Object.values(lanes).forEach((one) => one.close());
  };
  await Promise.all(Array.from({ length: Number(values.workers) }, lane));
}

const projectOf = (test) => (isOnPages(test) ? 'browser' : 'node');

/**
 * Runs the room's tests without any change. Those that pass can detect one: { passing: [{ test, sources, took, running }], loading },
 * the quickest first, with the blocks that the tests of each reach and those that loading the source does.
 */
async function withoutChange(behind) {
  const probes = join(mkdtempSync(join(tmpdir(), 'touchdown-probes-')), 'reached.jsonl');
  const files = [];
  for (const project of ['node', 'browser']) {
    const tests = behind.map(([test]) => test).filter((test) => projectOf(test) === project);
    if (tests.length === 0) continue;
    const lane = createLane(project, probes);
    const answer = await lane.run(tests, null, tests.length * TIME_LIMIT);
    lane.close();
    if (answer === null) throw new Error(`the tests of ${project} do not end without any change`);
    files.push(...answer.files);
  }
  const reports = new Map(
    readFileSync(probes, 'utf8')
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line))
      .map((report) => [relative(ROOT, report.test).replaceAll('\\', '/'), report]),
  );
  rmSync(dirname(probes), { recursive: true });
  for (const { test, isPassed } of files)
    if (!isPassed) console.log(`  left out, it fails without any change: ${test}`);
  const sources = new Map(behind);
  const passing = files
    .filter(({ isPassed }) => isPassed)
    .map(({ test, took }) => ({
      ...{ test, took, sources: sources.get(test) },
      running: new Set(reports.get(test)?.running),
    }));
  passing.sort((a, b) => isOnPages(a.test) - isOnPages(b.test) || a.took - b.took);
  return { passing, loading: new Set([...reports.values()].flatMap(({ loading }) => loading)) };
}

/** The tests that run the changed block; at the top of a module, and where loading a module runs it, those that load the module. */
function testsReaching({ path, start }, { passing, loading }) {
  const index = blockAt(blocksOf(path, readFileSync(join(ROOT, path), 'utf8')), start);
  const block = `${path}:${index}`;
  const isLoaded = index < 0 || loading.has(block);
  return passing.filter(({ sources, running }) => (isLoaded ? sources.has(path) : running.has(block)));
}

/** Groups of tests, each for one run: few changes survive the first, which takes a fraction of the last's time. */
function stagesOf(passing) {
  const stages = [];
  let stage = { limit: 0 };
  for (const { test, took } of passing) {
    const project = projectOf(test);
    if (project !== stage.project || stage.took + took > stage.limit) {
      const limit = Math.max(took, FIRST_STAGE, 3 * stage.limit);
      stage = { project, tests: [], took: 0, limit };
      stages.push(stage);
    }
    stage.tests.push(test);
    stage.took += took;
  }
  return stages;
}

async function survivesAll(concerned, mutant, lanes) {
  for (const { project, tests, took } of stagesOf(concerned)) {
    const answer = await lanes[project].run(tests, mutant, Math.min(TIME_LIMIT, 10_000 + 10 * took));
    if (!answer?.isPassed) return false;
  }
  return true;
}

/** Tries the changes of a room that `choose` picks out of all. */
async function tryRoom(room, choose) {
  const known = await withoutChange(await sourcesBehind(room));
  const all = filesUnder(`src/${room}`, /(?<!\.d)\.ts$/).flatMap((path) =>
    changesOf(path, readFileSync(join(ROOT, path), 'utf8')).map((change) => ({ path, ...change })),
  );
  const tried = choose(all);
  let survivors = 0;
  await forEach(tried, async (mutant, lanes) => {
    const concerned = testsReaching(mutant, known);
    if (await survivesAll(concerned, mutant, lanes)) {
      survivors += 1;
      const by = concerned.length === 0 ? 'no test reaches it' : `${concerned.length} test files reach it`;
      console.log(`  survives: ${mutant.path}:${mutant.line}  ${mutant.says}  (${by})`);
    } else process.stderr.write('.');
  });
  process.stderr.write('\n');
  const killed = tried.length - survivors;
  console.log(`${room}: ${killed}/${tried.length} killed (${all.length} possible)`);
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  allowNegative: true,
  options: {
    pages: { type: 'boolean', default: true },
    count: { type: 'string', default: '24' },
    seed: { type: 'string', default: '1' },
    at: { type: 'string' },
    workers: { type: 'string', default: String(availableParallelism()) },
  },
});
const { count, seed, at } = values;
const draw = (all) => sampleOf(all, Number(count), Number(seed));
const inPlace = (all) => all.filter(({ path, line }) => path === at || `${path}:${line}` === at);
const named = at === undefined ? positionals : [at.split('/')[1]];
const known = Object.keys(ROOMS);
const rooms = named.length > 0 ? named : known;
const unknown = rooms.find((room) => !known.includes(room));
if (unknown) throw new Error(`no room ${unknown}; there are ${known.join(', ')}`);
for (const room of rooms) await tryRoom(room, at === undefined ? draw : inPlace);
