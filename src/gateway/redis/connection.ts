import { createClient as createRedis, type RedisClientType } from 'redis';
import type { GatewayOptions } from '../options';

/** Time to connect, and the first and longest wait before another attempt, wall ms. */
const CONNECT_TIMEOUT = 2000;
const FIRST_DELAY = 50;
const LAST_DELAY = 1000;

/** A Redis client that reconnects automatically and rejects commands while it is disconnected. */
export function connectRedis({ redis: url, log }: Pick<GatewayOptions, 'redis' | 'log'>): RedisClientType {
  const client = createRedis({
    url,
    disableOfflineQueue: true,
    socket: { reconnectStrategy: reconnectDelay, connectTimeout: CONNECT_TIMEOUT },
  });
  client.on('error', (error: Error) => log(`redis: ${error.message === '' ? error.name : error.message}`));
  return client;
}

/** Wait before the next attempt to connect, wall ms: twice as long each time, up to LAST_DELAY. */
export function reconnectDelay(tries: number): number {
  return Math.min(LAST_DELAY, FIRST_DELAY * 2 ** tries);
}

/** Redis clock minus local clock, s; assumes a symmetric round trip. */
export async function measureClock(redis: RedisClientType, now: () => number): Promise<number> {
  const before = now();
  const [seconds, micros] = (await redis.sendCommand(['TIME'])) as unknown as [string, string];
  return Number(seconds) + Number(micros) / 1e6 - (before + now()) / 2;
}
