import type { AddressInfo } from 'node:net';
import { WebSocketServer } from 'ws';
import type { ClientMessage } from '../../../../src/index';
import type { DesignServer } from './server';

/** The design's server on a real socket and the machine's clock; one player, who flies one of its ships. */
export interface SocketOfDesign {
  readonly address: string;
  readonly server: DesignServer;
  /** s since it began, as the server's own times. */
  readonly now: () => number;
  /** Epoch s at its beginning. */
  readonly beganAt: number;
  /** The player's ship. */
  flown: string;
  readonly close: () => Promise<void>;
}

/** ms between two looks at the clock. */
const LOOK = 4;

export async function listenAsDesign(server: DesignServer, flown: string): Promise<SocketOfDesign> {
  const beganAt = (performance.timeOrigin + performance.now()) / 1000;
  const now = () => (performance.timeOrigin + performance.now()) / 1000 - beganAt;
  const sockets = new WebSocketServer({ port: 0, host: '127.0.0.1' });
  const tellAll = (message: object) => {
    const text = JSON.stringify(message);
    for (const client of sockets.clients) client.send(text);
  };
  sockets.on('connection', (socket) => {
    socket.on('message', (data: Buffer) => {
      const message = JSON.parse(data.toString()) as ClientMessage;
      if (message.kind === 'ping') {
        server.runTo(now(), tellAll);
        socket.send(JSON.stringify({ kind: 'pong', id: message.id, ...server.clockAt(now()) }));
      } else for (const { controls } of message.inputs) server.control(listening.flown, controls);
    });
  });
  const timer = setInterval(() => {
    server.runTo(now(), tellAll);
  }, LOOK);
  await new Promise((resolve) => sockets.once('listening', resolve));
  const { port } = sockets.address() as AddressInfo;
  const listening: SocketOfDesign = {
    address: `ws://127.0.0.1:${port}`,
    server,
    now,
    beganAt,
    flown,
    async close() {
      clearInterval(timer);
      for (const client of sockets.clients) client.terminate();
      await new Promise((resolve) => sockets.close(resolve));
    },
  };
  return listening;
}
