import { createClient as createRedis, type RedisClientType } from 'redis';
import type { GatewayOptions } from '../options';

/** A Redis client that reconnects automatically and rejects commands while it is disconnected. */
export function connectRedis({ redis: url, log }: Pick<GatewayOptions, 'redis' | 'log'>): RedisClientType {
  const client = createRedis({
    url,
    disableOfflineQueue: true,
    socket: { reconnectStrategy: reconnectDelay, connectTimeout: 2000 },
  });
  client.on('error', (error: Error) => log(`redis: ${error.message === '' ? error.name : error.message}`));
  return client;
}

/** Wait before the next attempt to connect, wall ms: twice as long each time, a second at most. */
export function reconnectDelay(tries: number): number {
  return Math.min(1000, 50 * 2 ** tries);
}

/** Redis clock minus local clock, s; assumes a symmetric round trip. */
export async function measureClock(redis: RedisClientType, now: () => number): Promise<number> {
  const before = now();
  const [seconds, micros] = (await redis.sendCommand(['TIME'])) as unknown as [string, string];
  return Number(seconds) + Number(micros) / 1e6 - (before + now()) / 2;
}
