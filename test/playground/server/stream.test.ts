/** The gateway's /stream on a socket and a clock of the test's: what the page sends, and when it reports a silent server. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { ConnectionHandlers } from '../../../src/playground/server/connection';
import { openServer } from '../../../src/playground/server/realServer';
import {
  decodeClientMessage,
  encodeServerMessage,
  MAX_TICK,
  type ServerFrame,
  type ServerMessage,
} from '../../../src/wire';
import { HELLO } from '../../wire/messages';

class Socket {
  static readonly all: Socket[] = [];
  readonly sent: unknown[] = [];
  readonly readyState = 1;
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  onerror: (() => void) | null = null;
  constructor(readonly address: string) {
    Socket.all.push(this);
  }
  send(data: unknown): void {
    const message = typeof data === 'string' ? null : decodeClientMessage(data as Uint8Array);
    this.sent.push(message === null ? JSON.parse(data as string) : message.ok && message.value);
  }
  close(): void {}
  say(message: ServerMessage): void {
    this.onmessage?.({ data: encodeServerMessage(message).slice().buffer });
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('WebSocket', Socket);
});
afterEach(() => {
  Socket.all.length = 0;
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const stateAt = (tick: number, tickRate = 10): ServerFrame => ({
  ...{ kind: 'frame', tick, tickRate, timeScale: 1, paused: false, lastInput: null },
  ...{ bodies: [], ships: [], events: [] },
});

/** A page that is signed in. */
function openLink(address = 'wss://galaxy.example/stream?token=jwt') {
  const told: string[] = [];
  const nothing = () => undefined;
  const handlers: ConnectionHandlers = {
    ...{ onFrame: nothing, onClosed: nothing, onWelcome: nothing, onShipGone: nothing, onRun: nothing },
    onOpen: (what) => told.push(`open ${what}`),
    onPending: (message) => void message.decode(),
    onLink: (words) => told.push(words),
    onRefused: (reason) => told.push(reason),
  };
  const connection = openServer(address, handlers);
  const signIn = () => {
    const socket = Socket.all.at(-1)!;
    socket.onopen?.();
    socket.say(HELLO);
    return socket;
  };
  return { connection, socket: signIn(), signIn, told };
}

describe('a stream', () => {
  it('is signed in by token and session, after a break from the newest tick on', () => {
    const { connection, socket, signIn } = openLink();
    expect(socket.address).toBe('wss://galaxy.example/stream');
    const auth = socket.sent[0] as { session: string };
    expect(auth).toEqual({
      type: 'auth',
      token: 'jwt',
      session: expect.stringMatching(/^\w{20,}$/) as string,
    });
    socket.say(stateAt(0));
    socket.onclose?.({ code: 1006, reason: '' });
    connection.reconnect();
    const second = signIn();
    expect(second.sent).toEqual([{ ...auth, since: 0 }]);
    second.say(stateAt(7));
    second.onclose?.({ code: 1006, reason: '' });
    connection.reconnect();
    expect(signIn().sent).toEqual([{ ...auth, since: 7 }]);
    openLink();
    expect(Socket.all.at(-1)!.sent).not.toMatchObject([{ session: auth.session }]);
  });

  it('without a token is not signed in', () => {
    expect(openLink('ws://127.0.0.1:8787').socket.sent).toEqual([]);
  });

  it('of one state in 2 s is silent after three of them, not before', () => {
    const { socket, told } = openLink();
    for (const tick of [1, 2]) socket.say(stateAt(tick, 0.5));
    vi.advanceTimersByTime(5900);
    expect(told.at(-1)).toBe('open world');
    vi.advanceTimersByTime(200);
    expect(told.at(-1)).toBe('No states from the server; pinging it…');
    expect(socket.sent.at(-1)).toEqual({ kind: 'ping', id: MAX_TICK });
    socket.say({ kind: 'pong', id: MAX_TICK, tick: 2, sinceTick: 0 });
    expect(told.at(-1)).toBe('The server answers but sends no states: the game is paused.');
    socket.say(stateAt(3, 0.5));
    expect(told.at(-1)).toBe('');
  });
});
