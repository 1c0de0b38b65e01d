import { beginLink, dueAt, type Effect, type LinkEvent, type LinkState, type Step, stepLink } from './link';
import type { GameClock } from './options';
import { abandon, type GameSocket, OPEN } from './socket';
import { type LinkStatus, statusOf } from './statusText';

/** A link's messages and callbacks; the driver itself handles only sockets and times. */
export interface DriverOptions {
  readonly address: string;
  readonly clock: GameClock;
  /** 0 to 1, for the jitter of reconnects. */
  readonly jitter: () => number;
  /** Opens a socket: (address) => new WebSocket(address). */
  readonly openSocket: (address: string) => GameSocket;
  /** The first message once the socket is open; null for none. */
  readonly auth: () => string | Uint8Array<ArrayBuffer> | null;
  /** A message that the server answers. */
  readonly ping: () => string | Uint8Array<ArrayBuffer>;
  /** Called with each message, unread. */
  readonly onData: (data: unknown) => void;
  /** Called when the link's status changes. */
  readonly onStatus: ((status: LinkStatus) => void) | undefined;
}

/** One link that reconnects by itself, with at most one socket at any time. */
export interface Driver {
  /** The link's state as plain data. */
  readonly state: () => LinkState;
  /** The same as text for the player. */
  readonly status: () => LinkStatus;
  /** Feeds an event to the link. */
  readonly dispatch: (event: LinkEvent) => void;
  /** A state arrived; `sentInterval`: the wall s between two states, if the state has it. */
  readonly stateReceived: (sentInterval: number | undefined) => void;
  /** Sends a message of the caller's; false, and nothing is sent, unless the link is live: before the welcome a server refuses it. */
  readonly write: (message: string | Uint8Array<ArrayBuffer>) => boolean;
}

/** Upper bound of a measured interval between two states, s: a pause must not distort the usual interval. */
const MAX_INTERVAL = 10;

interface Held {
  state: LinkState;
  socket: GameSocket | null;
  cancelTimer: (() => void) | null;
  /** The status reported last. */
  reportedKey: string;
  lastStateAt: number;
  /** Usual wall s between two states. */
  interval: number;
}

/**
 * Connects at once.
 *
 * @example
 * ```ts
 * const driver = createDriver({
 *   address: 'wss://game.example/ws',
 *   clock: { now: () => now, after: () => () => undefined },
 *   jitter: Math.random,
 *   openSocket: (url) => new WebSocket(url),
 *   auth: () => JSON.stringify({ type: 'auth', token: 'abc' }),
 *   ping: () => JSON.stringify({ type: 'ping' }),
 *   onData: (data) => console.log(data),
 *   onStatus: ({ text }) => console.log(text),
 * });
 * driver.write('text');
 * ```
 */
export function createDriver(options: DriverOptions): Driver {
  const { clock } = options;
  const first = beginLink(clock.now());
  const held: Held = {
    state: first.state,
    socket: null,
    cancelTimer: null,
    reportedKey: '',
    lastStateAt: NaN,
    interval: 1,
  };
  apply(options, held, first);
  return {
    state: () => held.state,
    status: () => statusOf(held.state, options.address, clock.now()),
    dispatch: (event) => dispatch(options, held, event),
    stateReceived(sentInterval) {
      const now = clock.now();
      const since = Math.min(now - held.lastStateAt, MAX_INTERVAL);
      const isFirst = Number.isNaN(since);
      if (sentInterval !== undefined) held.interval = isFirst ? sentInterval : Math.max(sentInterval, since);
      else if (!isFirst) held.interval += (since - held.interval) / 4;
      held.lastStateAt = now;
      dispatch(options, held, { kind: 'state', interval: held.interval });
    },
    write: (message) => held.state.phase === 'live' && write(held, message),
  };
}

function dispatch(options: DriverOptions, held: Held, event: LinkEvent): void {
  apply(options, held, stepLink(held.state, event, options.clock.now(), options.jitter()));
}

function apply(options: DriverOptions, held: Held, { state, effects }: Step): void {
  held.state = state;
  const failed = effects.map((effect) => perform(options, held, effect)).find((reason) => reason !== null);
  schedule(options, held);
  reportStatus(options, held);
  if (failed !== undefined) dispatch(options, held, { kind: 'closed', code: 0, reason: failed });
}

/** The reason why no socket could be created, or null. */
function perform(options: DriverOptions, held: Held, effect: Effect): string | null {
  const message = effect === 'auth' ? options.auth() : effect === 'ping' ? options.ping() : null;
  if (message !== null) write(held, message);
  if (effect !== 'open' && effect !== 'close') return null;
  const { socket } = held;
  held.socket = null;
  if (socket !== null) abandon(socket);
  return effect === 'open' ? open(options, held) : null;
}

function open(options: DriverOptions, held: Held): string | null {
  held.lastStateAt = NaN;
  let socket: GameSocket;
  try {
    socket = options.openSocket(options.address);
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  if (typeof (socket as GameSocket | undefined)?.send !== 'function')
    throw new RangeError(
      `options.openSocket: expected it to return a socket, (address) => new WebSocket(address), got ${typeof socket}`,
    );
  held.socket = socket;
  socket.onopen = () => dispatch(options, held, { kind: 'opened' });
  socket.onmessage = ({ data }: { readonly data: unknown }) => options.onData(data);
  socket.onclose = ({ code, reason }: { readonly code: number; readonly reason: string }) =>
    dispatch(options, held, { kind: 'closed', code, reason });
  // The close that follows reports it.
  socket.onerror = () => undefined;
  return null;
}

function schedule(options: DriverOptions, held: Held): void {
  const { clock } = options;
  const due = dueAt(held.state);
  held.cancelTimer?.();
  const wait = Math.max(0, due - clock.now());
  held.cancelTimer =
    due === Infinity ? null : timer(clock, wait, () => dispatch(options, held, { kind: 'time' }));
}

/** Sets a timer; returns its cancel function. The constructor sets the first one and opens the first socket, so it detects a wrong clock or opener. */
function timer({ after }: GameClock, wait: number, act: () => void): () => void {
  const cancel: unknown = after(wait, act);
  if (typeof cancel === 'function') return cancel as () => void;
  throw new RangeError(
    `options.clock.after: expected it to return a function that cancels the timer, got ${String(cancel)}`,
  );
}

function reportStatus(options: DriverOptions, held: Held): void {
  const status = statusOf(held.state, options.address, options.clock.now());
  const key = `${status.phase} ${status.text}`;
  if (key === held.reportedKey) return;
  held.reportedKey = key;
  options.onStatus?.(status);
}

function write(held: Held, message: string | Uint8Array<ArrayBuffer>): boolean {
  if (held.socket?.readyState !== OPEN) return false;
  held.socket.send(message);
  return true;
}
