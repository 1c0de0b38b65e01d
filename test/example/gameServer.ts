import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { type WebSocket, WebSocketServer } from 'ws';
import { createAuthority, runDueTicks, startLoop } from '../../src/authority';
import { BODIES, type Controls, SHIP_CLASSES, TERRAINS } from '../../src/dynamics';
import { SCENARIOS, loadScenario } from '../../src/scenarios';
import { decodeControlsJson, encodeFrameJson } from '../../src/wire';
import { valueOf } from '../authority/moon';

/** A server that speaks the game's JSON as in GAME.md: login, auth, welcome, states; controls act from the next tick on. */
export interface GameServer {
  /** http://… of the login; the socket is at /ws of it. */
  readonly address: string;
  /** Received controls, in order. */
  readonly controls: Controls[];
  readonly close: () => Promise<void>;
}

/** @param name of the scenario to run, with one ship */
export async function startGameServer(name: string, tickRate: number): Promise<GameServer> {
  const loaded = valueOf(loadScenario({ ...SCENARIOS.find((one) => one.name === name)!, tickRate }));
  const { scenario } = loaded;
  const authority = valueOf(
    createAuthority({
      settings: scenario.settings,
      shipClasses: SHIP_CLASSES,
      terrain: scenario.terrain,
      terrains: TERRAINS,
      bodies: BODIES.filter((body) => body.name === scenario.body),
      tickRate,
      timeScale: 1,
    }),
  );
  const order = { shipId: 'ship-1', playerId: 'ada', name: 'Kestrel', ship: loaded.ship };
  const reason = authority.spawn(order);
  if (reason !== null) throw new Error(reason);
  valueOf(authority.join('ada', 'ship-1'));
  const clock = () => performance.now() / 1000;
  const loop = startLoop(authority, clock());
  const controls: Controls[] = [];
  let seq = 0;

  const http = createServer((_request, response) => {
    response.setHeader('Access-Control-Allow-Origin', '*');
    response.end(JSON.stringify({ player_id: 'ada', ship_id: 'ship-1', token: 'token', is_admin: false }));
  });
  const sockets = new WebSocketServer({ server: http, path: '/ws' });
  /** Signed in: the game sends states to no other socket. */
  const players = new Set<WebSocket>();
  const state = () => JSON.stringify({ type: 'state', ...encodeFrameJson(authority.frameFor('ada')!) });

  function answer(message: Record<string, unknown>, socket: WebSocket): void {
    const say = (text: string) => socket.send(text);
    if (message['type'] === 'auth') {
      players.add(socket);
      say(JSON.stringify({ type: 'welcome', player_id: 'ada', ship_id: 'ship-1' }));
      say(state());
    } else if (message['type'] === 'ping') say('{"type":"pong"}');
    else if (message['type'] === 'control') {
      const given = valueOf(decodeControlsJson(message));
      controls.push(given);
      seq += 1;
      const input = { seq, tick: authority.tickNumber() + 1, substep: 0, controls: given };
      authority.receive('ada', { kind: 'inputs', inputs: [input] }, clock());
    }
  }
  sockets.on('connection', (socket) => {
    socket.on('close', () => players.delete(socket));
    socket.on('message', (data: Buffer) =>
      answer(JSON.parse(data.toString()) as Record<string, unknown>, socket),
    );
  });
  await new Promise<void>((resolve) => http.listen(0, '127.0.0.1', resolve));
  const sendStates = () => players.forEach((socket) => socket.send(state()));
  const timer = setInterval(() => runDueTicks(loop, authority, clock(), sendStates), 5);
  return {
    address: `http://127.0.0.1:${(http.address() as AddressInfo).port}`,
    controls,
    close: () => {
      clearInterval(timer);
      for (const socket of sockets.clients) socket.terminate();
      return new Promise((resolve) => http.close(() => resolve()));
    },
  };
}
