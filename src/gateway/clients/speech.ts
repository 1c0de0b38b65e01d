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
  /** The members that the message has; the others stay as they are. */
  | { readonly kind: 'control'; readonly controls: Partial<Controls> }
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
    case 'control':
      return readControl(fields);
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

/** Names under which a control message may wrap its content: the game does not publish its members. */
const WRAPPERS = ['controls', 'data', 'payload'];

function readControl(fields: Readonly<Record<string, unknown>>): Said {
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
