// Finds a Python that can run the physics service, with the Redis client it needs.
//   node .ci/python.mjs     installs what is missing; prints nothing if nothing is
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
/** In node_modules: nothing is installed outside of the repository. */
const packages = join(root, 'node_modules/.cache/touchdown/python');
/** Compiled modules: no folder of sources gets a __pycache__, and no start compiles them anew. */
const compiled = join(root, 'node_modules/.cache/touchdown/pycache');
const service = join(root, 'src/service');
const REDIS = 'redis>=5.0,<8';

function run(command, args, env = process.env) {
  return spawnSync(command, args, { encoding: 'utf8', env });
}

/** Python's module path: the service, then its installed packages. */
function environment() {
  const path = [service, packages, process.env.PYTHONPATH]
    .filter(Boolean)
    .join(process.platform === 'win32' ? ';' : ':');
  const caching = { PYTHONDONTWRITEBYTECODE: '', PYTHONPYCACHEPREFIX: compiled };
  return { ...process.env, ...caching, PYTHONPATH: path, PYTHONUNBUFFERED: '1' };
}

/**
 * { command, env } to run the service's law, without a Redis client; undefined where no Python is new enough.
 * The command is the interpreter itself, not a shim: signals must reach it.
 */
export function findPython() {
  const program = 'import sys; print(sys.executable); sys.exit(sys.version_info < (3, 10))';
  for (const command of [process.env.PYTHON, 'python3', 'python'].filter(Boolean)) {
    const found = run(command, ['-c', program]);
    if (found.status === 0) return { command: found.stdout.trim(), env: environment() };
  }
  return undefined;
}

let ready;

/**
 * { command, env } to run the service; throws an Error that names what to install.
 */
export function servicePython() {
  ready ??= withRedis();
  return ready;
}

function withRedis() {
  const python = findPython();
  if (python === undefined)
    throw new Error(
      'Python 3.10 or newer is needed for the physics service: apt-get install -y python3 python3-pip, or https://python.org',
    );
  const { command, env } = python;
  if (run(command, ['-c', 'import redis'], env).status === 0) return python;
  mkdirSync(packages, { recursive: true });
  console.log('set-up: installing the Redis client for Python …');
  const install = run(command, [
    '-m',
    'pip',
    'install',
    '--quiet',
    '--disable-pip-version-check',
    '--target',
    packages,
    REDIS,
  ]);
  if (install.status !== 0 || !existsSync(join(packages, 'redis')))
    throw new Error(
      `the Redis client for Python cannot be installed: ${(install.stderr || 'pip is missing: apt-get install -y python3-pip').trim()}`,
    );
  return python;
}

/** The redis-server on this machine; throws an Error with the one line that installs it. */
export function redisServer() {
  const found = run('redis-server', ['--version']);
  if (found.status === 0) return 'redis-server';
  const how = process.platform === 'darwin' ? 'brew install redis' : 'sudo apt-get install -y redis-server';
  throw new Error(`Redis is needed: ${how}`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    servicePython();
    redisServer();
  } catch (error) {
    console.error(`set-up: ${error.message}`);
    process.exit(1);
  }
}
