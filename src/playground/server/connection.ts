import type { RunInput } from '../../scenarios';
import {
  type ClientMessage,
  encodeClientMessage,
  type PartialFrame,
  type PendingMessage,
  pendingServerMessage,
} from '../../wire';
import { scriptUrl } from '../scriptUrl';
import type { Operation } from './operation';

/**
 * The page's side of a server: the one in the worker, or a real one (realServer.ts, `?server=`).
 *
 *   const connection = openWorker(program, handlers)          // then connection.operate({ kind: 'load', … })
 *   const connection = openServer('wss://…', handlers)
 *
 * Nothing throws; failures are reported to the handlers.
 */
export interface Connection {
  /** To the server; dropped while closed. */
  readonly send: (message: ClientMessage) => void;
  /** A command for the worker's server; a real server takes none, which onRefused reports. */
  readonly operate: (operation: Operation) => void;
  /** Tries again at once; an open connection stays. The worker's server: after { kind: 'drop' }. */
  readonly reconnect: () => void;
  /** Slow motion: the worker's wall clock runs at this speed from now on; a real server's cannot be changed. */
  readonly setSpeed: (speed: number) => void;
  /** Closes it for good. */
  readonly dispose: () => void;
}

export interface ConnectionHandlers {
  /** A connection is open: after loading a new world, or a reconnect. Its messages come after this. */
  readonly onOpen: (what: 'world' | 'again') => void;
  /** A message of the server, not decoded yet: a frame that a newer one supersedes need not be. `bytes`: exactly these. */
  readonly onPending: (message: PendingMessage, bytes?: Uint8Array) => void;
  /** A checked frame of a server that speaks JSON. */
  readonly onFrame: (frame: PartialFrame) => void;
  /** The worker's server has gone. */
  readonly onClosed: (reason: string) => void;
  /** Status of the link to a real server, in words; '' while it works. */
  readonly onLink: (words: string) => void;
  /** The game's server has signed the player in; its data about the player, unchecked. */
  readonly onWelcome: (about: Readonly<Record<string, unknown>>) => void;
  /** A ship is gone for good; `own`: the details sent to its owner. */
  readonly onShipGone: (shipId: string, own: ShipLoss | null) => void;
  /** An operation was refused. */
  readonly onRefused: (reason: string) => void;
  /** The inputs requested by { kind: 'run' }. */
  readonly onRun: (inputs: readonly RunInput[]) => void;
  /** The host of a shared world has begun a scenario. */
  readonly onScenario?: (scenario: string, terrain: string) => void;
}

export interface ShipLoss {
  readonly name: string;
  readonly body: string;
  readonly reason: string;
}

/** Page → worker. */
export type ToServer =
  | { readonly kind: 'bytes'; readonly bytes: Uint8Array }
  | { readonly kind: 'operate'; readonly operation: Operation }
  | { readonly kind: 'speed'; readonly speed: number };

/** Worker → page. */
export type FromServer =
  | { readonly kind: 'open'; readonly what: 'world' | 'again' }
  | { readonly kind: 'bytes'; readonly bytes: Uint8Array }
  | { readonly kind: 'closed'; readonly reason: string }
  | { readonly kind: 'refused'; readonly reason: string }
  | { readonly kind: 'run'; readonly inputs: readonly RunInput[] };

/**
 * The server in a Web Worker. Its `program` is the page's own main.ts. It has no world before it loads one.
 * @param begun a worker that was started in this task; null: one is started
 */
export function openWorker(
  program: string,
  handlers: ConnectionHandlers,
  begun: Worker | null = null,
): Connection {
  const failed = (why: string) =>
    handlers.onClosed(
      `the built-in server failed (${why}); reload the page, or use a browser that runs module workers`,
    );
  const worker = begun ?? startWorker(program, failed);
  const post = (message: ToServer) => worker?.postMessage(message);
  if (worker !== null) {
    worker.onmessage = ({ data }: MessageEvent<FromServer>) => dispatch(data, handlers);
    // The error of a program that could not be loaded has no message.
    worker.onerror = ({ message }: Partial<ErrorEvent>) => failed(message ?? 'its program cannot be started');
  }
  return {
    send: (message) => post({ kind: 'bytes', bytes: encodeClientMessage(message) }),
    operate: (operation) => post({ kind: 'operate', operation }),
    reconnect: () => post({ kind: 'operate', operation: { kind: 'reconnect' } }),
    setSpeed: (speed) => post({ kind: 'speed', speed }),
    dispose: () => worker?.terminate(),
  };
}

/** Starts the server's program; null, with the reason to `failed`, where the browser does not. */
export function startWorker(program: string, failed: (why: string) => void): Worker | null {
  try {
    return new Worker(scriptUrl(program), { type: 'module' });
  } catch (error) {
    failed(error instanceof Error ? error.message : String(error));
    return null;
  }
}

function dispatch(message: FromServer, handlers: ConnectionHandlers): void {
  switch (message.kind) {
    case 'open':
      handlers.onOpen(message.what);
      break;
    case 'bytes':
      handlers.onPending(pendingServerMessage(message.bytes), message.bytes);
      break;
    case 'closed':
      handlers.onClosed(message.reason);
      break;
    case 'refused':
      handlers.onRefused(message.reason);
      break;
    case 'run':
      handlers.onRun(message.inputs);
      break;
  }
}
