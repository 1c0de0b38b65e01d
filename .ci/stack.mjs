// The live stack's processes: each can be killed and restarted, as in operation.
import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { openDataFolder } from './dataFolder.mjs';
import { freePort } from './ports.mjs';
import { redisServer, servicePython } from './python.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
/** Characters kept of a process's output. */
const OUTPUT_KEPT = 4000;
/** ms for a process to end after SIGTERM or SIGINT; then it is killed. */
const END_WITHIN = 5000;

/**
 * A process, not started yet. It is up when its output contains `upWhen`.
 * It has its own process group: Ctrl-C reaches it only through us, in the right order.
 */
export function createProcess({ name, command, args, env, upWhen }) {
  let child = null;
  let said = '';
  let onDeath = () => undefined;
  return {
    name,
    pid: () => child?.pid ?? -1,
    said: () => said,
    whenItDies: (act) => (onDeath = act),
    start() {
      const own = spawn(command, args, { env, cwd: root, stdio: ['ignore', 'pipe', 'pipe'], detached: true });
      child = own;
      said = '';
      return new Promise((resolve, reject) => {
        const hear = (data) => {
          said = (said + data.toString()).slice(-OUTPUT_KEPT);
          if (upWhen.test(said)) resolve();
        };
        own.stdout.on('data', hear);
        own.stderr.on('data', hear);
        own.once('error', reject);
        own.once('exit', (code, signal) => {
          reject(new Error(`${name} ended with ${signal ?? code}: ${said.trim()}`));
          if (child === own) {
            child = null;
            onDeath(signal ?? code);
          }
        });
      });
    },
    end(signal) {
      const own = child;
      child = null;
      if (own === null || own.exitCode !== null || own.signalCode !== null) return Promise.resolve();
      return new Promise((resolve) => {
        const kill = setTimeout(() => own.kill('SIGKILL'), END_WITHIN);
        own.once('exit', () => {
          clearTimeout(kill);
          resolve();
        });
        own.kill(signal);
      });
    },
  };
}

/**
 * Redis, service and gateway on this machine, none started yet. Throws an Error that names what to install.
 * `appendfsync`: always, everysec, or no (nothing is kept). `ports`: of redis and gateway; free ones by default.
 * `data`: the folder for Redis's files; a temporary one by default. `serviceArgs`: further arguments of the service.
 */
export async function createStack({ gatewayEnv, appendfsync, ports = {}, data, serviceArgs = [] }) {
  const [redisCommand, python] = [redisServer(), servicePython()];
  const [redisPort, gatewayPort] = [ports.redis ?? (await freePort()), ports.gateway ?? (await freePort())];
  const folder = openDataFolder(data);
  const redisUrl = `redis://127.0.0.1:${redisPort}/0`;
  const redis = createProcess({
    name: 'redis',
    command: redisCommand,
    args: [
      ...[
        '--bind',
        '127.0.0.1',
        '--port',
        String(redisPort),
        '--dir',
        folder.path,
        '--save',
        '',
        '--pidfile',
        folder.pidFile,
      ],
      ...(appendfsync === 'no' ? [] : ['--appendonly', 'yes', '--appendfsync', appendfsync]),
    ],
    env: process.env,
    upWhen: /Ready to accept connections/,
  });
  const service = createProcess({
    name: 'service',
    command: python.command,
    args: ['-m', 'touchdown_service', '--redis', redisUrl, ...serviceArgs],
    env: python.env,
    upWhen: / INFO tick /,
  });
  const gateway = createProcess({
    name: 'gateway',
    command: process.execPath,
    args: ['test/run.mjs', 'src/gateway/main.ts'],
    env: { ...process.env, TOUCHDOWN_REDIS: redisUrl, TOUCHDOWN_PORT: String(gatewayPort), ...gatewayEnv },
    upWhen: /gateway: listening/,
  });
  return {
    redis,
    service,
    gateway,
    redisUrl,
    gatewayPort,
    folder,
    async stop() {
      for (const one of [gateway, service, redis]) await one.end('SIGTERM');
      folder.close();
    },
  };
}
