import type { Controls } from '../dynamics';
import { encodeControlsJson } from '../wire';

/** The content of a message of the game's server, whatever its envelope. The parts are unchecked. */
export type GameMessage =
  /** The player is signed in; `about`: the welcome's data about player, ship and world. */
  | { readonly kind: 'welcome'; readonly about: unknown }
  /** `frame`: the object that holds tick and ships. */
  | { readonly kind: 'state'; readonly frame: unknown }
  | { readonly kind: 'pong' }
  | { readonly kind: 'token'; readonly token: unknown }
  | { readonly kind: 'destroyed'; readonly about: unknown }
  | { readonly kind: 'removed'; readonly about: unknown }
  /** A type that is not used here: player_joined, error, a future one. */
  | { readonly kind: 'other'; readonly type: string; readonly message: unknown };

/** Names under which a message may wrap its content. */
const WRAPPERS = ['data', 'payload', 'state'];

/**
 * The game publishes its messages' types, not their members: content is looked up in the message itself, then one level
 * down. Where the game differs, pass another function to createGameConnection.
 *
 * @example
 * ```ts
 * const opened = openGameMessage(JSON.parse(text));
 * if (opened.kind === 'state') console.log(decodeFrameJson(opened.frame).ok);
 * ```
 */
export function openGameMessage(message: unknown): GameMessage {
  const fields = asObject(message);
  const type = typeof fields['type'] === 'string' ? fields['type'] : '';
  switch (type) {
    case 'welcome':
      return { kind: 'welcome', about: contentWith(fields, ['player_id', 'playerId', 'ship_id', 'shipId']) };
    case 'state':
      return { kind: 'state', frame: contentWith(fields, ['tick', 'ships']) };
    case 'pong':
      return { kind: 'pong' };
    case 'token_refresh':
      return { kind: 'token', token: asObject(contentWith(fields, ['token']))['token'] };
    case 'ship.destroyed':
      return { kind: 'destroyed', about: contentWith(fields, ['ship_id', 'shipId']) };
    case 'ship.removed':
      return { kind: 'removed', about: contentWith(fields, ['ship_id', 'shipId']) };
    default:
      return { kind: 'other', type, message };
  }
}

/**
 * The message with own controls.
 *
 * @example
 * ```ts
 * socket.send(JSON.stringify(packControls(NEUTRAL_CONTROLS)));
 * ```
 */
export function packControls(controls: Controls): Readonly<Record<string, unknown>> {
  return { type: 'control', ...encodeControlsJson(controls) };
}

export function asObject(value: unknown): Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
}

function contentWith(fields: Readonly<Record<string, unknown>>, names: readonly string[]): unknown {
  const has = (object: Readonly<Record<string, unknown>>) =>
    names.some((name) => Object.hasOwn(object, name));
  if (has(fields)) return fields;
  const wrapped = WRAPPERS.map((name) => asObject(fields[name])).find(has);
  return wrapped ?? fields;
}
