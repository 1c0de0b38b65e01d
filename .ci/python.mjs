// The Python that the physics service and its tests run on: a virtual environment under node_modules/.cache with the
// service's one dependency, made when it is first asked for.
//    node .ci/python.mjs    makes it, if need be, and prints the path of its interpreter
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** What pip installs: the version that the tests have run with. */
const REDIS = 'redis==8.1.0';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const HOME = join(ROOT, 'node_modules/.cache/touchdown/python');
const NEW_ENOUGH =
  'import sys; print("%d.%d.%d" % sys.version_info[:3]); sys.exit(sys.version_info < (3, 10))';

/** The folder of the package touchdown_service: the interpreter finds it when it runs there. */
export const SERVICE_HOME = join(ROOT, 'src/service');

/** Path of an interpreter that has what the service needs. @throws with the line that helps */
export function servicePython() {
  const python = join(HOME, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python');
  if (existsSync(python) && readInstalled() === REDIS) return python;
  const system = process.env.PYTHON ?? 'python3';
  const version = spawnSync(system, ['-c', NEW_ENOUGH], { encoding: 'utf8' });
  if (version.status !== 0)
    throw new Error(`Python 3.10 or newer is needed (set PYTHON=…): ${version.stdout ?? ''}`.trim());
  const fresh = `${HOME}.${process.pid}`;
  rmSync(fresh, { recursive: true, force: true });
  mkdirSync(join(HOME, '..'), { recursive: true });
  run(system, ['-m', 'venv', '--copies', fresh], 'on Debian: apt-get install -y python3-venv');
  rmSync(HOME, { recursive: true, force: true });
  // Another process may have been faster; its environment is as good.
  if (!existsSync(HOME)) renameSync(fresh, HOME);
  run(python, [...PIP, REDIS], 'is there a network, or a proxy to be set?');
  run(
    python,
    ['-c', `open(${JSON.stringify(join(HOME, 'installed'))}, "w").write(${JSON.stringify(REDIS)})`],
    '',
  );
  return python;
}

const PIP = ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check'];

function readInstalled() {
  const path = join(HOME, 'installed');
  return existsSync(path) ? readFileSync(path, 'utf8') : '';
}

function run(command, args, advice) {
  const { status, stderr } = spawnSync(command, args, { encoding: 'utf8' });
  if (status !== 0) throw new Error(`${command} ${args.join(' ')} failed. ${advice}\n${stderr ?? ''}`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    console.log(servicePython());
  } catch (error) {
    console.error(`set-up: ${error.message}`);
    process.exit(1);
  }
}
