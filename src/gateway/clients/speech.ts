import { type Controls } from '../../dynamics';
import {
  decodeClientMessage,
  decodeControlsJson,
  encodeHelloJson,
  encodeServerMessage,
  type Hello,
  type InputRecord,
} from '../../wire';

/** What a client said, once its message was checked; or why it cannot be used. */
export type Said =
  | { readonly kind: 'auth'; readonly token: string; readonly session: string; readonly since: number | null }
  | { readonly kind: 'control'; readonly controls: Controls }
  | { readonly kind: 'inputs'; readonly inputs: readonly InputRecord[] }
  | { readonly kind: 'ping'; readonly id: number | null }
  | { readonly kind: 'refused'; readonly reason: string };

const SESSION = /^[\w-]{1,48}$/;

/** A text message: the game's JSON; on /stream the sign-in alone. */
export function readText(text: string): Said {
  let message: unknown;
  try {
    message = JSON.parse(text);
  } catch {
    return refused('message: not JSON');
  }
  if (typeof message !== 'object' || message === null || Array.isArray(message))
    return refused('message: expected an object');
  const fields = message as Readonly<Record<string, unknown>>;
  switch (fields['type']) {
    case 'auth':
      return readAuth(fields);
    case 'ping':
      return { kind: 'ping', id: null };
    case 'control': {
      const controls = decodeControlsJson(fields['controls'] ?? fields, 'control');
      return controls.ok ? { kind: 'control', controls: controls.value } : refused(controls.reason);
    }
    default:
      return refused('type: expected auth, control or ping');
  }
}

/** A binary message of /stream. */
export function readBytes(bytes: Uint8Array): Said {
  const message = decodeClientMessage(bytes);
  if (!message.ok) return refused(message.reason);
  return message.value.kind === 'ping'
    ? { kind: 'ping', id: message.value.id }
    : { kind: 'inputs', inputs: message.value.inputs };
}

/** `session` (a page load) and `since` (the last tick it was told) are this project's: the game's clients send neither. */
function readAuth({ token, session, since }: Readonly<Record<string, unknown>>): Said {
  if (typeof token !== 'string' || token === '') return refused('auth.token: expected a string');
  return {
    kind: 'auth',
    token,
    session: typeof session === 'string' && SESSION.test(session) ? session : '',
    since: Number.isSafeInteger(since) && (since as number) >= 0 ? (since as number) : null,
  };
}

function refused(reason: string): Said {
  return { kind: 'refused', reason };
}

export function welcomeText(hello: Hello, username: string): string {
  return JSON.stringify({ type: 'welcome', username, ...encodeHelloJson(hello) });
}

export function helloBytes(hello: Hello): Uint8Array {
  return encodeServerMessage(hello);
}

export function pongBytes(id: number, tick: number, sinceTick: number): Uint8Array {
  return encodeServerMessage({ kind: 'pong', id, tick, sinceTick });
}

/** The game's error, as its REST API has it. */
export function errorText(code: string, message: string): string {
  return JSON.stringify({ type: 'error', error: { code, message } });
}
