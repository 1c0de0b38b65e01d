// The engines by family, and how each is found and run.
import { spawnSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { binOf, fetchPackage } from './fetched.mjs';

const QUICKJS = join(dirname(fileURLToPath(import.meta.url)), 'quickjs.mjs');
const QUICKJS_NG = '@jitl/quickjs-ng-wasmfile-release-sync';
/** Enough for a slow machine. */
const TIME_LIMIT = 300_000;

/** A command's version output, or null if there is no such command. */
function versionFrom(command, args) {
  const { status, stdout } = spawnSync(command, args, { encoding: 'utf8', timeout: 20_000 });
  return status === 0 ? (/\d+\.\d+(\.\d+)*/.exec(stdout)?.[0] ?? '') : null;
}

/** The first of these shells that is installed. */
function installed(names, versionArgs, hint) {
  for (const name of names) {
    const version = versionFrom(name, versionArgs);
    if (version !== null) return { label: `${name} ${version}`.trim(), command: [name] };
  }
  return { missing: `none of ${names.join(', ')} is installed (${hint})` };
}

function ofPackage(name, label, commandIn) {
  const found = fetchPackage(name);
  return found.missing ? found : { label: `${label} ${found.version}`, command: commandIn(found.folder) };
}

function hermes() {
  const folder = { linux: 'linux64-bin', darwin: 'osx-bin', win32: 'win64-bin' }[process.platform];
  if (!folder) return { missing: `no build for ${process.platform}` };
  return ofPackage('hermes-engine-cli', 'hermes', (at) => [join(at, folder, 'hermes')]);
}

function quickjs() {
  return ofPackage('quickjs-emscripten', 'quickjs', (at) => [process.execPath, QUICKJS, '{script}', at]);
}

function quickjsNg() {
  const host = fetchPackage('quickjs-emscripten');
  if (host.missing) return host;
  return ofPackage(QUICKJS_NG, 'quickjs-ng', (at) => [
    process.execPath,
    QUICKJS,
    '{script}',
    host.folder,
    at,
  ]);
}

/** In each family the one from npm comes first; the others are used if installed. */
export const ENGINES = [
  { family: 'V8', find: () => ({ label: `node ${process.versions.node}`, command: [process.execPath] }) },
  {
    family: 'V8',
    find: () => ofPackage('deno', 'deno', () => [binOf('deno'), 'run', '--quiet', '{script}']),
  },
  { family: 'JavaScriptCore', find: () => ofPackage('bun', 'bun', () => [binOf('bun')]) },
  {
    family: 'JavaScriptCore',
    // This shell does not print its version.
    find: () => installed(['jsc'], ['-e', 'print()'], 'Debian: libjavascriptcoregtk-4.0-bin'),
  },
  {
    family: 'SpiderMonkey',
    find: () =>
      installed(['js140', 'js128', 'js115', 'js102', 'js'], ['--version'], 'Debian: libmozjs-102-dev'),
  },
  { family: 'SpiderMonkey', find: () => installed(['gjs'], ['--version'], 'Debian: gjs') },
  { family: 'QuickJS', find: quickjs },
  { family: 'QuickJS', find: quickjsNg },
  { family: 'Hermes', find: hermes },
  { family: 'Boa', find: () => installed(['boa'], ['--version'], 'cargo install boa_cli') },
];

/** Runs the script; { lines } or { failure: why }. */
export function runScript(command, script) {
  const place = command.indexOf('{script}');
  const [program, ...args] = place < 0 ? [...command, script] : command.with(place, script);
  const run = spawnSync(program, args, {
    encoding: 'utf8',
    timeout: TIME_LIMIT,
    shell: process.platform === 'win32',
  });
  if (run.error) return { failure: run.error.message };
  if (run.status !== 0) return { failure: `exit ${run.status}: ${run.stderr.trim().slice(0, 500)}` };
  return { lines: run.stdout.trimEnd().split(/\r?\n/) };
}
