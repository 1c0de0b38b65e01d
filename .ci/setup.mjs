// Installs what `npm start` or `npm test` needs and is missing.
//   node .ci/setup.mjs start    what the page needs
//   node .ci/setup.mjs test     that, and what tests, checks and builds need
// It compares package-lock.json with node_modules, so that a run on a complete machine
// installs nothing, needs no network and prints nothing.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** Oldest minor version of each major version of node that vite runs on; majors above the last are fine. */
const OLDEST_NODE = { 20: 19, 22: 12 };

/** No audit, no funding messages, and a registry that cannot be reached fails in seconds instead of minutes. */
const QUIETLY = [
  ...['--no-audit', '--no-fund', '--loglevel=error'],
  ...['--fetch-retry-mintimeout=1000', '--fetch-retry-maxtimeout=4000'],
];

/** Causes of npm's errors in plain words; the first match is printed. */
const CAUSES = [
  [
    /ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH/,
    'the package registry cannot be reached: check the network, or set a proxy (npm config set proxy …).',
  ],
  [/ENOSPC/, 'the disk is full.'],
  [
    /EACCES|EPERM|EROFS/,
    'a file cannot be written: check whether this folder or npm’s cache belongs to another user.',
  ],
  [/EINTEGRITY/, 'a package differs from what package-lock.json recorded: try `npm cache clean --force`.'],
  [
    /EUSAGE|in sync|from lock file/,
    'package.json and package-lock.json disagree: run `npm install` and commit both.',
  ],
  [/E404|ETARGET/, 'the package registry in use does not have a package that package-lock.json names.'],
];

/** Why this node cannot be used, or null. `version` is like "20.19.0". */
export function nodeComplaint(version) {
  const [major = 0, minor = 0] = version.split('.').map(Number);
  const newest = Math.max(...Object.keys(OLDEST_NODE).map(Number));
  if (major > newest || (major in OLDEST_NODE && minor >= OLDEST_NODE[major])) return null;
  return `node ${version} is too old: node 20.19, 22.12 or newer is needed (https://nodejs.org).`;
}

/** Whether a lock entry restricted to some systems is for this one. */
function isForThisMachine(entry, machine) {
  const allows = (list, own) => !list || list.includes(own);
  return allows(entry.os, machine.os) && allows(entry.cpu, machine.cpu) && allows(entry.libc, machine.libc);
}

/** Whether `entry` of package-lock.json must be in node_modules for `purpose`. */
function isNeeded(entry, purpose, machine) {
  if (purpose === 'start' && (entry.dev || entry.devOptional)) return false;
  if (!entry.optional) return true;
  // npm may omit optional packages, but a native one for this system must be there.
  return Boolean(entry.os && entry.cpu) && isForThisMachine(entry, machine);
}

/** Paths (as in the lock's `packages`) which `purpose` needs and for which `versionAt(path)` is not the lock's. */
export function missingPackages(packages, purpose, machine, versionAt) {
  return Object.keys(packages).filter(
    (path) =>
      path !== '' && isNeeded(packages[path], purpose, machine) && versionAt(path) !== packages[path].version,
  );
}

/** Why npm failed, in one sentence. */
export function causeOf(npmErrors) {
  const found = CAUSES.find(([pattern]) => pattern.test(npmErrors));
  return found ? found[1] : 'see npm’s output above.';
}

function thisMachine() {
  if (process.platform !== 'linux') return { os: process.platform, cpu: process.arch };
  process.report.excludeNetwork = true;
  const isGlibc = Boolean(process.report.getReport().header.glibcVersionRuntime);
  return { os: 'linux', cpu: process.arch, libc: isGlibc ? 'glibc' : 'musl' };
}

function readJson(path) {
  return JSON.parse(readFileSync(path, 'utf8'));
}

/** Runs npm where `npm run` found it, else the one on the PATH. On Windows npm is a script: it needs a shell. */
function npm(root, args) {
  const cli = process.env.npm_execpath;
  const options = { cwd: root, stdio: ['ignore', 'inherit', 'pipe'], encoding: 'utf8' };
  if (cli && /npm-cli\.[cm]?js$/.test(cli)) return spawnSync(process.execPath, [cli, ...args], options);
  return spawnSync('npm', args, { ...options, shell: process.platform === 'win32' });
}

function stop(message) {
  console.error(`set-up: ${message}`);
  process.exit(1);
}

function setUp(purpose) {
  if (purpose !== 'start' && purpose !== 'test')
    stop('expected a purpose: `node .ci/setup.mjs start` or `test`.');
  const complaint = nodeComplaint(process.versions.node);
  if (complaint) stop(complaint);
  const root = fileURLToPath(new URL('..', import.meta.url));
  const { packages } = readJson(join(root, 'package-lock.json'));
  const machine = thisMachine();
  const versionAt = (path) => {
    const manifest = join(root, path, 'package.json');
    return existsSync(manifest) ? readJson(manifest).version : undefined;
  };
  const missing = missingPackages(packages, purpose, machine, versionAt);
  if (missing.length === 0) return;

  // `npm ci` empties node_modules: test packages that are there are installed again.
  const hasTestPackages = versionAt('node_modules/vitest') !== undefined;
  const scope = purpose === 'test' || hasTestPackages ? ['--include=dev'] : ['--omit=dev'];
  const count = missing.length === 1 ? '1 package is' : `${missing.length} packages are`;
  console.log(`set-up: ${count} missing; npm ci ${scope[0]} …`);
  const started = Date.now();
  const run = npm(root, ['ci', ...scope, ...QUIETLY]);
  if (run.stderr) process.stderr.write(run.stderr);
  if (run.error)
    stop(`npm cannot be started (${run.error.message}): it comes with node (https://nodejs.org).`);
  if (run.status !== 0) stop(`npm ci failed: ${causeOf(run.stderr)}`);
  const still = missingPackages(packages, purpose, machine, versionAt);
  if (still.length > 0) stop(`npm ci succeeded, but these are still missing: ${still.join(', ')}`);
  console.log(`set-up: installed in ${((Date.now() - started) / 1000).toFixed(1)} s.`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) setUp(process.argv[2]);
