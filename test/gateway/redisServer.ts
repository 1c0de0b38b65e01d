import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createClient, type RedisClientType } from 'redis';
import { redisServer } from '../../.ci/python.mjs';
import { freePort } from '../../.ci/ports.mjs';
import { createProcess } from '../../.ci/stack.mjs';

/** Starts a Redis without persistence: its URL, a connection to it, and what ends both. */
export async function startRedis() {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-gateway-'));
  const port = await freePort();
  const server = createProcess({
    name: 'redis',
    command: redisServer(),
    args: ['--bind', '127.0.0.1', '--port', String(port), '--dir', folder, '--save', ''],
    env: process.env,
    upWhen: /Ready to accept connections/,
  });
  await server.start();
  const url = `redis://127.0.0.1:${port}/0`;
  const redis: RedisClientType = createClient({ url });
  await redis.connect();
  async function end(): Promise<void> {
    redis.destroy();
    await server.end('SIGTERM');
    rmSync(folder, { recursive: true });
  }
  return { url, redis, end };
}
