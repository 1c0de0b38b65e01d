// npm run mutants: changes the source in one place at a time and looks whether the room's tests notice.
//   npm run mutants -- [ROOM …] [--count 24] [--seed 1] [--workers 2]
//   npm run mutants -- --at src/wire/messages/frame.ts:41    all changes of one line; without :41 of the file
// Prints the survivors by file and line, and "killed/tried" of each room. The changes are drawn by the seed: the same ones each time.
// Nothing is written to the source: the change is made while the tests' bundles and the page are built (test/bundle.mjs).
import { spawn } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { bundle } from '../bundle.mjs';
import { changesOf, sampleOf } from './mutate.mjs';

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
  hud: ['browser/hud'],
  scene: ['scene', 'browser/playground'],
  playground: ['playground', 'browser/playground', 'browser/pilot'],
};
/** ms; a loop without an end is noticed too. */
const TIME_LIMIT = 300_000;
/** ms that the first group of tests takes at most, unless its one test takes longer. */
const FIRST_STAGE = 3000;

function filesUnder(folder, matching) {
  return readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => join(folder, name).replaceAll('\\', '/'))
    .filter((path) => matching.test(path) && !path.includes('/generated/'))
    .sort();
}

const isOnPages = (test) => test.startsWith('test/browser/');

/** Which source files of a room stand behind each test file: [[test, Set of sources], …]. A page may load any of them. */
async function sourcesBehind(room) {
  const all = new Set(filesUnder(`src/${room}`, /\.ts$/));
  const tests = ROOMS[room].flatMap((folder) => filesUnder(`test/${folder}`, /(?<!\.long)\.test\.ts$/));
  const behind = [];
  for (const test of tests) {
    if (isOnPages(test)) behind.push([test, all]);
    else {
      const { modules } = await bundle(join(ROOT, test));
      behind.push([test, new Set(modules.map((module) => relative(ROOT, module).replaceAll('\\', '/')))]);
    }
  }
  return behind;
}

/** Groups of processes that an interrupted sampling must not leave. */
const running = new Set();
const endGroup = (pid) => process.kill(-pid, 'SIGKILL');
process.on('exit', () => running.forEach(endGroup));
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(1));

/** Runs test files on the changed source: true when all pass within `limit` ms. */
function passes(tests, mutant, limit = TIME_LIMIT) {
  const project = isOnPages(tests[0]) ? 'browser' : '!browser';
  const args = ['run', '--project', project, '--maxWorkers', '1', '--bail', '1', '--reporter', 'dot'];
  // A test that is skipped would pass.
  const variables = { TOUCHDOWN_MUTANT: mutant ? JSON.stringify(mutant) : '', TOUCHDOWN_NO_SKIP: '1' };
  const options = { cwd: ROOT, env: { ...process.env, ...variables }, stdio: 'ignore', detached: true };
  const run = spawn(process.execPath, ['node_modules/vitest/vitest.mjs', ...args, ...tests], options);
  // The whole group: a worker in an endless loop outlives the runner.
  const end = setTimeout(() => endGroup(run.pid), limit);
  running.add(run.pid);
  return new Promise((resolve) => {
    run.on('close', (code) => {
      clearTimeout(end);
      running.delete(run.pid);
      resolve(code === 0);
    });
  });
}

/** Calls `work` with each item, `workers` at a time. */
async function forEach(items, work) {
  const left = [...items];
  const lane = async () => {
    for (let item = left.shift(); item !== undefined; item = left.shift()) await work(item);
  };
  await Promise.all(Array.from({ length: Number(values.workers) }, lane));
}

/** Those of the test files that pass without any change, which alone can tell of one: [{ test, sources, took }], the quickest first. */
async function passingOf(behind) {
  const passing = [];
  await forEach(behind, async ([test, sources]) => {
    const began = performance.now();
    if (await passes([test])) passing.push({ test, sources, took: performance.now() - began });
    else console.log(`  left out, it fails without any change: ${test}`);
  });
  return passing.sort((a, b) => isOnPages(a.test) - isOnPages(b.test) || a.took - b.took);
}

/** Groups of tests, each for one run: few changes survive the first, which takes a fraction of the last's time. */
function stagesOf(passing) {
  const stages = [];
  let stage = { limit: 0 };
  for (const { test, took } of passing) {
    const onPages = isOnPages(test);
    if (onPages !== stage.onPages || stage.took + took > stage.limit) {
      const limit = Math.max(took, FIRST_STAGE, 3 * stage.limit);
      stage = { onPages, tests: [], took: 0, limit };
      stages.push(stage);
    }
    stage.tests.push(test);
    stage.took += took;
  }
  return stages;
}

async function survivesAll(passing, mutant) {
  for (const { tests, took } of stagesOf(passing))
    if (!(await passes(tests, mutant, Math.min(TIME_LIMIT, 10_000 + 10 * took)))) return false;
  return true;
}

/** Tries the changes of a room that `choose` picks out of all. */
async function tryRoom(room, choose) {
  const passing = await passingOf(await sourcesBehind(room));
  const all = filesUnder(`src/${room}`, /(?<!\.d)\.ts$/).flatMap((path) =>
    changesOf(path, readFileSync(join(ROOT, path), 'utf8')).map((change) => ({ path, ...change })),
  );
  const tried = choose(all);
  let survivors = 0;
  await forEach(tried, async (mutant) => {
    const concerned = passing.filter(({ sources }) => sources.has(mutant.path));
    if (await survivesAll(concerned, mutant)) {
      survivors += 1;
      console.log(`  survives: ${mutant.path}:${mutant.line}  ${mutant.says}`);
    } else process.stderr.write('.');
  });
  process.stderr.write('\n');
  const killed = tried.length - survivors;
  console.log(`${room}: ${killed}/${tried.length} killed (${all.length} possible)`);
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
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
