import { connect, createServer, type Socket } from 'node:net';

/** Delays every byte by `seconds` each way, in order: a long line between client and gateway. */
export interface DelayProxy {
  readonly port: number;
  readonly close: () => Promise<void>;
}

export async function startDelayProxy(target: number, seconds: number): Promise<DelayProxy> {
  const sockets = new Set<Socket>();
  const server = createServer((client) => {
    const gateway = connect(target, '127.0.0.1');
    for (const [from, to] of [
      [client, gateway],
      [gateway, client],
    ] as const) {
      sockets.add(from);
      from.on('data', (data) => setTimeout(() => to.writable && to.write(data), seconds * 1000));
      from.on('error', () => to.destroy());
      from.on('close', () => {
        sockets.delete(from);
        setTimeout(() => to.destroy(), seconds * 1000);
      });
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    port: (server.address() as { port: number }).port,
    close() {
      for (const socket of sockets) socket.destroy();
      return new Promise((resolve) => server.close(() => resolve()));
    },
  };
}
