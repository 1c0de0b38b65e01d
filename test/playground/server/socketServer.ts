import type { AddressInfo } from 'node:net';
import { WebSocketServer } from 'ws';
import { type Authority, createAuthority, runDueTicks, startLoop } from '../../../src/authority';
import { BODIES, SHIP_CLASSES, TERRAINS } from '../../../src/dynamics';
import { type Scenario, SCENARIOS, loadScenario } from '../../../src/scenarios';
import { decodeClientMessage, encodeServerMessage, type ServerMessage } from '../../../src/wire';
import { valueOf } from '../../authority/moon';

/** A real server on a real socket: the authority on the machine's clock, one ship per client. For `?server=ws://…` and its tests. */
export interface SocketServer {
  readonly address: string;
  readonly authority: Authority;
  /** Breaks every connection; new ones are accepted. */
  readonly hangUp: () => void;
  /** Sends an invalid message to everyone. */
  readonly say: (text: string) => void;
  /** Sockets that are open now, and the total so far. */
  readonly connections: () => { readonly open: number; readonly ever: number };
  readonly close: () => Promise<void>;
}

/** @param port 0 for any that is free */
export async function startSocketServer(
  name: string,
  change: Partial<Scenario> = {},
  port = 0,
): Promise<SocketServer> {
  const loaded = valueOf(
    loadScenario({ ...SCENARIOS.find((scenario) => scenario.name === name)!, ...change }),
  );
  const { scenario } = loaded;
  const authority = valueOf(
    createAuthority({
      settings: scenario.settings,
      shipClasses: SHIP_CLASSES,
      bodies: BODIES.filter((body) => body.name === scenario.body),
      terrain: scenario.terrain,
      terrains: TERRAINS,
      tickRate: scenario.tickRate,
      timeScale: scenario.timeScale,
    }),
  );
  const clock = () => performance.now() / 1000;
  const loop = startLoop(authority, clock());
  const sockets = new WebSocketServer({ port, host: '127.0.0.1' });
  const players = new Map<string, (message: ServerMessage) => void>();
  let joined = 0;

  function tellFrames(): void {
    for (const [playerId, tell] of players) tell(authority.frameFor(playerId)!);
  }

  sockets.on('connection', (socket) => {
    joined += 1;
    const playerId = `player-${joined}`;
    const shipId = `ship-${joined}`;
    const tell = (message: ServerMessage) => socket.send(encodeServerMessage(message));
    const reason = authority.spawn({ shipId, playerId, name: shipId, ship: loaded.ship });
    if (reason !== null) {
      socket.close(1011, reason);
      return;
    }
    tell(valueOf(authority.join(playerId, shipId))!);
    tell(authority.frameFor(playerId)!);
    players.set(playerId, tell);
    socket.on('message', (data: Buffer) => {
      const message = decodeClientMessage(new Uint8Array(data));
      const answer = message.ok ? authority.receive(playerId, message.value, clock()) : message;
      if (answer.ok && answer.value !== null) tell(answer.value);
    });
    socket.on('close', () => {
      players.delete(playerId);
      authority.leave(playerId);
      authority.despawn(shipId);
    });
  });
  await new Promise((resolve) => sockets.once('listening', resolve));
  const timer = setInterval(() => runDueTicks(loop, authority, clock(), tellFrames), 5);

  return {
    address: `ws://127.0.0.1:${(sockets.address() as AddressInfo).port}`,
    authority,
    hangUp: () => {
      for (const socket of sockets.clients) socket.terminate();
    },
    say: (text) => {
      for (const socket of sockets.clients) socket.send(text);
    },
    connections: () => ({ open: sockets.clients.size, ever: joined }),
    close: () => {
      clearInterval(timer);
      for (const socket of sockets.clients) socket.terminate();
      return new Promise((resolve) => sockets.close(() => resolve()));
    },
  };
}
