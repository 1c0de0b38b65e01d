// npm run mutants: changes the source in one place at a time and looks whether the room's tests notice.
//   npm run mutants -- [ROOM …] [--count 24] [--seed 1]
//   npm run mutants -- --at src/wire/messages/frame.ts:41    all changes of one line
// Prints the survivors by file and line, and "killed/tried" of each room. The changes are drawn by the seed: the same ones each time.
// Nothing is written to the source: the change is made while the tests' bundles are built (test/bundle.mjs).
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
  wire: ['wire'],
  prediction: ['prediction'],
  readout: ['readout'],
  authority: ['authority', 'scenarios'],
  scenarios: ['scenarios'],
  game: ['game', 'example'],
  gateway: ['gateway'],
  playground: ['playground'],
  scene: ['scene'],
};
/** ms; a loop without an end is noticed too. */
const TIME_LIMIT = 300_000;

function filesUnder(folder, matching) {
  return readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => join(folder, name).replaceAll('\\', '/'))
    .filter((path) => matching.test(path) && !path.includes('/generated/'))
    .sort();
}

/** Rooms that are tested on pages in Chromium, which come from the development server: all its tests stand before each source. */
const ON_PAGES = { hud: 'browser/hud' };

/** Which source files stand behind each test file of a room: [[test, Set of sources], …]. */
async function sourcesBehind(room) {
  if (room in ON_PAGES) {
    const all = new Set(filesUnder(`src/${room}`, /\.ts$/));
    return filesUnder(`test/${ON_PAGES[room]}`, /\.test\.ts$/).map((test) => [test, all]);
  }
  const tests = ROOMS[room].flatMap((folder) => filesUnder(`test/${folder}`, /(?<!\.long)\.test\.ts$/));
  const behind = [];
  for (const test of tests) {
    const { modules } = await bundle(join(ROOT, test));
    behind.push([test, new Set(modules.map((module) => relative(ROOT, module).replaceAll('\\', '/')))]);
  }
  return behind;
}

/** Runs test files on the changed source: true when all pass. */
function passes(tests, mutant) {
  const project = tests[0].startsWith('test/browser') ? 'browser' : 'node';
  const args = [
    'node_modules/vitest/vitest.mjs',
    'run',
    '--project',
    project,
    '--maxWorkers',
    '1',
    '--bail',
    '1',
  ];
  // A test that is skipped would pass.
  const told = { TOUCHDOWN_MUTANT: mutant ? JSON.stringify(mutant) : '', TOUCHDOWN_NO_SKIP: '1' };
  const env = { ...process.env, ...told };
  const options = { cwd: ROOT, env, stdio: 'ignore', timeout: TIME_LIMIT };
  return new Promise((resolve) => {
    spawn(process.execPath, [...args, '--reporter', 'dot', ...tests], options).on('close', (code) =>
      resolve(code === 0),
    );
  });
}

/** Calls `work` with each item, as many at a time as there are cores. */
async function forEach(items, work) {
  const left = [...items];
  const lane = async () => {
    for (let item = left.shift(); item !== undefined; item = left.shift()) await work(item);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, lane));
}

/** Those of the test files that pass without any change, the quickest first; only they can tell of one. */
async function passingOf(behind) {
  const passing = [];
  await forEach(behind, async (one) => {
    const began = performance.now();
    if (await passes([one[0]])) passing.push({ one, took: performance.now() - began });
    else console.log(`  left out, it fails without any change: ${one[0]}`);
  });
  return passing.sort((a, b) => a.took - b.took).map(({ one }) => one);
}

/** Whether all tests pass on the changed source. The slower half is asked only where the quicker has noticed nothing. */
async function survivesAll(tests, mutant) {
  const half = Math.ceil(tests.length / 2);
  for (const part of [tests.slice(0, half), tests.slice(half)])
    if (part.length > 0 && !(await passes(part, mutant))) return false;
  return true;
}

/** Tries the changes of a room that `choose` picks out of all. */
async function tryRoom(room, choose) {
  const behind = await passingOf(await sourcesBehind(room));
  const all = filesUnder(`src/${room}`, /(?<!\.d)\.ts$/).flatMap((path) =>
    changesOf(path, readFileSync(join(ROOT, path), 'utf8')).map((change) => ({ path, ...change })),
  );
  const tried = choose(all);
  let survivors = 0;
  await forEach(tried, async (mutant) => {
    const tests = behind.filter(([, sources]) => sources.has(mutant.path)).map(([test]) => test);
    const survives = await survivesAll(tests, mutant);
    if (survives) {
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
  },
});
const { count, seed, at } = values;
const draw = (all) => sampleOf(all, Number(count), Number(seed));
const atLine = (all) => all.filter(({ path, line }) => `${path}:${line}` === at);
const named = at === undefined ? positionals : [at.split('/')[1]];
const known = Object.keys({ ...ROOMS, ...ON_PAGES });
const rooms = named.length > 0 ? named : known;
const unknown = rooms.find((room) => !known.includes(room));
if (unknown) throw new Error(`no room ${unknown}; there are ${known.join(', ')}`);
for (const room of rooms) await tryRoom(room, at === undefined ? draw : atLine);
