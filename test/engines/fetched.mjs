// Engines that npm brings, fetched into node_modules/.cache/touchdown/engines when they are first asked for.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const HOME = fileURLToPath(new URL('../../node_modules/.cache/touchdown/engines', import.meta.url));

/** Exact versions: a hash says something about the engine that made it. */
const VERSIONS = {
  bun: '1.4.5',
  deno: '2.9.6',
  'hermes-engine-cli': '0.12.0',
  'quickjs-emscripten': '0.32.0',
  '@jitl/quickjs-ng-wasmfile-release-sync': '0.32.0',
};

/**
 * The folder of an installed package, fetched if it is not there: { folder, version }, or { missing: why }.
 * @param {string} name a key of VERSIONS
 */
export function fetchPackage(name) {
  const folder = join(HOME, 'node_modules', name);
  const manifest = join(folder, 'package.json');
  const version = VERSIONS[name];
  const isThere = () =>
    existsSync(manifest) && JSON.parse(readFileSync(manifest, 'utf8')).version === version;
  if (isThere()) return { folder, version };
  mkdirSync(HOME, { recursive: true });
  const project = join(HOME, 'package.json');
  if (!existsSync(project)) writeFileSync(project, '{ "private": true }\n');
  console.error(`fetching ${name} ${version} …`);
  const run = spawnSync(
    'npm',
    ['install', `${name}@${version}`, '--no-audit', '--no-fund', '--loglevel=error'],
    {
      cwd: HOME,
      encoding: 'utf8',
      shell: process.platform === 'win32',
    },
  );
  if (isThere()) return { folder, version };
  const words = (run.stderr ?? '').split('\n').find((line) => /npm (error|ERR!)/.test(line));
  return {
    missing: `npm does not bring ${name} ${version}: ${words ?? run.error?.message ?? 'no reason given'}`,
  };
}

/** Path of a program that a fetched package puts into node_modules/.bin. */
export function binOf(name) {
  return join(HOME, 'node_modules/.bin', process.platform === 'win32' ? `${name}.cmd` : name);
}
