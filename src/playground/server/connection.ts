import type { RunInput } from '../../scenarios';
import { scriptUrl } from '../scriptUrl';
import type { Operation } from './operation';
import type { SessionStatus } from './session';

/**
 * The page's side of a server: the one in the worker, or a real one at ws://… (`?server=`). The page needs this file alone:
 *
 *   const connection = openWorker(program, handlers)          // then connection.operate({ kind: 'load', … })
 *   const connection = openSocket('ws://…', handlers)
 *   connection.send(encodeClientMessage(message))
 *
 * Nothing throws; what fails is told to `onClosed` or `onRefused`.
 */
export interface Connection {
  /** Bytes of the protocol to the server; dropped while closed. */
  readonly send: (bytes: Uint8Array) => void;
  /** Asks the operator of the worker's server; a real server has none, which onRefused says. */
  readonly operate: (operation: Operation) => void;
  /** After onClosed: tries again. The worker's server: after { kind: 'drop' }. */
  readonly reconnect: () => void;
  /** Slow motion: the worker's wall clock runs at this speed from now on; a real server's cannot be changed. */
  readonly setSpeed: (speed: number) => void;
  /** Ends it for good. */
  readonly dispose: () => void;
}

export interface ConnectionHandlers {
  /** A connection stands: after a load of a new world, or a reconnect. What it carries comes after this. */
  readonly onOpen: (what: 'world' | 'again') => void;
  /** Bytes of the protocol from the server. */
  readonly onBytes: (bytes: Uint8Array) => void;
  readonly onClosed: (reason: string) => void;
  /** An operation was refused. */
  readonly onRefused: (reason: string) => void;
  /** How the worker's server stands, after everything that happened in it; a real server tells nothing. */
  readonly onStatus: (status: SessionStatus) => void;
  /** The inputs that { kind: 'run' } asked for. */
  readonly onRun: (inputs: readonly RunInput[]) => void;
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
  | { readonly kind: 'status'; readonly status: SessionStatus }
  | { readonly kind: 'run'; readonly inputs: readonly RunInput[] };

/** The server in a Web Worker, whose `program` is the page's own main.ts: it has no world before it is told to load one. */
export function openWorker(program: string, handlers: ConnectionHandlers): Connection {
  const failed = (why: string) =>
    handlers.onClosed(
      `the built-in server failed (${why}); reload the page, or use a browser that runs module workers`,
    );
  const worker = startWorker(program, failed);
  const post = (message: ToServer) => worker?.postMessage(message);
  if (worker !== null) {
    worker.onmessage = ({ data }: MessageEvent<FromServer>) => dispatch(data, handlers);
    // A program that could not be fetched or read is told without a message.
    worker.onerror = ({ message }: Partial<ErrorEvent>) => failed(message ?? 'its program cannot be started');
  }
  return {
    send: (bytes) => post({ kind: 'bytes', bytes }),
    operate: (operation) => post({ kind: 'operate', operation }),
    reconnect: () => post({ kind: 'operate', operation: { kind: 'reconnect' } }),
    setSpeed: (speed) => post({ kind: 'speed', speed }),
    dispose: () => worker?.terminate(),
  };
}

function startWorker(program: string, failed: (why: string) => void): Worker | null {
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
      handlers.onBytes(message.bytes);
      break;
    case 'closed':
      handlers.onClosed(message.reason);
      break;
    case 'refused':
      handlers.onRefused(message.reason);
      break;
    case 'status':
      handlers.onStatus(message.status);
      break;
    case 'run':
      handlers.onRun(message.inputs);
      break;
  }
}

/** A real server. An address that is none is told like a connection that failed. */
export function openSocket(address: string, handlers: ConnectionHandlers): Connection {
  let socket: WebSocket | null = null;
  let opened = false;

  function connect(): void {
    try {
      socket = new WebSocket(address);
    } catch (error) {
      handlers.onClosed(`${address}: ${error instanceof Error ? error.message : String(error)}`);
      return;
    }
    const own = socket;
    own.binaryType = 'arraybuffer';
    own.onopen = () => {
      handlers.onOpen(opened ? 'again' : 'world');
      opened = true;
    };
    own.onmessage = ({ data }: MessageEvent<unknown>) => {
      if (data instanceof ArrayBuffer) handlers.onBytes(new Uint8Array(data));
      else handlers.onRefused(`${address} sent text; the protocol is bytes`);
    };
    own.onclose = ({ code, reason }) => {
      if (socket !== own) return;
      handlers.onClosed(`${address}: ${reason === '' ? `closed with code ${code}` : reason}`);
    };
  }

  connect();
  return {
    send(bytes) {
      if (socket?.readyState === WebSocket.OPEN) socket.send(new Uint8Array(bytes));
    },
    operate: ({ kind }) => handlers.onRefused(`${kind}: only available with the built-in server`),
    reconnect: connect,
    setSpeed(speed) {
      if (speed !== 1) handlers.onRefused('slow motion: only available with the built-in server');
    },
    dispose() {
      const old = socket;
      socket = null;
      old?.close();
    },
  };
}
