import { createClient } from 'redis';
import { createStack, type Stack } from '../../.ci/stack.mjs';

/** A running stack, and its operator's commands. */
export interface Operator {
  readonly stack: Stack;
  /** Signs a pilot in. Returns the pilot's address on /stream or /ws, through another port where one is given. */
  readonly addressOf: (pilot: string, path: 'ws' | 'stream', port?: number) => Promise<string>;
  readonly tokenOf: (pilot: string) => Promise<string>;
  readonly set: (key: string, value: string) => Promise<void>;
  /** Respawns a pilot's ship over the landing site, `height` m up and falling at `speed` m/s. */
  readonly drop: (pilot: string, height: number, speed: number) => Promise<void>;
  /** All events of a ship in touchdown:events, in order. */
  readonly eventsOf: (shipId: string) => Promise<readonly ShipEvent[]>;
  /** The newest frame in Redis; tick -1 without ships where there is none. */
  readonly frame: () => Promise<RedisFrame>;
  readonly stop: () => Promise<void>;
}

export interface ShipEvent {
  readonly event: string;
  readonly tick: number;
  readonly substep: number;
}

export interface RedisFrame {
  readonly tick: number;
  readonly ships: readonly Readonly<Record<string, unknown>>[];
}

export const SECRET = 'a secret that is long enough for a test';
const PASSWORD = 'correct horse battery staple';
const PLACES: Readonly<Record<string, number>> = { one: 0, two: 60, three: 120 };
/** LANDING_SITE of hillsTerrain, body axes. */
const SITE = [0.6, 0.48, 0.64] as const;
const MOON_RADIUS = 1737400;

function connectTo(url: string) {
  return createClient({ url, socket: { reconnectStrategy: () => 100 } });
}

export async function startOperator(
  appendfsync: 'always' | 'no',
  serviceArgs: readonly string[] = [],
): Promise<Operator> {
  const accounts = Object.keys(PLACES).map((username) => ({
    username,
    playerId: `pilot-${username}`,
    password: PASSWORD,
  }));
  const gatewayEnv = {
    TOUCHDOWN_SECRET: SECRET,
    TOUCHDOWN_ACCOUNTS: JSON.stringify(accounts),
  };
  const stack = await createStack({ gatewayEnv, appendfsync, serviceArgs });
  for (const one of [stack.redis, stack.service, stack.gateway]) await one.start();

  /** Uses its own connection: Redis may have been restarted since the last request. */
  async function ask<T>(question: (redis: ReturnType<typeof connectTo>) => Promise<T>): Promise<T> {
    const redis = connectTo(stack.redisUrl);
    redis.on('error', () => undefined);
    await redis.connect();
    try {
      return await question(redis);
    } finally {
      redis.destroy();
    }
  }

  async function tokenOf(username: string): Promise<string> {
    const response = await fetch(`http://127.0.0.1:${stack.gatewayPort}/api/auth/login`, {
      method: 'POST',
      body: JSON.stringify({ username, password: PASSWORD }),
    });
    return ((await response.json()) as { token: string }).token;
  }

  return {
    stack,
    tokenOf,
    async addressOf(pilot, path, port = stack.gatewayPort) {
      return `ws://127.0.0.1:${port}/${path}?token=${await tokenOf(pilot)}`;
    },
    async set(key, value) {
      await ask((redis) => redis.set(key, value));
    },
    async drop(pilot, height, speed) {
      const east = PLACES[pilot]! / MOON_RADIUS / Math.hypot(SITE[0], SITE[2]);
      const data = {
        ship_id: `ship-${pilot}`,
        player_id: `pilot-${pilot}`,
        name: pilot,
        ship_class: 'planetary_lander',
        body: 'Luna',
        direction: [SITE[0] + SITE[2] * east, SITE[1], SITE[2] - SITE[0] * east],
        height,
        velocity: [0, 0, -speed],
      };
      await ask((redis) =>
        redis.xAdd('touchdown:inbox', '*', { type: 'respawn', data: JSON.stringify(data) }),
      );
    },
    async eventsOf(shipId) {
      const entries = await ask((redis) => redis.xRange('touchdown:events', '-', '+'));
      return (entries ?? [])
        .map(({ message }) => message)
        .filter((message) => message['ship_id'] === shipId)
        .map((message) => ({
          event: message['event']!,
          tick: Number(message['tick']),
          substep: Number(message['substep']),
        }));
    },
    async frame() {
      const entries = await ask((redis) => redis.xRevRange('touchdown:frames', '+', '-', { COUNT: 1 }));
      return JSON.parse(entries?.[0]?.message['frame'] ?? '{"tick":-1,"ships":[]}') as RedisFrame;
    },
    stop: stack.stop,
  };
}
