import type { Body, BodyMotion, Controls } from '../dynamics';
import type { DecodedFrame } from '../wire';
import type { GameMessage } from './envelope';
import type { GameSocket } from './socket';
import type { LinkStatus } from './words';

/** Wall seconds and a timer, so that tests need not wait. */
export interface GameClock {
  /** Wall seconds, monotonic. */
  readonly now: () => number;
  /** Calls `act` once after `seconds`; returns how to call it off. */
  readonly after: (seconds: number, act: () => void) => () => void;
}

/** What the connection tells; only onFrame has to be there. */
export interface GameHandlers {
  /** A state came, checked; `at`: wall s. */
  readonly onFrame: (frame: DecodedFrame, at: number) => void;
  /** The player is in: what the welcome tells, unchecked. Every later frame is of this connection. */
  readonly onWelcome?: (about: Readonly<Record<string, unknown>>) => void;
  /** How the link stands, whenever that changes. */
  readonly onStatus?: (status: LinkStatus) => void;
  /** A ship is gone for good; `own`: what its owner is told of it. */
  readonly onShipGone?: (
    shipId: string,
    own: { readonly name: string; readonly body: string; readonly reason: string } | null,
  ) => void;
  /** The server gave a new token; it is used from the next connection on. */
  readonly onToken?: (token: string) => void;
  /** A message that could not be used, and why. */
  readonly onRefused?: (reason: string) => void;
  /** A message of another type, as it came. */
  readonly onOther?: (type: string, message: unknown) => void;
}

/** What a connection is made with. */
export interface GameConnectionOptions {
  /** wss://…/ws */
  readonly address: string;
  /** The JWT of POST /api/auth/login. */
  readonly token: string;
  readonly clock: GameClock;
  /** 0 to 1, for the jitter of reconnects. */
  readonly dice: () => number;
  /** Opens a socket: (address) => new WebSocket(address). */
  readonly openSocket: (address: string) => GameSocket;
  /** What a parsed message comes to; openGameMessage unless given. */
  readonly open?: (message: unknown) => GameMessage;
  /** The message that carries controls; packControls unless given. */
  readonly pack?: (controls: Controls) => unknown;
  /** Fill in bodies that tell no attitude or spin, by name. */
  readonly bodies?: readonly (Body & BodyMotion)[];
}

/** Throws RangeError, naming the option or the handler, where one cannot be used. */
export function requireConnection(options: GameConnectionOptions, handlers: GameHandlers): void {
  const given = (options as GameConnectionOptions | undefined) ?? ({} as Partial<GameConnectionOptions>);
  const { address, token, clock } = given;
  if (typeof address !== 'string' || !/^wss?:\/\//.test(address))
    throw new RangeError(`options.address: expected ws://… or wss://…, got ${String(address)}`);
  if (typeof token !== 'string' || token === '')
    throw new RangeError(`options.token: expected the token of the login, got ${JSON.stringify(token)}`);
  const told = (handlers as GameHandlers | undefined) ?? ({} as Partial<GameHandlers>);
  const functions = {
    ...{ 'options.clock.now': clock?.now, 'options.clock.after': clock?.after },
    ...{
      'options.dice': given.dice,
      'options.openSocket': given.openSocket,
      'handlers.onFrame': told.onFrame,
    },
  };
  for (const [name, value] of Object.entries(functions))
    if (typeof value !== 'function')
      throw new RangeError(`${name}: expected a function, got ${String(value)}`);
}
