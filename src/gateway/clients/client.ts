import { WebSocket } from 'ws';
import type { WorldEvent } from '../../wire';
import type { Player } from '../accounts';
import type { Removed } from '../redis/feed';
import type { ClientMessage } from './messages';
import {
  type Bucket,
  CLOSE,
  CLOSE_TIMEOUT,
  createBucket,
  EXCESS,
  INPUTS,
  MAX_BUFFERED,
  MAX_PER_ADDRESS,
  MAX_QUEUED_EVENTS,
  MAX_UNAUTHENTICATED,
  MESSAGES,
  SLOW_TIMEOUT,
  consume,
} from './limits';

/** One connection and its state. Every queue in it is bounded. */
export interface Client {
  readonly socket: WebSocket;
  readonly protocol: 'json' | 'stream';
  readonly address: string;
  readonly messages: Bucket;
  readonly inputs: Bucket;
  /** null until signed in. */
  player: Player | null;
  /** Messages received while the token is being verified, in order; null while no sign-in is in progress. */
  queued: ClientMessage[] | null;
  /** Session ID, under which the service counts this client's inputs. */
  session: string;
  /** Last sequence number assigned; used on /ws, whose inputs carry none. */
  seq: number;
  /** Own ship in the last hello, '' for none; null before the first. */
  shipId: string | null;
  /** Tolerance for messages over the rate and refused messages. */
  readonly excess: Bucket;
  /** The gateway is closing the connection and ignores further messages. */
  isClosing: boolean;
  /** The last state was skipped. */
  isBehind: boolean;
  /** When its socket became full, wall s; Infinity while it has room. */
  fullSince: number;
  /** Sent with the next state. */
  events: WorldEvent[];
  removed: Removed[];
  /** The player has had a ship on this connection. */
  hadShip: boolean;
  /** When the player lost its ship, wall s; Infinity while it has one. */
  shiplessSince: number;
  /** Timers of the sign-in timeout and the token's renewal and expiry. */
  readonly timers: Set<ReturnType<typeof setTimeout>>;
}

export function createClient(
  socket: WebSocket,
  protocol: Client['protocol'],
  address: string,
  now: number,
): Client {
  return {
    socket,
    protocol,
    address,
    messages: createBucket(MESSAGES, now),
    inputs: createBucket(INPUTS, now),
    player: null,
    queued: null,
    session: '',
    seq: 0,
    shipId: null,
    excess: createBucket(EXCESS, now),
    isClosing: false,
    isBehind: false,
    fullSince: Infinity,
    events: [],
    removed: [],
    hadShip: false,
    shiplessSince: Infinity,
    timers: new Set(),
  };
}

/** Whether the limits of connections, from one address and without a sign-in, leave no room for another one from `address`. */
export function isFull(clients: readonly Pick<Client, 'address' | 'player'>[], address: string): boolean {
  return (
    clients.filter((client) => client.address === address).length >= MAX_PER_ADDRESS ||
    clients.filter(({ player }) => player === null).length >= MAX_UNAUTHENTICATED
  );
}

/** Closes a connection with a reason; terminates it if the close takes longer than CLOSE_TIMEOUT. */
export function disconnect(client: Client, code: number, reason: string): void {
  for (const timer of client.timers) clearTimeout(timer);
  client.timers.clear();
  if (client.isClosing || client.socket.readyState === WebSocket.CLOSED) return;
  client.isClosing = true;
  client.socket.close(code, reason);
  const cut = setTimeout(() => client.socket.terminate(), CLOSE_TIMEOUT * 1000);
  client.socket.once('close', () => clearTimeout(cut));
}

/**
 * Counts a message over the rate or a refused message; disconnects a client with too many.
 * @param now wall s
 * @returns whether the client was disconnected
 */
export function countExcess(client: Client, now: number): boolean {
  if (consume(client.excess, 1, now)) return false;
  disconnect(client, CLOSE.flood, 'Too many messages');
  // Stops reading, so that the rest of a flood costs nothing.
  client.socket.pause();
  return true;
}

/** Queues events for the client's next state; disconnects a client whose queue is full, so that it reconnects. */
export function queueEvents(
  client: Client,
  events: readonly WorldEvent[],
  removed: readonly Removed[],
): void {
  client.events.push(...events);
  client.removed.push(...removed);
  if (client.events.length + client.removed.length > MAX_QUEUED_EVENTS)
    disconnect(client, CLOSE.slow, 'Too slow: too many events waiting');
}

/** Whether the socket has room for a state. Disconnects a client whose socket has been full for SLOW_TIMEOUT. */
export function canSendState(client: Client, now: number): boolean {
  if (client.socket.readyState !== WebSocket.OPEN) return false;
  const isFull = client.socket.bufferedAmount > MAX_BUFFERED;
  client.isBehind = isFull;
  if (!isFull) client.fullSince = Infinity;
  else if (client.fullSince === Infinity) client.fullSince = now;
  else if (now - client.fullSince > SLOW_TIMEOUT) disconnect(client, CLOSE.slow, 'Too slow');
  return !isFull;
}
