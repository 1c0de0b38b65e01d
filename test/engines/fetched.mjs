// Engines from npm, installed from test/engines/packages/package-lock.json, with integrity, when first needed.
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const HOME = fileURLToPath(new URL('../../node_modules/.cache/touchdown/engines', import.meta.url));
const PINS = fileURLToPath(new URL('packages', import.meta.url));
const LOCK = readFileSync(join(PINS, 'package-lock.json'), 'utf8');

/** Why the packages cannot be installed, or null if they are. */
function install() {
  const stamp = join(HOME, 'installed.json');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === LOCK) return null;
  mkdirSync(HOME, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) cpSync(join(PINS, file), join(HOME, file));
  console.error('fetching the engines …');
  const options = { cwd: HOME, encoding: 'utf8', shell: process.platform === 'win32' };
  const run = spawnSync('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error'], options);
  if (run.status !== 0) {
    const words = (run.stderr ?? '').split('\n').find((line) => /npm (error|ERR!)/.test(line));
    return words ?? run.error?.message ?? 'no reason given';
  }
  writeFileSync(stamp, LOCK);
  return null;
}

/** Cached for this process. */
let installed;

/** The folder of a package, installed if it is not there: { folder, version }, or { missing: why }. */
export function fetchPackage(name) {
  installed ??= { failure: install() };
  if (installed.failure !== null) return { missing: `npm does not bring ${name}: ${installed.failure}` };
  const { version } = JSON.parse(LOCK).packages[`node_modules/${name}`];
  return { folder: join(HOME, 'node_modules', name), version };
}

/** Path of a package's program in node_modules/.bin. */
export function binOf(name) {
  return join(HOME, 'node_modules/.bin', process.platform === 'win32' ? `${name}.cmd` : name);
}
