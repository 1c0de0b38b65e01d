import { type Controls } from '../../dynamics';
import {
  decodeClientMessage,
  decodeControlsJson,
  encodeHelloJson,
  encodeServerMessage,
  type Hello,
  type InputRecord,
} from '../../wire';

/** A client's message after its checks, or the reason why it is refused. */
export type ClientMessage =
  | { readonly kind: 'auth'; readonly token: string; readonly session: string; readonly since: number | null }
  /** Only the members that the message contains; the others stay unchanged. */
  | { readonly kind: 'control'; readonly controls: Partial<Controls> }
  | { readonly kind: 'inputs'; readonly inputs: readonly InputRecord[] }
  | { readonly kind: 'ping'; readonly id: number | null }
  | { readonly kind: 'refused'; readonly reason: string };

const SESSION = /^[\w-]{1,48}$/;

/** Reads a text message: the game's JSON on /ws, the sign-in on /stream. */
export function readText(text: string): ClientMessage {
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
    case 'control':
      return readControl(fields);
    default:
      return refused('type: expected auth, control or ping');
  }
}

/** Reads a binary message of /stream. */
export function readBytes(bytes: Uint8Array): ClientMessage {
  const message = decodeClientMessage(bytes);
  if (!message.ok) return refused(message.reason);
  return message.value.kind === 'ping'
    ? { kind: 'ping', id: message.value.id }
    : { kind: 'inputs', inputs: message.value.inputs };
}

/** Names under which a control message may wrap its content; the game does not publish its members. */
const WRAPPERS = ['controls', 'data', 'payload'];

function readControl(fields: Readonly<Record<string, unknown>>): ClientMessage {
  const wrapped = WRAPPERS.map((name) => fields[name]).find(
    (value) => typeof value === 'object' && value !== null,
  );
  const given = (wrapped ?? fields) as Readonly<Record<string, unknown>>;
  const decoded = decodeControlsJson(given, 'control');
  if (!decoded.ok) return refused(decoded.reason);
  const controls = Object.fromEntries(
    Object.entries(decoded.value).filter(([name]) => name in given || snakeCase(name) in given),
  ) as Partial<Controls>;
  return Object.keys(controls).length === 0
    ? refused(`control: expected one of ${Object.keys(decoded.value).map(snakeCase).join(', ')}`)
    : { kind: 'control', controls };
}

function snakeCase(name: string): string {
  return name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

/** `session` (one per page load) and `since` (the last tick received) are extensions; the game's clients send neither. */
function readAuth({ token, session, since }: Readonly<Record<string, unknown>>): ClientMessage {
  if (typeof token !== 'string' || token === '') return refused('auth.token: expected a string');
  return {
    kind: 'auth',
    token,
    session: typeof session === 'string' && SESSION.test(session) ? session : '',
    since: Number.isSafeInteger(since) && (since as number) >= 0 ? (since as number) : null,
  };
}

function refused(reason: string): ClientMessage {
  return { kind: 'refused', reason };
}

/** The game's welcome: player, ship and world. */
export function welcomeText(hello: Hello, username: string): string {
  return JSON.stringify({ type: 'welcome', username, ...encodeHelloJson(hello) });
}

export function helloBytes(hello: Hello): Uint8Array {
  return encodeServerMessage(hello);
}

export function pongBytes(id: number, tick: number, sinceTick: number): Uint8Array {
  return encodeServerMessage({ kind: 'pong', id, tick, sinceTick });
}

/** The game's error message, in the format of its REST API. */
export function errorText(code: string, message: string): string {
  return JSON.stringify({ type: 'error', error: { code, message } });
}
