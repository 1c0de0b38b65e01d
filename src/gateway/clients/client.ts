import { WebSocket } from 'ws';
import type { WorldEvent } from '../../wire';
import type { Player } from '../accounts';
import type { Removed } from '../redis/feed';
import type { Said } from './speech';
import {
  type Bucket,
  CLOSE,
  createBucket,
  EXCESS,
  INPUTS,
  MAX_BUFFERED,
  MAX_EVENTS_WAITING,
  MESSAGES,
  SLOW_FOR,
  take,
} from './limits';

/** One connection and its state, all of which is bounded. */
export interface Client {
  readonly socket: WebSocket;
  readonly protocol: 'json' | 'stream';
  readonly address: string;
  readonly messages: Bucket;
  readonly inputs: Bucket;
  /** null before it has signed in. */
  player: Player | null;
  /** Messages that came while the token was being verified, in order; null where no sign-in is under way. */
  early: Said[] | null;
  /** The session by which the service distinguishes its inputs. */
  session: string;
  /** Of a protocol that numbers no inputs: the last number given. */
  seq: number;
  /** The own ship in the last welcome, '' for none; null before the first. */
  shipId: string | null;
  /** Messages beyond its rate, and refused ones. */
  readonly excess: Bucket;
  /** Told to go: what it still says is not heard. */
  isDismissed: boolean;
  /** A state has been left out. */
  isBehind: boolean;
  /** Wall s since which its socket is full; Infinity while it is not. */
  fullSince: number;
  /** Told with its next state. */
  events: WorldEvent[];
  removed: Removed[];
  /** The player has had a ship on this connection. */
  hadShip: boolean;
  /** Wall s since which the player has no ship; Infinity while it has one. */
  shiplessSince: number;
  /** Ends what only time ends: the wait for a sign-in, the token. */
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
    early: null,
    session: '',
    seq: 0,
    shipId: null,
    excess: createBucket(EXCESS, now),
    isDismissed: false,
    isBehind: false,
    fullSince: Infinity,
    events: [],
    removed: [],
    hadShip: false,
    shiplessSince: Infinity,
    timers: new Set(),
  };
}

/** Closes a connection with a reason; one that does not close is cut. */
export function dismiss(client: Client, code: number, reason: string): void {
  for (const timer of client.timers) clearTimeout(timer);
  client.timers.clear();
  if (client.isDismissed || client.socket.readyState === WebSocket.CLOSED) return;
  client.isDismissed = true;
  client.socket.close(code, reason);
  const cut = setTimeout(() => client.socket.terminate(), 2000);
  client.socket.once('close', () => clearTimeout(cut));
}

/** Counts a message beyond the rate, or a refused one; whether the client was sent away for it. `now`: wall s. */
export function countExcess(client: Client, now: number): boolean {
  if (take(client.excess, 1, now)) return false;
  dismiss(client, CLOSE.flood, 'Too many messages');
  // Nor read: the rest of a flood costs nothing.
  client.socket.pause();
  return true;
}

/** Keeps the client's events; a client that is too far behind is disconnected and starts again. */
export function remember(client: Client, events: readonly WorldEvent[], removed: readonly Removed[]): void {
  client.events.push(...events);
  client.removed.push(...removed);
  if (client.events.length + client.removed.length > MAX_EVENTS_WAITING)
    dismiss(client, CLOSE.slow, 'Too slow: too many events waiting');
}

/** Whether a state may be sent now; a client that has been too slow for too long is disconnected. */
export function mayTakeState(client: Client, now: number): boolean {
  if (client.socket.readyState !== WebSocket.OPEN) return false;
  const isFull = client.socket.bufferedAmount > MAX_BUFFERED;
  client.isBehind = isFull;
  if (!isFull) client.fullSince = Infinity;
  else if (client.fullSince === Infinity) client.fullSince = now;
  else if (now - client.fullSince > SLOW_FOR) dismiss(client, CLOSE.slow, 'Too slow');
  return !isFull;
}
