import type { Controls } from '../dynamics';
import { decodeFrameJson } from '../wire';
import { asObject, type GameMessage, openGameMessage, packControls } from './envelope';
import { createDriver, type Driver } from './driver';
import type { LinkState } from './link';
import { type GameConnectionOptions, type GameHandlers, requireConnection } from './options';
import { isTooLarge, MAX_MESSAGE } from './socket';
import type { LinkStatus } from './words';

/** One link to the game's server, which reconnects by itself; at most one socket at any time. */
export interface GameConnection {
  /** The link's state as plain data. */
  readonly state: () => LinkState;
  /** The same in words for a person. */
  readonly status: () => LinkStatus;
  /** Own controls; false when they could not be sent (not live, or too large). */
  readonly sendControls: (controls: Controls) => boolean;
  /** Any other message of the game's: service, attitude modes. */
  readonly send: (message: unknown) => boolean;
  /** Tries again at once, after a refusal too. */
  readonly retry: () => void;
  /** Closes the socket for good; no handler is called afterwards. */
  readonly dispose: () => void;
}

interface Link {
  readonly options: GameConnectionOptions;
  readonly handlers: GameHandlers;
  readonly driver: Driver;
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
  const driver = createDriver({
    ...{ address, clock, jitter, openSocket },
    auth: () => JSON.stringify({ type: 'auth', token: held.token }),
    ping: () => JSON.stringify({ type: 'ping' }),
    onData: (data) => take(own, data),
    onStatus: handlers.onStatus,
  });
  const own: Link = { options, handlers, driver, held };
  return {
    state: driver.state,
    status: driver.status,
    sendControls: (controls) => sayControls(own, controls),
    send: (message) => say(own, message),
    retry: () => driver.happen({ kind: 'retry' }),
    dispose: () => driver.happen({ kind: 'end' }),
  };
}

function say({ driver, handlers }: Link, message: unknown): boolean {
  if (driver.state().phase !== 'live') return false;
  const text = JSON.stringify(message);
  if (!isTooLarge(text)) return driver.write(text);
  handlers.onRefused?.(`message: expected at most ${MAX_MESSAGE} bytes`);
  return false;
}

/** Invalid controls are reported as refused, and not sent. */
function sayControls(link: Link, controls: Controls): boolean {
  try {
    return say(link, (link.options.pack ?? packControls)(controls));
  } catch (error) {
    link.handlers.onRefused?.(error instanceof Error ? error.message : String(error));
    return false;
  }
}

function take(link: Link, data: unknown): void {
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
  act(link, (link.options.open ?? openGameMessage)(message));
}

function act(link: Link, message: GameMessage): void {
  const { handlers } = link;
  switch (message.kind) {
    case 'welcome':
      // A later welcome has what changed, such as another ship.
      link.driver.happen({ kind: 'welcome' });
      if (link.driver.state().phase === 'live') handlers.onWelcome?.(asObject(message.about));
      break;
    case 'state':
      takeState(link, message.frame);
      break;
    case 'pong':
      link.driver.happen({ kind: 'pong' });
      break;
    case 'token':
      if (typeof message.token !== 'string')
        return handlers.onRefused?.('token_refresh.token: expected a string');
      link.held.token = message.token;
      handlers.onToken?.(message.token);
      break;
    case 'destroyed':
    case 'removed':
      takeGone(link, message);
      break;
    case 'other':
      handlers.onOther?.(message.type, message.message);
      break;
  }
}

function takeState(link: Link, sent: unknown): void {
  const { handlers, options, driver } = link;
  if (driver.state().phase !== 'live') return handlers.onRefused?.('state: came before the welcome');
  const known = options.bodies === undefined ? {} : { bodies: options.bodies };
  const frame = decodeFrameJson(sent, known);
  if (!frame.ok) return handlers.onRefused?.(`state.${frame.reason}`);
  const { tickRate } = frame.value;
  driver.stateReceived(tickRate === undefined ? undefined : 1 / tickRate);
  handlers.onFrame(frame.value, options.clock.now());
}

function takeGone(link: Link, message: GameMessage & { kind: 'destroyed' | 'removed' }): void {
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
