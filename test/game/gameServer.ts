/** A server of the game's as the tests drive it, and a connection to it; each test has its own. */
import type { AddressInfo } from 'node:net';
import { afterEach, beforeEach } from 'vitest';
import { WebSocket, WebSocketServer } from 'ws';
import {
  createGameConnection,
  type GameConnection,
  type GameConnectionOptions,
  type GameHandlers,
} from '../../src/game';
import { createVirtualClock } from './virtualClock';

const SHIP = {
  position: { x: 1, y: 2, z: 3 },
  velocity: { x: 0, y: 0, z: 0 },
  attitude: { w: 1, x: 0, y: 0, z: 0 },
  angular_velocity: { x: 0, y: 0, z: 0 },
  fuel: 10,
};
export const STATE = { type: 'state', tick: 7, ships: { a: SHIP } };

export let server: WebSocketServer;
export let address = '';
export let sockets: WebSocket[] = [];
/** What the server heard, in order. */
export let heard: unknown[] = [];
let connection: GameConnection | null = null;
let waiting: (() => void)[] = [];

/** A message was received or sent, or the socket closed: waiting tests check again. */
function notice(): void {
  for (const check of waiting) check();
}

export function until(met: () => boolean): Promise<void> {
  return new Promise((resolve) => {
    const check = () => {
      if (!met()) return;
      waiting = waiting.filter((other) => other !== check);
      resolve();
    };
    waiting.push(check);
    check();
  });
}

/** For each test of the file that calls it. */
export function useGameServer(): void {
  beforeEach(async () => {
    [sockets, heard, waiting] = [[], [], []];
    await listen(0);
  });
  afterEach(async () => {
    connection?.dispose();
    connection = null;
    await stopServer();
  });
}

export async function listen(port: number): Promise<void> {
  server = new WebSocketServer({ port, host: '127.0.0.1' });
  server.on('connection', (socket) => {
    sockets.push(socket);
    socket.on('message', (data: Buffer) => {
      heard.push(JSON.parse(data.toString()));
      notice();
    });
    socket.on('close', notice);
    notice();
  });
  await new Promise((resolve) => server.once('listening', resolve));
  address = `ws://127.0.0.1:${(server.address() as AddressInfo).port}`;
}

export function stopServer(): Promise<void> {
  for (const socket of server.clients) socket.terminate();
  return new Promise((resolve) => server.close(() => resolve()));
}

export function connect(change: Partial<GameConnectionOptions> = {}) {
  const clock = createVirtualClock();
  const told: string[] = [];
  const tell = (text: string) => {
    told.push(text);
    notice();
  };
  const handlers: GameHandlers = {
    onFrame: (frame) => tell(`frame ${frame.tick}`),
    onWelcome: (about) => tell(`welcome ${JSON.stringify(about)}`),
    onStatus: ({ phase, text }) => tell(`status ${phase}: ${text}`),
    onShipGone: (shipId, own) => tell(`gone ${shipId} ${JSON.stringify(own)}`),
    onToken: (token) => tell(`token ${token}`),
    onRefused: (reason) => tell(`refused ${reason}`),
    onOther: (type) => tell(`other ${type}`),
  };
  connection = createGameConnection(
    {
      address,
      token: 'jwt-1',
      clock,
      jitter: () => 0.5,
      openSocket: (to) => new WebSocket(to),
      ...change,
    },
    handlers,
  );
  return { clock, told, live: connection };
}

export const say = (message: unknown) => sockets.at(-1)!.send(JSON.stringify(message));

export async function welcomed(change: Partial<GameConnectionOptions> = {}) {
  const made = connect(change);
  await until(() => heard.length === 1);
  say({ type: 'welcome', player_id: 'p', ship_id: 'a' });
  await until(() => made.told.some((text) => text.startsWith('welcome')));
  return made;
}
