import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { redisServer, servicePython } from '../../.ci/python.mjs';

/** The live stack's processes, each of which can be killed and started again, as it would be in operation. */
export interface Process {
  readonly start: () => Promise<void>;
  /** Ends it with a signal; resolves when it is gone. */
  readonly end: (signal: NodeJS.Signals) => Promise<void>;
  readonly pid: () => number;
  /** The last it wrote, for whoever wants to know why a test failed. */
  readonly said: () => string;
}

const SAID = 4000;

export interface Program {
  readonly command: string;
  readonly args: readonly string[];
  readonly env?: Record<string, string | undefined>;
  /** It is up when a line of its output has this. */
  readonly upWhen: RegExp;
}

export function createProcess(program: Program): Process {
  let child: ChildProcess | null = null;
  let said = '';
  return {
    pid: () => child?.pid ?? -1,
    said: () => said,
    start() {
      const own = spawn(program.command, program.args, {
        env: program.env,
        stdio: ['ignore', 'pipe', 'pipe'],
      });
      child = own;
      return new Promise((resolve, reject) => {
        const hear = (data: Buffer) => {
          said = (said + data.toString()).slice(-SAID);
          if (program.upWhen.test(said)) resolve();
        };
        own.stdout.on('data', hear);
        own.stderr.on('data', hear);
        own.once('error', reject);
        own.once('exit', (code) =>
          reject(new Error(`${program.command} ended with ${String(code)}: ${said}`)),
        );
        said = '';
      });
    },
    end(signal) {
      const own = child;
      child = null;
      if (own === null || own.exitCode !== null || own.signalCode !== null) return Promise.resolve();
      return new Promise((resolve) => {
        own.once('exit', () => resolve());
        own.kill(signal);
      });
    },
  };
}

/** A port that is free now. */
export function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number };
      server.close(() => resolve(port));
    });
  });
}

export interface Stack {
  readonly redis: Process;
  readonly service: Process;
  readonly gateway: Process;
  readonly redisUrl: string;
  readonly gatewayPort: number;
  readonly stop: () => Promise<void>;
}

export interface StackOptions {
  readonly gatewayEnv: Record<string, string>;
  /** 'always': a tick that was told is on disk; 'no': nothing is kept. */
  readonly appendfsync: 'always' | 'everysec' | 'no';
}

/** Redis, service and gateway on free ports of this machine, none started yet. */
export async function createStack({ gatewayEnv, appendfsync }: StackOptions): Promise<Stack> {
  const [redisPort, gatewayPort] = [await freePort(), await freePort()];
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-live-'));
  const redisUrl = `redis://127.0.0.1:${redisPort}/0`;
  const python = servicePython();
  const redis = createProcess({
    command: redisServer(),
    args: [
      ...['--bind', '127.0.0.1', '--port', String(redisPort), '--dir', folder, '--save', ''],
      ...['--appendonly', appendfsync === 'no' ? 'no' : 'yes', '--appendfsync', appendfsync],
    ],
    upWhen: /Ready to accept connections/,
  });
  const service = createProcess({
    command: python.command,
    args: ['-m', 'touchdown_service', '--redis', redisUrl],
    env: python.env,
    upWhen: /./,
  });
  const gateway = createProcess({
    command: process.execPath,
    args: ['test/run.mjs', 'src/gateway/main.ts'],
    env: {
      ...process.env,
      TOUCHDOWN_REDIS: redisUrl,
      TOUCHDOWN_PORT: String(gatewayPort),
      ...gatewayEnv,
    },
    upWhen: /gateway: listening/,
  });
  return {
    redis,
    service,
    gateway,
    redisUrl,
    gatewayPort,
    async stop() {
      for (const process of [gateway, service, redis]) await process.end('SIGTERM');
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
