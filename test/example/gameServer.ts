import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { WebSocketServer } from 'ws';
import { createAuthority, runDueTicks, startLoop } from '../../src/authority';
import { BODIES, type Controls, SHIP_CLASSES, TERRAINS } from '../../src/dynamics';
import { SCENARIOS, loadScenario } from '../../src/scenarios';
import { decodeControlsJson, encodeFrameJson } from '../../src/wire';
import { valueOf } from '../authority/moon';

/** A server that speaks the game's JSON as GAME.md has it: login, auth, welcome, states; controls act from the next tick on. */
export interface GameServer {
  /** http://… of the login; the socket is at /ws of it. */
  readonly address: string;
  /** Controls that came, in their order. */
  readonly controls: Controls[];
  readonly close: () => Promise<void>;
}

/** @param name of the scenario that is flown, with one ship, on its first body */
export async function startGameServer(name: string, tickRate: number): Promise<GameServer> {
  const loaded = valueOf(loadScenario({ ...SCENARIOS.find((one) => one.name === name)!, tickRate }));
  const { scenario } = loaded;
  const authority = valueOf(
    createAuthority({
      ...{
        settings: scenario.settings,
        shipClasses: SHIP_CLASSES,
        terrain: scenario.terrain,
        terrains: TERRAINS,
      },
      ...{ bodies: BODIES.filter((body) => body.name === scenario.body), tickRate, timeScale: 1 },
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
  const state = () => JSON.stringify({ type: 'state', ...encodeFrameJson(authority.frameFor('ada')!) });

  function answer(message: Record<string, unknown>, say: (text: string) => void): void {
    if (message['type'] === 'auth') {
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
    const say = (text: string) => socket.send(text);
    socket.on('message', (data: Buffer) =>
      answer(JSON.parse(data.toString()) as Record<string, unknown>, say),
    );
  });
  await new Promise<void>((resolve) => http.listen(0, '127.0.0.1', resolve));
  const tell = () => sockets.clients.forEach((socket) => socket.send(state()));
  const timer = setInterval(() => runDueTicks(loop, authority, clock(), tell), 5);
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
