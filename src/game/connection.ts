import type { Controls } from '../dynamics';
import { decodeFrameJson } from '../wire';
import { asObject, type GameMessage, openGameMessage, packControls } from './envelope';
import { createDriver, type Driver } from './driver';
import type { LinkState } from './link';
import { type GameConnectionOptions, type GameHandlers, requireConnection } from './options';
import { isTooLarge, MAX_MESSAGE } from './socket';
import { createUnconfirmedControls, type UnconfirmedControls } from './unconfirmed';
import type { LinkStatus } from './statusText';

/** One link to the game's server, which reconnects by itself; at most one socket at any time. */
export interface GameConnection {
  /** The link's state as plain data. */
  readonly state: () => LinkState;
  /** The same as text for the player. */
  readonly status: () => LinkStatus;
  /**
   * Own controls; false when they could not be sent now. Those that have not certainly arrived when the link is lost, or were given
   * while it was down, are sent after the next welcome, only the newest.
   */
  readonly sendControls: (controls: Controls) => boolean;
  /** Any other message of the game's: service, attitude modes. */
  readonly send: (message: unknown) => boolean;
  /** Tries again at once, after a refusal too, with the newest token it has: for another, dispose and create a new one. */
  readonly retry: () => void;
  /** Closes the socket for good; no handler is called afterwards. */
  readonly dispose: () => void;
}

interface Link {
  readonly options: GameConnectionOptions;
  readonly handlers: GameHandlers;
  readonly driver: Driver;
  readonly unconfirmed: UnconfirmedControls;
  /** The token of the next sign-in. */
  readonly held: { token: string };
}

/**
 * Connects at once. Never throws, whatever the server sends.
 * @throws RangeError that names the invalid option or handler
 *
 * @example
 * ```ts
 * const clock = { now: () => performance.now() / 1000, after };
 * const connection = createGameConnection(
 *   { address: 'wss://game.example/ws', token, clock, jitter: Math.random, openSocket: (url) => new WebSocket(url) },
 *   { onFrame: (frame, at) => predictor.receive(frame, at) },
 * );
 * ```
 */
export function createGameConnection(options: GameConnectionOptions, handlers: GameHandlers): GameConnection {
  requireConnection(options, handlers);
  const { address, clock, jitter, openSocket } = options;
  const held = { token: options.token };
  const unconfirmed = createUnconfirmedControls();
  const driver = createDriver({
    address,
    clock,
    jitter,
    openSocket,
    auth() {
      unconfirmed.opened();
      return JSON.stringify({ type: 'auth', token: held.token });
    },
    ping() {
      unconfirmed.pinged();
      return JSON.stringify({ type: 'ping' });
    },
    onData: (data) => receive(own, data),
    onStatus: handlers.onStatus,
  });
  const own: Link = { options, handlers, driver, unconfirmed, held };
  return {
    state: driver.state,
    status: driver.status,
    sendControls: (controls) => sendControls(own, controls),
    send: (message) => send(own, message),
    retry: () => driver.dispatch({ kind: 'retry' }),
    dispose: () => driver.dispatch({ kind: 'end' }),
  };
}

function send(link: Link, message: unknown): boolean {
  if (link.driver.state().phase !== 'live') return false;
  const text = textOf(link, message);
  return text !== null && link.driver.write(text);
}

/** Invalid controls are reported as refused, and not sent. */
function sendControls(link: Link, controls: Controls): boolean {
  let text: string | null;
  try {
    text = textOf(link, (link.options.pack ?? packControls)(controls));
  } catch (error) {
    link.handlers.onRefused?.(error instanceof Error ? error.message : String(error));
    return false;
  }
  if (text === null) return false;
  link.unconfirmed.commanded(text);
  return link.driver.write(text);
}

/** null where JSON has no text for it: a function, a bigint, a circle. */
function jsonOf(message: unknown): string | null {
  try {
    const text: unknown = JSON.stringify(message);
    return typeof text === 'string' ? text : null;
  } catch {
    return null;
  }
}

/** null, and reported, where it is too large, or not JSON. */
function textOf({ handlers }: Link, message: unknown): string | null {
  const text = jsonOf(message);
  if (text === null) {
    handlers.onRefused?.(`message: expected a JSON value, got ${typeof message}`);
    return null;
  }
  if (!isTooLarge(text)) return text;
  handlers.onRefused?.(`message: expected at most ${MAX_MESSAGE} bytes`);
  return null;
}

function receive(link: Link, data: unknown): void {
  const refuse = (reason: string) => link.handlers.onRefused?.(reason);
  if (typeof data !== 'string') return refuse('message: expected text, got bytes');
  if (isTooLarge(data))
    return refuse(`message: expected at most ${MAX_MESSAGE} bytes, got ${data.length} characters`);
  let message: unknown;
  try {
    message = JSON.parse(data);
  } catch {
    return refuse('message: not JSON');
  }
  handle(link, (link.options.open ?? openGameMessage)(message));
}

function handle(link: Link, message: GameMessage): void {
  const { handlers } = link;
  switch (message.kind) {
    case 'welcome':
      handleWelcome(link, asObject(message.about));
      break;
    case 'state':
      handleState(link, message.frame);
      break;
    case 'pong':
      link.unconfirmed.ponged();
      link.driver.dispatch({ kind: 'pong' });
      break;
    case 'token':
      if (typeof message.token !== 'string')
        return handlers.onRefused?.('token_refresh.token: expected a string');
      link.held.token = message.token;
      handlers.onToken?.(message.token);
      break;
    case 'destroyed':
    case 'removed':
      handleGone(link, message);
      break;
    case 'other':
      handlers.onOther?.(message.type, message.message);
      break;
  }
}

/** The first welcome of a connection, or a later one with changes, such as another ship. */
function handleWelcome(
  { driver, handlers, unconfirmed }: Link,
  about: Readonly<Record<string, unknown>>,
): void {
  const wasLive = driver.state().phase === 'live';
  driver.dispatch({ kind: 'welcome' });
  if (driver.state().phase !== 'live') return;
  const shipId = about['ship_id'] ?? about['shipId'];
  unconfirmed.welcomed(typeof shipId === 'string' ? shipId : '');
  const text = wasLive ? null : unconfirmed.text();
  if (text !== null) driver.write(text);
  handlers.onWelcome?.(about);
}

function handleState(link: Link, sent: unknown): void {
  const { handlers, options, driver } = link;
  if (driver.state().phase !== 'live') return handlers.onRefused?.('state: came before the welcome');
  const known = options.bodies === undefined ? {} : { bodies: options.bodies };
  const frame = decodeFrameJson(sent, known);
  const tickRate = frame.ok ? frame.value.tickRate : undefined;
  // A refused state arrived all the same: the game is not paused.
  driver.stateReceived(tickRate === undefined ? undefined : 1 / tickRate);
  if (!frame.ok) return handlers.onRefused?.(`state.${frame.reason}`);
  handlers.onFrame(frame.value, options.clock.now());
}

function handleGone(link: Link, message: GameMessage & { kind: 'destroyed' | 'removed' }): void {
  const about = asObject(message.about);
  const text = (...names: string[]) => {
    const found = names.map((name) => about[name]).find((value) => typeof value === 'string');
    return typeof found === 'string' ? found : '';
  };
  const shipId = text('ship_id', 'shipId');
  if (shipId === '') return link.handlers.onRefused?.(`${message.kind}.ship_id: expected a string`);
  const own = { name: text('ship_name', 'shipName'), body: text('body'), reason: text('reason') };
  link.handlers.onShipGone?.(shipId, message.kind === 'destroyed' ? own : null);
}
