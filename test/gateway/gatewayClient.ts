import { WebSocket } from 'ws';
import { decodeServerMessage } from '../../src/wire';

/** Connects to a gateway on this machine: the messages it sends, parsed, and promises of each end of the socket. */
export function connectClient(port: number, path: string, origin?: string) {
  const socket = new WebSocket(`ws://127.0.0.1:${port}${path}`, origin === undefined ? {} : { origin });
  const received: Record<string, unknown>[] = [];
  socket.on('message', (data: Buffer, isBinary) => {
    const message: unknown = isBinary ? decodeServerMessage(data) : JSON.parse(data.toString());
    received.push(message as Record<string, unknown>);
  });
  const failed = new Promise<string>((resolve) => socket.on('error', ({ message }) => resolve(message)));
  const closed = new Promise<[number, string]>((resolve) =>
    socket.on('close', (code, reason) => resolve([code, reason.toString()])),
  );
  const opened = new Promise((resolve) => socket.on('open', resolve));
  return { socket, received, failed, closed, opened, kinds: () => received.map(({ type }) => type) };
}
