import { type Body, type BodyMotion, type Controls, requireKnown } from '../dynamics';
import type { DecodedFrame } from '../wire';
import type { GameMessage } from './envelope';
import type { GameSocket } from './socket';
import type { LinkStatus } from './statusText';

/** Wall seconds and a timer, so that tests need not wait. */
export interface GameClock {
  /** Wall seconds, monotonic. */
  readonly now: () => number;
  /** Calls `act` once after `seconds`; returns a function that cancels it. */
  readonly after: (seconds: number, act: () => void) => () => void;
}

/** The connection's handlers; only onFrame is required. */
export interface GameHandlers {
  /** A checked state arrived; `at`: wall s. */
  readonly onFrame: (frame: DecodedFrame, at: number) => void;
  /** The player is signed in: the content of the welcome, unchecked. Every later frame is of this connection. */
  readonly onWelcome?: (about: Readonly<Record<string, unknown>>) => void;
  /** The link's status, whenever it changes. */
  readonly onStatus?: (status: LinkStatus) => void;
  /** A ship is gone for good; `own`: the details that its owner is sent. */
  readonly onShipGone?: (
    shipId: string,
    own: { readonly name: string; readonly body: string; readonly reason: string } | null,
  ) => void;
  /** The server sent a new token; it is used from the next connection on. */
  readonly onToken?: (token: string) => void;
  /** A message that was refused, and why. */
  readonly onRefused?: (reason: string) => void;
  /** A message of another type, unchecked. */
  readonly onOther?: (type: string, message: unknown) => void;
}

/** Options of a connection. */
export interface GameConnectionOptions {
  /** wss://…/ws */
  readonly address: string;
  /** The JWT of POST /api/auth/login. */
  readonly token: string;
  readonly clock: GameClock;
  /** 0 to 1, for the jitter of reconnects. */
  readonly jitter: () => number;
  /** Opens a socket: (address) => new WebSocket(address). */
  readonly openSocket: (address: string) => GameSocket;
  /** Reads a parsed message; openGameMessage by default. */
  readonly open?: (message: unknown) => GameMessage;
  /** Builds the message with the controls; packControls by default. */
  readonly pack?: (controls: Controls) => unknown;
  /** Bodies that complete, by name, those sent without attitude or spin. */
  readonly bodies?: readonly (Body & BodyMotion)[];
}

const OPTIONS = [
  'address',
  'token',
  'clock',
  'jitter',
  'openSocket',
  'open',
  'pack',
  'bodies',
] satisfies readonly (keyof GameConnectionOptions)[];
const HANDLERS = [
  'onFrame',
  'onWelcome',
  'onStatus',
  'onShipGone',
  'onToken',
  'onRefused',
  'onOther',
] satisfies readonly (keyof GameHandlers)[];
/** s: no monotonic clock has run for 30 years; Unix time has. */
const UNIX_TIME = 1e9;

function requireObject(path: string, given: unknown, members = ''): void {
  if (typeof given !== 'object' || given === null)
    throw new RangeError(`${path}: expected an object${members}, got ${String(given)}`);
}

/** Of the members that are given. */
function requireFunctions(path: string, names: readonly string[], given: object): void {
  for (const name of names) {
    const value = (given as Readonly<Record<string, unknown>>)[name];
    if (value !== undefined && typeof value !== 'function')
      throw new RangeError(`${path}.${name}: expected a function, got ${typeof value}`);
  }
}

function requireBodies(bodies: unknown): void {
  const isNamed = (body: unknown) => typeof (body as { name?: unknown } | null)?.name === 'string';
  if (bodies !== undefined && !(Array.isArray(bodies) && bodies.every(isNamed)))
    throw new RangeError(`options.bodies: expected a list of bodies with names, as BODIES is`);
}

/** Throws RangeError that names the invalid option or handler. */
export function requireConnection(options: GameConnectionOptions, handlers: GameHandlers): void {
  requireObject('options', options);
  requireObject('handlers', handlers, ' with onFrame');
  const given: Partial<GameConnectionOptions> = options;
  const { address, token, clock } = given;
  if (typeof address !== 'string' || !/^wss?:\/\//.test(address))
    throw new RangeError(`options.address: expected ws://… or wss://…, got ${String(address)}`);
  if (typeof token !== 'string' || token === '')
    throw new RangeError(`options.token: expected the token of the login, got ${JSON.stringify(token)}`);
  if (/\s/.test(token))
    throw new RangeError(`options.token: expected the token alone, without "Bearer" or spaces`);
  const functions = {
    'options.clock.now': clock?.now,
    'options.clock.after': clock?.after,
    'options.jitter': given.jitter,
    'options.openSocket': given.openSocket,
    'handlers.onFrame': handlers.onFrame,
  };
  for (const [name, value] of Object.entries(functions))
    if (typeof value !== 'function')
      throw new RangeError(`${name}: expected a function, got ${String(value)}`);
  requireKnown('options', OPTIONS, given);
  requireKnown('handlers', HANDLERS, handlers);
  requireFunctions('options', ['open', 'pack'], given);
  requireFunctions('handlers', HANDLERS, handlers);
  requireBodies(given.bodies);
  if ('CONNECTING' in (given.openSocket as unknown as object))
    throw new RangeError(
      'options.openSocket: expected a function, (address) => new WebSocket(address), got the class itself',
    );
  const now = (clock as GameClock).now();
  if (!(now < UNIX_TIME))
    throw new RangeError(
      `options.clock.now: expected monotonic seconds, () => performance.now() / 1000, got ${String(now)}`,
    );
}
