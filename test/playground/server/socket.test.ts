import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { WebSocket } from 'ws';
import {
  type Connection,
  type ConnectionHandlers,
  openSocket,
} from '../../../src/playground/server/connection';
import { decodeServerMessage, encodeClientMessage, type ServerMessage } from '../../../src/wire';
import { input, valueOf } from '../../authority/moon';
import { type SocketServer, startSocketServer } from './socketServer';

/** As a browser's: an error is told by its close alone, and is not thrown where nobody listens. */
class PageSocket extends WebSocket {
  constructor(address: string) {
    super(address);
    this.on('error', () => undefined);
  }
}

/** What was told, and a way to wait for it. */
function ear() {
  const messages: ServerMessage[] = [];
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
    onBytes: notice((bytes) => messages.push(valueOf(decodeServerMessage(bytes)))),
    onClosed: notice((reason) => told.push(`closed ${reason}`)),
    onRefused: notice((reason) => told.push(`refused ${reason}`)),
    onStatus: notice(() => told.push('status')),
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

  it('tells its hello and frames, answers pings and flies by inputs', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openSocket(server.address, handlers);
    await until(() => messages.length >= 3);
    expect(told).toEqual(['open world']);
    expect(messages[0]).toMatchObject({ kind: 'hello', shipId: 'ship-1', tickRate: 50 });
    connection.send(encodeClientMessage({ kind: 'ping', id: 77 }));
    await until(() => messages.some(({ kind }) => kind === 'pong'));
    const tick = server.authority.tickNumber();
    connection.send(
      encodeClientMessage({ kind: 'inputs', inputs: [input(1, tick + 5, 1, { thrustLevel: 1 })] }),
    );
    const flying = (message: ServerMessage) =>
      message.kind === 'frame' && message.ships[0]!.surfaceContactState === '';
    await until(() => messages.some(flying));
    expect(messages.find(flying)).toMatchObject({ lastInput: { seq: 1 } });
  });

  it('that hangs up is told so, and may be called again', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openSocket(server.address, handlers);
    await until(() => messages.length > 0);
    server.hangUp();
    await until(() => told.length === 2);
    expect(told[1]).toBe(`closed ${server.address}: closed with code 1006`);
    connection.send(Uint8Array.of(1));
    connection.reconnect();
    await until(() => told.length === 3);
    expect(told[2]).toBe('open again');
  });

  it('that speaks text is refused by name', async () => {
    const { handlers, messages, told, until } = ear();
    connection = openSocket(server.address, handlers);
    await until(() => messages.length > 0);
    server.say('hello');
    await until(() => told.length === 2);
    expect(told[1]).toContain(`refused ${server.address} sent text`);
  });

  it('that is not there, and an address that is none, are told as closed', async () => {
    const { handlers, told, until } = ear();
    const address = server.address;
    await server.close();
    connection = openSocket(address, handlers);
    await until(() => told.length === 1);
    expect(told[0]).toContain(`closed ${address}`);
    connection.dispose();
    connection = openSocket('nowhere', handlers);
    expect(told[1]).toMatch(/^closed nowhere: ./);
  });

  it('takes no orders', () => {
    const { handlers, told } = ear();
    connection = openSocket(server.address, handlers);
    connection.operate({ kind: 'restart' });
    expect(told).toEqual(['refused restart: only available with the built-in server']);
  });
});
