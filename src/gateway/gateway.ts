import { createServer, type IncomingMessage, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { createClient as createRedis, type RedisClientType } from 'redis';
import { type WebSocket, WebSocketServer } from 'ws';
import { decodeHelloJson } from '../wire';
import { createAccounts } from './accounts';
import { type Client, createClient, dismiss } from './clients/client';
import { createFeed, type Feed } from './redis/feed';
import { createHttpHandler } from './http';
import { createInbox } from './redis/inbox';
import {
  AUTH_WITHIN,
  CLOSE,
  MAX_CLIENT_MESSAGE,
  MAX_CONNECTIONS,
  MAX_FROM_ADDRESS,
  MAX_UNSIGNED,
  REQUEST_WITHIN,
} from './clients/limits';
import type { GatewayOptions } from './options';
import { type Place, shipOf } from './place';
import { receive, receivePing } from './clients/receive';
import { tellAll, tellBehind } from './clients/tell';

export interface Gateway {
  readonly port: number;
  readonly health: () => Readonly<Record<string, unknown>>;
  /** Tells clients to come back, and ends. */
  readonly close: () => Promise<void>;
}

/** Wall ms between two looks at slow clients and at the world's definition. */
const PUMP = 100;
const WORLD = 'touchdown:world';

/** Starts a gateway. Rejects when it cannot listen or Redis has never answered. */
export async function createGateway(options: GatewayOptions): Promise<Gateway> {
  const [redis, reader] = [connectRedis(options), connectRedis(options)];
  await Promise.all([redis.connect(), reader.connect()]);
  const { secret, tokenLifetime: lifetime, clock: now } = options;
  const place: Place = {
    options,
    accounts: await createAccounts(options.accounts, { secret, lifetime, now }),
    redis,
    inbox: createInbox(redis),
    clients: new Set(),
    feed: null as unknown as Feed,
    world: null,
    clockOffset: await measureClock(redis, now),
    refused: 0,
  };
  place.feed = createFeed(reader, redis, {
    onFrame: (world) => tellAll(place, world),
    onRefused(reason) {
      place.refused += 1;
      options.log(reason);
    },
  });
  redis.on('ready', () => place.inbox.flush());
  await readWorld(place);
  const reading = place.feed.run();
  const pump = setInterval(() => {
    tellBehind(place);
    place.inbox.flush();
    if (place.world === null) readWorld(place).catch(() => undefined);
  }, PUMP);
  const server = await listen(place);
  return {
    port: (server.address() as AddressInfo).port,
    health: () => healthOf(place),
    async close() {
      clearInterval(pump);
      place.feed.stop();
      for (const client of place.clients) dismiss(client, CLOSE.goingAway, 'The gateway is restarting');
      reader.destroy();
      await reading;
      await new Promise((resolve) => {
        server.close(resolve);
        server.closeAllConnections();
      });
      if (redis.isReady) await redis.close();
      else redis.destroy();
    },
  };
}

/** A connection that reconnects by itself, with a bounded queue. */
function connectRedis({ redis: url, log }: GatewayOptions): RedisClientType {
  const client = createRedis({
    url,
    disableOfflineQueue: true,
    socket: { reconnectStrategy: (tries) => Math.min(1000, 50 * 2 ** tries), connectTimeout: 2000 },
  });
  client.on('error', (error: Error) => log(`redis: ${error.message === '' ? error.name : error.message}`));
  return client;
}

/** By half the round trip of one request. */
async function measureClock(redis: RedisClientType, now: () => number): Promise<number> {
  const before = now();
  const [seconds, micros] = (await redis.sendCommand(['TIME'])) as unknown as [string, string];
  return Number(seconds) + Number(micros) / 1e6 - (before + now()) / 2;
}

async function readWorld(place: Place): Promise<void> {
  const text = await place.redis.get(WORLD);
  if (text === null) return;
  const hello = decodeHelloJson(JSON.parse(text));
  if (!hello.ok) {
    place.options.log(`world.${hello.reason}`);
    return;
  }
  const { refusals, ...world } = hello.value;
  for (const refusal of refusals) place.options.log(`world.${refusal}`);
  place.world = world;
}

async function listen(place: Place): Promise<Server> {
  const { options, accounts } = place;
  const server = createServer(
    createHttpHandler({
      accounts,
      isAllowedOrigin: (origin) => isAllowedOrigin(options.origins, origin),
      shipOf: (playerId) => shipOf(place, playerId),
      health: () => healthOf(place),
      now: options.clock,
    }),
  );
  const sockets = new WebSocketServer({
    noServer: true,
    maxPayload: MAX_CLIENT_MESSAGE,
    // Pings are messages too: answered by themselves they would have no limit.
    autoPong: false,
    perMessageDeflate: false,
  });
  server.headersTimeout = server.requestTimeout = REQUEST_WITHIN * 1000;
  server.maxConnections = MAX_CONNECTIONS;
  server.on('upgrade', (request, socket, head) => {
    // node no longer listens to its errors here, and an error that nobody listens to ends the process.
    socket.on('error', () => socket.destroy());
    const path = (request.url ?? '').split('?')[0];
    if (path !== '/ws' && path !== '/stream') {
      socket.end('HTTP/1.1 404 Not Found\r\n\r\n');
      return;
    }
    sockets.handleUpgrade(request, socket, head, (opened) =>
      welcomeSocket(place, opened, request, path === '/ws' ? 'json' : 'stream'),
    );
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(options.port, options.host, resolve);
  });
  return server;
}

/** A connection stands; it has not signed in. A browser shows the code of a close, not the status of a refused upgrade. */
function welcomeSocket(
  place: Place,
  socket: WebSocket,
  request: IncomingMessage,
  protocol: Client['protocol'],
): void {
  const { clients, options } = place;
  const address = request.socket.remoteAddress ?? '';
  const client = createClient(socket, protocol, address, options.clock());
  socket.on('error', () => undefined);
  if (!isAllowedOrigin(options.origins, request.headers.origin)) {
    dismiss(client, CLOSE.origin, 'Origin not allowed');
    return;
  }
  const ofAddress = [...clients].filter((other) => other.address === address).length;
  const unsigned = [...clients].filter((other) => other.player === null).length;
  if (ofAddress >= MAX_FROM_ADDRESS || unsigned >= MAX_UNSIGNED) {
    dismiss(client, CLOSE.tryLater, 'Too many connections');
    return;
  }
  clients.add(client);
  client.timers.add(
    setTimeout(() => dismiss(client, CLOSE.auth, 'No sign-in within 5 s'), AUTH_WITHIN * 1000),
  );
  socket.on('message', (data: Buffer, isBinary) => receive(place, client, data, isBinary));
  socket.on('ping', (data: Buffer) => receivePing(place, client, data));
  socket.on('close', () => {
    clients.delete(client);
    for (const timer of client.timers) clearTimeout(timer);
  });
}

function isAllowedOrigin(origins: readonly string[], origin: string | undefined): boolean {
  if (origin === undefined || origins.includes(origin)) return true;
  return /^https?:\/\/(localhost|127\.0\.0\.1|\[::1\])(:\d+)?$/.test(origin);
}

function healthOf({ feed, clients, inbox, refused, redis }: Place): Readonly<Record<string, unknown>> {
  const newest = feed.newest();
  return {
    tick: newest?.frame.tick ?? null,
    ships: newest?.frame.ships.length ?? 0,
    clients: clients.size,
    redis: redis.isReady,
    inbox: inbox.counts(),
    refused,
  };
}
