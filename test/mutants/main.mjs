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

/** Which source files stand behind each test file of a room: [[test, Set of sources], …]. */
async function sourcesBehind(room) {
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
  const args = [
    'node_modules/vitest/vitest.mjs',
    'run',
    '--project',
    'node',
    '--maxWorkers',
    '1',
    '--bail',
    '1',
  ];
  const env = { ...process.env, TOUCHDOWN_MUTANT: mutant ? JSON.stringify(mutant) : '' };
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
  const survivors = [];
  await forEach(tried, async (mutant) => {
    const tests = behind.filter(([, sources]) => sources.has(mutant.path)).map(([test]) => test);
    const survives = await survivesAll(tests, mutant);
    if (survives) survivors.push(mutant);
    process.stderr.write(survives ? 'S' : '.');
  });
  process.stderr.write('\n');
  for (const { path, line, says } of survivors) console.log(`  survives: ${path}:${line}  ${says}`);
  const killed = tried.length - survivors.length;
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
const rooms = named.length > 0 ? named : Object.keys(ROOMS);
const unknown = rooms.find((room) => !(room in ROOMS));
if (unknown) throw new Error(`no room ${unknown}; there are ${Object.keys(ROOMS).join(', ')}`);
for (const room of rooms) await tryRoom(room, at === undefined ? draw : atLine);
