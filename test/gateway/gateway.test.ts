/** A running gateway with a real Redis and real sockets; the test writes the world. */
import { EventEmitter } from 'node:events';
import { connect as connectTcp } from 'node:net';
import type { RedisClientType } from 'redis';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { WebSocket } from 'ws';
import { createGateway, type Gateway } from '../../src/gateway/gateway';
import { runProcess } from '../../src/gateway/process';
import { encodeClientMessage, encodeFrameJson, encodeHelloJson } from '../../src/wire';
import { isMissing } from '../service/pythonTests';
import { HELLO } from '../wire/messages';
import { shipOf, worldOf } from './fakeGateway';
import { connectClient } from './gatewayClient';
import { startRedis } from './redisServer';

const ACCOUNT = { username: 'one', playerId: 'p1', password: 'x' };

describe.skipIf(isMissing('redis'))('a gateway', () => {
  const logged: string[] = [];
  let redis: RedisClientType;
  let gateway: Gateway;
  let closing: Promise<void> | undefined;
  let url: string;
  let end: () => Promise<void>;

  beforeAll(async () => {
    ({ url, redis, end } = await startRedis());
  });
  afterAll(() => end());
  beforeEach(async () => {
    await redis.flushAll();
    logged.length = 0;
    closing = undefined;
    gateway = await createGateway(options());
  });
  const options = () => ({
    redis: url,
    host: '127.0.0.1',
    port: 0,
    accounts: [ACCOUNT],
    secret: 'a secret that is long enough for a test',
    tokenLifetime: 60,
    origins: ['https://page.example'],
    clock: () => Date.now() / 1000,
    nonce: () => 'nonce',
    log: (line: string) => void logged.push(line),
  });
  const close = () => (closing ??= gateway.close());
  afterEach(close);

  async function writeFrame(tick: number): Promise<void> {
    const frame = encodeFrameJson(worldOf([shipOf('p1')], { tick }).frame);
    await redis.xAdd('touchdown:frames', '*', {
      frame: JSON.stringify({ ...frame, due: Date.now() / 1000 }),
    });
  }

  const connect = (path = '/ws', origin?: string) => connectClient(gateway.port, path, origin);

  async function login(): Promise<Record<string, unknown>> {
    const body = JSON.stringify({ username: 'one', password: 'x' });
    const address = `http://127.0.0.1:${gateway.port}/api/auth/login`;
    return (await (await fetch(address, { method: 'POST', body })).json()) as Record<string, unknown>;
  }

  async function signedIn(path?: string) {
    const client = connect(path);
    await client.opened;
    client.socket.send(JSON.stringify({ type: 'auth', token: (await login())['token'] }));
    return client;
  }

  it('signs a player in, sends it the world, and forwards its controls', async () => {
    const client = await signedIn();
    client.socket.send(JSON.stringify({ type: 'ping' }));
    await expect.poll(client.kinds).toEqual(['pong']);
    // The world may be defined after the gateway has started.
    await redis.set('touchdown:world', JSON.stringify(encodeHelloJson(HELLO)));
    await expect
      .poll(async () => {
        await writeFrame(7);
        return client.kinds().slice(1, 3);
      })
      .toEqual(['welcome', 'state']);
    expect(client.received[1]).toMatchObject({ username: 'one', ship_id: 'ship of p1' });
    expect(await login()).toMatchObject({ player_id: 'p1', ship_id: 'ship of p1' });
    client.socket.send(JSON.stringify({ type: 'control', thrust_level: 0.5 }));
    await expect.poll(() => redis.xLen('touchdown:inbox')).toBe(1);
    const entries = await redis.xRange('touchdown:inbox', '-', '+');
    expect(entries?.[0]?.message).toMatchObject({
      ship_id: 'ship of p1',
      player_id: 'p1',
      session: 'nonce',
      seq: '1',
    });
    expect(gateway.health()).toEqual({
      tick: 7,
      ships: 1,
      clients: 1,
      redis: true,
      inbox: { waiting: 0, dropped: 0 },
      refused: 0,
    });
    client.socket.close();
    await expect.poll(() => gateway.health()['clients']).toBe(0);
    expect(logged).toEqual([]);
  });

  it('sends a client whose socket was full the newest state as soon as it has room', async () => {
    await redis.set('touchdown:world', JSON.stringify(encodeHelloJson(HELLO)));
    const client = await signedIn();
    // Until the gateway has read the world's definition, a frame is not sent.
    await expect.poll(() => writeFrame(7).then(client.kinds)).toContain('welcome');
    const buffered = vi.spyOn(WebSocket.prototype, 'bufferedAmount', 'get').mockReturnValue(2 ** 30);
    onTestFinished(() => buffered.mockRestore());
    await writeFrame(8);
    await expect.poll(() => gateway.health()['tick']).toBe(8);
    expect(client.received).not.toContainEqual(expect.objectContaining({ tick: 8 }));
    buffered.mockReturnValue(0);
    await expect.poll(() => client.received).toContainEqual(expect.objectContaining({ tick: 8 }));
  });

  it('answers a ping on /stream by the time since the newest tick was due, on Redis’s clock', async () => {
    await writeFrame(7);
    await expect.poll(() => gateway.health()['tick']).toBe(7);
    const client = await signedIn('/stream');
    client.socket.send(encodeClientMessage({ kind: 'ping', id: 3 }));
    await expect.poll(() => client.received).toMatchObject([{ value: { kind: 'pong', id: 3, tick: 7 } }]);
    // Both run on this machine's clock: another one is off by decades.
    const { sinceTick } = client.received[0]!['value'] as { sinceTick: number };
    expect(Math.abs(sinceTick)).toBeLessThan(3600);
  });

  it('counts and logs invalid frames and an invalid world definition', async () => {
    await redis.set('touchdown:world', JSON.stringify({ ...encodeHelloJson(HELLO), bodies: 5 }));
    await redis.xAdd('touchdown:frames', '*', { frame: '{' });
    await expect.poll(() => gateway.health()['refused']).toBe(1);
    await expect.poll(() => logged).toContain('frame: not JSON');
    await expect.poll(() => logged.join()).toMatch(/touchdown:world: .*bodies/);
    expect(gateway.health()).toMatchObject({ tick: null, ships: 0 });
  });

  it('names a key of another type in one line, keeps the last world, and continues once it is fixed', async () => {
    await redis.set('touchdown:world', JSON.stringify(encodeHelloJson(HELLO)));
    const client = await signedIn();
    await writeFrame(7);
    await expect.poll(() => gateway.health()['tick']).toBe(7);
    for (const key of ['touchdown:frames', 'touchdown:inbox']) {
      await redis.del(key);
      await redis.set(key, 'x');
    }
    await expect.poll(() => logged).toContain('touchdown:frames: expected a stream');
    client.socket.send(JSON.stringify({ type: 'control', thrust_level: 0.5 }));
    await expect.poll(() => logged).toContain('touchdown:inbox: expected a stream');
    expect(gateway.health()).toMatchObject({ tick: 7, ships: 1, clients: 1 });
    await redis.del(['touchdown:frames', 'touchdown:inbox']);
    // The gap in ticks makes the gateway read the events between them.
    await redis.lPush('touchdown:events', 'x');
    await writeFrame(9);
    await expect.poll(() => gateway.health()['tick']).toBe(9);
    await expect.poll(() => redis.xLen('touchdown:inbox')).toBe(1);
    expect(logged.toSorted()).toEqual(
      ['events', 'frames', 'inbox'].map((name) => `touchdown:${name}: expected a stream`),
    );
  });

  it.each([
    ['of another type', () => redis.lPush('touchdown:world', 'x'), 'touchdown:world: expected a string'],
    ['no JSON', () => redis.set('touchdown:world', '{'), 'touchdown:world: not JSON'],
    ['bytes', () => redis.set('touchdown:world', Buffer.from([0xff])), 'touchdown:world: not JSON'],
    ['no world', () => redis.set('touchdown:world', '5'), /^touchdown:world: message: expected/],
  ])('names a world definition that is %s in one line, and starts with it', async (_, spoil, line) => {
    await close();
    await spoil();
    gateway = await createGateway(options());
    closing = undefined;
    await expect.poll(() => logged).toEqual([expect.stringMatching(line)]);
    await redis.del('touchdown:world');
    await redis.set('touchdown:world', JSON.stringify(encodeHelloJson(HELLO)));
    const client = await signedIn();
    await expect
      .poll(async () => {
        await writeFrame(7);
        return client.kinds();
      })
      .toContain('welcome');
    expect(logged).toHaveLength(1);
  });

  it.each([
    ['https://page.example', 'open'],
    ['http://localhost:5173', 'open'],
    ['https://127.0.0.1', 'open'],
    ['http://[::1]:80', 'open'],
    ['https://other.example', 'closed'],
    ['https://localhost.other.example', 'closed'],
    ['null', 'closed'],
  ])('keeps a connection from origin %s %s', async (origin, outcome) => {
    const client = connect('/stream', origin);
    await client.opened;
    if (outcome === 'closed') expect(await client.closed).toEqual([4003, 'Origin not allowed']);
    else {
      await expect.poll(() => gateway.health()['clients']).toBe(1);
      client.socket.close();
    }
  });

  it('accepts WebSockets on /ws and /stream only', async () => {
    expect(await connect('/').failed).toMatch(/404/);
    const client = connect('/stream?x=1');
    await client.opened;
    client.socket.close();
  });

  it.each(['SIGTERM', 'SIGINT'])(
    'runs as a process: prints its address, and ends with 0 at %s',
    async (signal) => {
      const env = { TOUCHDOWN_REDIS: url, TOUCHDOWN_PORT: '0', TOUCHDOWN_SECRET: options().secret };
      const [log, error, exit] = [vi.fn(), vi.fn(), vi.fn()];
      const host = Object.assign(new EventEmitter(), { env, exit });
      await runProcess(host as never, { log, error }, options());
      const [line] = log.mock.calls[0] as [string];
      const address = /^gateway: listening on (http:\/\/127\.0\.0\.1:\d+)$/.exec(line)![1]!;
      expect(await (await fetch(`${address}/healthz`)).json()).toMatchObject({ clients: 0, redis: true });
      host.emit(signal);
      await expect.poll(() => exit.mock.calls).toEqual([[0]]);
      await expect(fetch(`${address}/healthz`)).rejects.toThrow();
      expect(error).not.toHaveBeenCalled();
    },
  );

  it('accepts at most 64 connections from one address, and closes them with 1001 when it stops', async () => {
    const clients = Array.from({ length: 64 }, () => connect());
    await Promise.all(clients.map(({ opened }) => opened));
    expect(await connect().closed).toEqual([1013, 'Too many connections']);
    expect(gateway.health()['clients']).toBe(64);
    await close();
    for (const { closed } of clients) expect(await closed).toEqual([1001, 'The gateway is restarting']);
    await expect(fetch(`http://127.0.0.1:${gateway.port}/healthz`)).rejects.toThrow();
  });

  it('stops without waiting for a request whose end never comes', async () => {
    const host = `127.0.0.1:${gateway.port}`;
    const half = connectTcp(gateway.port, '127.0.0.1');
    half.write(`GET /healthz HTTP/1.1\r\nHost: ${host}\r\n`);
    expect((await fetch(`http://${host}/healthz`)).ok).toBe(true);
    await Promise.all([close(), new Promise((resolve) => half.on('close', resolve))]);
  });
});
