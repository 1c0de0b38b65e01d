import { createServer, type IncomingMessage, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { type WebSocket, WebSocketServer } from 'ws';
import { createAccounts } from './accounts';
import { type Client, createClient, disconnect, isFull } from './clients/client';
import { connectRedis, measureClock } from './redis/connection';
import { createFeed, type Feed } from './redis/feed';
import { createHttpHandler } from './http';
import { createInbox } from './redis/inbox';
import { createWorldReader } from './redis/world';
import { AUTH_TIMEOUT, CLOSE, MAX_CLIENT_MESSAGE, MAX_CONNECTIONS, REQUEST_TIMEOUT } from './clients/limits';
import type { GatewayOptions } from './options';
import { type GatewayState, shipOf } from './state';
import { receive, receivePing } from './clients/receive';
import { broadcastFrame, resendToSlow } from './clients/send';

export interface Gateway {
  readonly port: number;
  readonly health: () => Readonly<Record<string, unknown>>;
  /** Closes all connections with 1001, so that clients reconnect, then stops. */
  readonly close: () => Promise<void>;
}

/** Interval of resending to slow clients, flushing the inbox and reading a missing world definition, wall ms. */
const PUMP_INTERVAL = 100;

/** Starts a gateway. Rejects if it cannot listen or cannot reach Redis. */
export async function createGateway(options: GatewayOptions): Promise<Gateway> {
  const [redis, reader] = [connectRedis(options), connectRedis(options)];
  await Promise.all([redis.connect(), reader.connect()]);
  const { secret, tokenLifetime: lifetime, clock: now } = options;
  const gateway: GatewayState = {
    options,
    accounts: await createAccounts(options.accounts, { secret, lifetime, now }),
    redis,
    inbox: createInbox(redis, options.log),
    clients: new Set(),
    feed: null as unknown as Feed,
    world: null,
    clockOffset: await measureClock(redis, now),
    refused: 0,
  };
  gateway.feed = createFeed(reader, redis, {
    onFrame: (world) => broadcastFrame(gateway, world),
    onRefused(reason, isNew) {
      gateway.refused += 1;
      if (isNew) options.log(reason);
    },
  });
  redis.on('ready', () => gateway.inbox.flush());
  const readWorld = createWorldReader(redis, options.log);
  gateway.world = await readWorld();
  const reading = gateway.feed.run();
  const pump = setInterval(() => {
    resendToSlow(gateway);
    gateway.inbox.flush();
    if (gateway.world !== null) return;
    readWorld().then(
      (world) => {
        gateway.world = world;
      },
      // Redis is unavailable: the next interval tries again.
      () => undefined,
    );
  }, PUMP_INTERVAL);
  const server = await listen(gateway);
  return {
    port: (server.address() as AddressInfo).port,
    health: () => healthOf(gateway),
    async close() {
      clearInterval(pump);
      gateway.feed.stop();
      for (const client of gateway.clients) disconnect(client, CLOSE.goingAway, 'The gateway is restarting');
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

async function listen(gateway: GatewayState): Promise<Server> {
  const { options, accounts } = gateway;
  const server = createServer(
    createHttpHandler({
      accounts,
      isAllowedOrigin: (origin) => isAllowedOrigin(options.origins, origin),
      shipOf: (playerId) => shipOf(gateway, playerId),
      health: () => healthOf(gateway),
      now: options.clock,
    }),
  );
  const sockets = new WebSocketServer({
    noServer: true,
    maxPayload: MAX_CLIENT_MESSAGE,
    // Pings count against the message rate, so receivePing answers them.
    autoPong: false,
    perMessageDeflate: false,
  });
  server.headersTimeout = server.requestTimeout = REQUEST_TIMEOUT * 1000;
  server.maxConnections = MAX_CONNECTIONS;
  server.on('upgrade', (request, socket, head) => {
    // After 'upgrade' node removes its own error listener; an unhandled error would end the process.
    socket.on('error', () => socket.destroy());
    const path = (request.url ?? '').split('?')[0];
    if (path !== '/ws' && path !== '/stream') {
      socket.end('HTTP/1.1 404 Not Found\r\n\r\n');
      return;
    }
    sockets.handleUpgrade(request, socket, head, (opened) =>
      acceptSocket(gateway, opened, request, path === '/ws' ? 'json' : 'stream'),
    );
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(options.port, options.host, resolve);
  });
  return server;
}

/**
 * Registers an open socket that has not signed in. Refusals come after the upgrade, since a browser reports a close code but not
 * the HTTP status of a refused upgrade.
 */
function acceptSocket(
  gateway: GatewayState,
  socket: WebSocket,
  request: IncomingMessage,
  protocol: Client['protocol'],
): void {
  const { clients, options } = gateway;
  const address = request.socket.remoteAddress ?? '';
  const client = createClient(socket, protocol, address, options.clock());
  socket.on('error', () => undefined);
  if (!isAllowedOrigin(options.origins, request.headers.origin)) {
    disconnect(client, CLOSE.origin, 'Origin not allowed');
    return;
  }
  if (isFull([...clients], address)) {
    disconnect(client, CLOSE.tryLater, 'Too many connections');
    return;
  }
  clients.add(client);
  client.timers.add(
    setTimeout(() => disconnect(client, CLOSE.auth, 'No sign-in within 5 s'), AUTH_TIMEOUT * 1000),
  );
  socket.on('message', (data: Buffer, isBinary) => receive(gateway, client, data, isBinary));
  socket.on('ping', (data: Buffer) => receivePing(gateway, client, data));
  socket.on('close', () => {
    clients.delete(client);
    for (const timer of client.timers) clearTimeout(timer);
  });
}

function isAllowedOrigin(origins: readonly string[], origin: string | undefined): boolean {
  if (origin === undefined || origins.includes(origin)) return true;
  return /^https?:\/\/(localhost|127\.0\.0\.1|\[::1\])(:\d+)?$/.test(origin);
}

function healthOf({ feed, clients, inbox, refused, redis }: GatewayState): Readonly<Record<string, unknown>> {
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
