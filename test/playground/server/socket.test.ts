import type { AddressInfo } from 'node:net';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { WebSocket, WebSocketServer } from 'ws';
import type { Connection, ConnectionHandlers } from '../../../src/playground/server/connection';
import { openServer } from '../../../src/playground/server/realServer';
import type { PartialFrame, ServerMessage } from '../../../src/wire';
import { input } from '../../authority/moon';
import { type SocketServer, startSocketServer } from './socketServer';

/** Like a browser's: an error only closes it, and is not thrown without a listener. */
class PageSocket extends WebSocket {
  constructor(address: string) {
    super(address);
    this.on('error', () => undefined);
  }
}

/** What was reported, and a way to wait for it. */
function ear() {
  const messages: (ServerMessage | PartialFrame)[] = [];
  const told: string[] = [];
  const waiting = new Set<() => void>();
  const notice = <T>(act: (value: T) => void) => {
    return (value: T) => {
      act(value);
      for (const check of waiting) check();
    };
  };
  const handlers: ConnectionHandlers = {
    onOpen: notice((what) => told.push(`open ${what}`)),
    onPending: notice((message) => {
      const decoded = message.decode();
      if (decoded.ok) messages.push(decoded.value);
      else told.push(`unusable ${decoded.reason}`);
    }),
    onFrame: notice((frame) => messages.push(frame)),
    onLink: notice((words) => told.push(`link ${words}`)),
    onWelcome: notice((about) => told.push(`welcome ${String(about['ship_id'])}`)),
    onShipGone: notice((shipId) => told.push(`gone ${shipId}`)),
    onClosed: notice((reason) => told.push(`closed ${reason}`)),
    onRefused: notice((reason) => told.push(`refused ${reason}`)),
    onRun: notice(() => told.push('run')),
  };
  const until = (met: () => boolean) =>
    new Promise<void>((resolve) => {
      const check = () => {
        if (!met()) return;
        waiting.delete(check);
        resolve();
      };
      waiting.add(check);
      check();
    });
  return { handlers, messages, told, until };
}

describe('a real server', () => {
  let server: SocketServer;
  let connection: Connection | null = null;

  beforeEach(async () => {
    vi.stubGlobal('WebSocket', PageSocket);
    server = await startSocketServer('launch', { tickRate: 50 });
  });
  afterEach(async () => {
    connection?.dispose();
    await server.close();
    vi.unstubAllGlobals();
  });

  it('sends its hello and frames, answers pings and applies inputs', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openServer(server.address, handlers);
    await until(() => messages.length >= 3);
    expect(told).toEqual([
      `link Connecting to ${server.address}…`,
      `link Connected to ${server.address}; signing in…`,
      'link ',
      'open world',
    ]);
    expect(messages[0]).toMatchObject({ kind: 'hello', shipId: 'ship-1', tickRate: 50 });
    connection.send({ kind: 'ping', id: 77 });
    await until(() => messages.some(({ kind }) => kind === 'pong'));
    const tick = server.authority.tickNumber();
    connection.send({ kind: 'inputs', inputs: [input(1, tick + 5, 1, { thrustLevel: 1 })] });
    const flying = (message: ServerMessage | PartialFrame) =>
      message.kind === 'frame' && message.ships[0]!.surfaceContactState === '';
    await until(() => messages.some(flying));
    expect(messages.find(flying)).toMatchObject({ lastInput: { seq: 1 } });
  });

  it('that closes the connection is reported and reconnected to, with at most one socket', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openServer(server.address, handlers);
    await until(() => messages.length > 0);
    for (let i = 0; i < 3; i++) connection.reconnect();
    server.hangUp();
    await until(() => told.some((text) => text.includes('was lost')));
    expect(told.at(-1)).toMatch(/^link The connection to \S+ was lost \(code 1006\)\. Retrying in [12] s\.$/);
    connection.send({ kind: 'ping', id: 1 });
    for (let i = 0; i < 3; i++) connection.reconnect();
    await until(() => told.includes('open again'));
    expect(told).toContain(`link Connected to ${server.address} again.`);
    await until(() => told.at(-1) === 'link ');
    expect(server.connections()).toEqual({ open: 1, ever: 2 });
  });

  it('that sends text is refused by name', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openServer(server.address, handlers);
    await until(() => messages.length > 0);
    server.say('hello');
    await until(() => told.some((text) => text.startsWith('refused')));
    expect(told.at(-1)).toContain(`refused ${server.address} sent text`);
  });

  it('counts the seconds to the next attempt', async () => {
    const { handlers, told, until } = ear();
    const address = server.address;
    await server.close();
    connection = openServer(address, handlers);
    // The second wait has 1.5 s at least.
    const counted = (seconds: number) =>
      told.filter((text) => text.endsWith(`Retrying in ${seconds} s.`)).length;
    await until(() => counted(2) > 0 && counted(1) > 1);
    connection.dispose();
    expect(told.at(-1)).toBe('link Disconnected.');
    const reports = told.length;
    await new Promise((resolve) => setTimeout(resolve, 1200));
    expect(told).toHaveLength(reports);
  });

  it('that is absent, or whose address is invalid, is reported as not answering', async () => {
    const { handlers, told, until } = ear();
    const address = server.address;
    await server.close();
    connection = openServer(address, handlers);
    await until(() => told.some((text) => text.startsWith(`link Nothing answers at ${address}`)));
    connection.dispose();
    connection = openServer('nowhere', handlers);
    expect(told.at(-1)).toMatch(/^link Nothing answers at nowhere\./);
  });

  it('accepts no operator commands', () => {
    const { handlers, told } = ear();
    connection = openServer(server.address, handlers);
    connection.operate({ kind: 'restart' });
    connection.setSpeed(0.5);
    expect(told.filter((text) => text.startsWith('refused'))).toEqual([
      'refused restart: only available with the built-in server',
      'refused slow motion: only available with the built-in server',
    ]);
  });
});

describe('the game’s own server', () => {
  let sockets: WebSocketServer;
  let connection: Connection | null = null;
  let heard: unknown[] = [];

  beforeEach(async () => {
    vi.stubGlobal('WebSocket', PageSocket);
    heard = [];
    sockets = new WebSocketServer({ port: 0, host: '127.0.0.1' });
    await new Promise((resolve) => sockets.once('listening', resolve));
  });
  afterEach(async () => {
    connection?.dispose();
    for (const socket of sockets.clients) socket.terminate();
    await new Promise((resolve) => sockets.close(resolve));
    vi.unstubAllGlobals();
  });

  const address = () => `ws://127.0.0.1:${(sockets.address() as AddressInfo).port}/ws`;
  const ship = {
    position: [1, 2, 3],
    velocity: [0, 0, 0],
    attitude: [1, 0, 0, 0],
    angular_velocity: [0, 0, 0],
    fuel: 1,
  };

  it('is addressed in its JSON: signed in with the token of the address, which is not shown', async () => {
    const { handlers, messages, told, until } = ear();
    sockets.on('connection', (socket, request) => {
      heard.push(request.url);
      socket.on('message', (data: Buffer) => {
        heard.push(JSON.parse(data.toString()));
        if (heard.length > 2) return;
        for (const message of [
          { type: 'welcome', ship_id: 'a' },
          { type: 'state', tick: 4, ships: { a: ship } },
          { type: 'ship.removed', ship_id: 'b' },
        ])
          socket.send(JSON.stringify(message));
      });
    });
    connection = openServer(`${address()}?token=jwt`, handlers);
    await until(() => told.includes('gone b'));
    expect(messages).toMatchObject([{ kind: 'frame', tick: 4, ships: [{ shipId: 'a' }] }]);
    expect(told).toContain('welcome a');
    expect(told.join()).not.toContain('jwt');
    connection.send({ kind: 'ping', id: 1 });
    connection.send({
      kind: 'inputs',
      inputs: [input(1, 5, 0, { thrustLevel: 0.25 }), input(2, 5, 9, { thrustLevel: 0.5 })],
    });
    connection.send({ kind: 'inputs', inputs: [input(3, 6, 0, { thrustLevel: 0.75 })] });
    const last = () => heard.at(-1) as { thrust_level?: number };
    await expect.poll(() => last().thrust_level).toBe(0.75);
    expect(heard).toMatchObject([
      '/ws',
      { type: 'auth', token: 'jwt' },
      { type: 'control', thrust_level: 0.5 },
      { type: 'control', thrust_level: 0.75 },
    ]);
  });

  it('that refuses is not retried automatically, and the page names the reason', async () => {
    const { handlers, told, until } = ear();
    sockets.on('connection', (socket) => socket.close(4003, 'Origin not allowed'));
    connection = openServer(`${address()}?token=jwt`, handlers);
    await until(() => told.some((text) => text.includes('does not accept pages from here')));
    expect(told.at(-1)).toContain('(code 4003, “Origin not allowed”): open the page from an allowed origin.');
  });
});
