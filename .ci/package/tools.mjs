// The tools for checking the package, and temporary projects outside of this repository.
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const PACKAGE = join(root, 'dist/package');

const HOME = join(root, 'node_modules/.cache/touchdown/packageTools');
const PINS = join(root, '.ci/package/tools');

/** Runs a program and returns its output. Throws with the output if it fails. */
export function run(command, args, cwd) {
  const shell = process.platform === 'win32' && command === 'npm';
  const { status, stdout, stderr, error } = spawnSync(command, args, { cwd, encoding: 'utf8', shell });
  if (status !== 0)
    throw new Error(`${[command, ...args].join(' ')}\n${error?.message ?? `${stdout}${stderr}`}`);
  return `${stdout}${stderr}`;
}

/** Installs the tools of their lock file, unless they are installed. */
export function installTools() {
  const lock = readFileSync(join(PINS, 'package-lock.json'), 'utf8');
  const stamp = join(HOME, 'installed.json');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return;
  mkdirSync(HOME, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) cpSync(join(PINS, file), join(HOME, file));
  run('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error'], HOME);
  writeFileSync(stamp, lock);
}

/** Path of a file of the tools. */
export const tool = (path) => join(HOME, 'node_modules', path);

/** Packs the package and returns the path of the tarball. Throws if npm warns of anything. */
export function pack(folder) {
  const printed = run('npm', ['pack', PACKAGE, '--loglevel=warn', '--pack-destination', folder], root);
  const warning = printed.split('\n').find((line) => /npm (warn|error)/i.test(line) && !/nodedir/.test(line));
  if (warning !== undefined) throw new Error(`npm pack: ${warning}`);
  return join(folder, printed.trim().split('\n').at(-1));
}

/** Calls `use` with a project folder, outside of the repository, into which the tarball is installed by npm. */
export async function inProject(tarball, use) {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-consumer-'));
  try {
    writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }\n');
    run('npm', ['install', '--no-audit', '--no-fund', '--loglevel=error', '--offline', tarball], folder);
    return await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
