/** A gateway's state whose clock, world and sockets the test controls. */
import { createClient, type Client } from '../../src/gateway/clients/client';
import type { Hangar } from '../../src/gateway/options';
import type { GatewayState } from '../../src/gateway/state';
import type { WorldFrame } from '../../src/gateway/redis/feed';
import type { OwnInput } from '../../src/gateway/redis/inbox';
import { receive } from '../../src/gateway/clients/receive';
import {
  decodeServerMessage,
  encodeClientMessage,
  type ServerMessage,
  type ShipState,
  type WorldEvent,
} from '../../src/wire';
import { FRAME, HELLO, SHIP } from '../wire/messages';

export interface Closed {
  readonly code: number;
  readonly reason: string;
}

/** A client, the decoded messages sent to its socket, and how it was closed. */
export interface Connected {
  readonly client: Client;
  readonly sent: (Record<string, unknown> | ServerMessage)[];
  readonly closed: Closed[];
  readonly socket: { bufferedAmount: number; readyState: number };
  /** Answers to ping frames. */
  readonly pongs: readonly string[];
}

function decoded(message: string | Uint8Array): Record<string, unknown> | ServerMessage {
  if (typeof message === 'string') return JSON.parse(message) as Record<string, unknown>;
  const read = decodeServerMessage(message);
  if (!read.ok) throw new Error(read.reason);
  return read.value;
}

export function createFakeGateway(hangar?: Hangar) {
  const state = { now: 1000, newest: null as WorldFrame | null };
  const inputs: OwnInput[] = [];
  const commands: [string, object][] = [];
  const gateway = {
    options: {
      clock: () => state.now,
      nonce: () => 'nonce',
      log: () => undefined,
      ...(hangar && { hangar }),
    },
    accounts: {
      verify: (token: string) =>
        Promise.resolve(
          token === 'wrong'
            ? null
            : { playerId: token, username: `user of ${token}`, expires: state.now + 60 },
        ),
      renew: ({ playerId }: { playerId: string }) => Promise.resolve(`new token of ${playerId}`),
    },
    clients: new Set<Client>(),
    feed: {
      newest: () => state.newest,
      eventsSince: () => Promise.resolve([]) as Promise<readonly WorldEvent[]>,
    },
    inbox: {
      controls: (input: OwnInput) => inputs.push(input),
      command: (type: string, data: object) => commands.push([type, data]),
    },
    world: HELLO,
    clockOffset: 0.25,
    refused: 0,
  };

  function connect(protocol: Client['protocol']): Connected {
    const sent: Connected['sent'] = [];
    const closed: Closed[] = [];
    const pongs: string[] = [];
    const socket = {
      readyState: 1,
      OPEN: 1,
      bufferedAmount: 0,
      send: (message: string | Uint8Array) => sent.push(decoded(message)),
      close: (code: number, reason: string) => {
        closed.push({ code, reason });
        socket.readyState = 3;
      },
      once: (_event: string, act: () => void) => act(),
      terminate: () => undefined,
      pause: () => undefined,
      pong: (data: Buffer) => pongs.push(data.toString()),
    };
    const client = createClient(socket as never, protocol, '127.0.0.1', state.now);
    gateway.clients.add(client);
    return { client, sent, closed, socket, pongs };
  }

  /** Connects a client that is already signed in. */
  function signedIn(playerId: string, protocol: Client['protocol']): Connected {
    const connected = connect(protocol);
    connected.client.player = { playerId, username: `user of ${playerId}`, expires: state.now + 60 };
    connected.client.session = 'page';
    return connected;
  }

  return { state, gateway: gateway as unknown as GatewayState, inputs, commands, connect, signedIn };
}

export function shipOf(playerId: string, shipId = `ship of ${playerId}`): ShipState {
  return { ...SHIP, playerId, shipId };
}

export function worldOf(ships: readonly ShipState[], changes: Partial<WorldFrame['frame']> = {}): WorldFrame {
  const frame = { ...FRAME, paused: false, events: [], lastInput: null, ...changes, ships };
  return { frame, due: 1000, lastInputs: new Map(), removed: [] };
}

export const sendJson = (gateway: GatewayState, { client }: Connected, message: object) =>
  receive(gateway, client, Buffer.from(JSON.stringify(message)), false);
export const sendBytes = (
  gateway: GatewayState,
  { client }: Connected,
  message: Parameters<typeof encodeClientMessage>[0],
) => receive(gateway, client, Buffer.from(encodeClientMessage(message)), true);

/** A gateway whose world has a ship of p1, and its pilot's connection. */
export function piloted(protocol: 'json' | 'stream') {
  const made = createFakeGateway();
  made.state.newest = worldOf([shipOf('p2'), shipOf('p1')], { tick: 50 });
  return { ...made, pilot: made.signedIn('p1', protocol) };
}

export const refusalOf = (message: unknown) => (message as { error: { message: string } }).error.message;

/** Number of excess and refused messages counted against the client. */
export const excessOf = ({ client: { excess } }: ReturnType<typeof piloted>['pilot']) =>
  excess.burst - excess.level;
