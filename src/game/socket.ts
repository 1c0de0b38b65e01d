/** The part of a browser's WebSocket that is used. */
export interface GameSocket {
  /** Called when the socket is open. */
  onopen: ((event: never) => void) | null;
  /** Called with each message. */
  onmessage: ((event: never) => void) | null;
  /** Called once, when the socket has closed. */
  onclose: ((event: never) => void) | null;
  /** Called on an error; a close follows. */
  onerror: ((event: never) => void) | null;
  readonly readyState: number;
  /** Sends a text, or bytes. */
  send: (message: string | Uint8Array<ArrayBuffer>) => void;
  /** Closes the socket. */
  close: () => void;
}

/** Largest message either way, bytes of UTF-8 (GAME.md, Protocol). */
export const MAX_MESSAGE = 64 * 1024;
/** readyState of a socket that takes messages. */
export const OPEN = 1;

/** UTF-8 takes one to three bytes per UTF-16 unit: only lengths in between are counted. */
export function isTooLarge(text: string): boolean {
  if (text.length * 3 <= MAX_MESSAGE) return false;
  return text.length > MAX_MESSAGE || new TextEncoder().encode(text).length > MAX_MESSAGE;
}

/** Detaches from the socket: later messages and events are ignored. Its `onerror` stays: a socket closed before it opens reports an error. */
export function abandon(socket: GameSocket): void {
  socket.onopen = socket.onmessage = socket.onclose = null;
  socket.close();
}
