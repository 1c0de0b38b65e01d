import type { PartialFrame, ServerMessage, ShipState } from '../../../wire';
import type { Warn } from '../../warnings';
import { checkBodies } from './bodies';
import { describe, kindOf } from '../describe';
import { nearestName, warnOfUnknown } from '../names';
import { checkSettings } from '../options';
import { checkShip, type KnownBody } from './ships';

const FRAME = {
  code: 'unknown-field',
  path: 'frame',
  known: [
    ...[
      'kind',
      'tick',
      'tickRate',
      'timeScale',
      'gameTime',
      'paused',
      'bodies',
      'ships',
      'events',
      'lastInput',
    ],
    // Of decodeFrameJson.
    'refusals',
  ],
};

const KINDS = ['hello', 'frame', 'pong'];

/** Warns of a message that is not decoded, still in its Result, or of a misspelt kind. Returns whether it may be valid. */
export function checkKind(warn: Warn, message: unknown): boolean {
  const undecoded = decodingHint(message);
  if (undecoded !== '') {
    warn('message-not-decoded', `receive was given ${describe(message)}: ${undecoded}.`, { value: message });
    return false;
  }
  if (typeof message !== 'object' || message === null) {
    warn(
      'message-kind',
      `receive was given ${describe(message)}, which has no kind: pass a decoded message.`,
      { message },
    );
    return false;
  }
  const { kind, ok, value } = message as { kind?: unknown; ok?: unknown; value?: unknown };
  if (kind === undefined && typeof ok === 'boolean') {
    warn('message-in-result', 'receive was given a Result: check .ok, then pass .value.', { ok, value });
    return false;
  }
  if (KINDS.includes(kind as string)) return true;
  const nearest = nearestName(describe(kind), KINDS);
  const hint = nearest === '' ? 'hello, frame or pong is expected' : `did you mean ${nearest}?`;
  const decode = kind === undefined ? ' A parsed JSON message goes through decodeFrameJson first.' : '';
  warn('message-kind', `A message is of kind ${describe(kind)}: ${hint}.${decode}`, { kind, nearest });
  return false;
}

/** What the caller must do before the message can be received; '' if it may be valid. */
function decodingHint(message: unknown): string {
  if (typeof message === 'string') return 'parse it with JSON.parse, then decode it with decodeFrameJson';
  if (typeof message !== 'object' || message === null) return '';
  if (ArrayBuffer.isView(message) || kindOf(message) === 'ArrayBuffer')
    return 'decode the bytes with decodeServerMessage';
  if (kindOf(message) === 'Blob') return 'set socket.binaryType to "arraybuffer", and decode the ArrayBuffer';
  if (kindOf(message) === 'Promise') return 'await it first';
  if ('data' in message && !('kind' in message)) return 'this is an event; decode its .data';
  return '';
}

/** Warns of unknown members and implausible values of a message. `bodies`: the world's, where the frame has none. */
export function checkMessage(
  warn: Warn,
  message: ServerMessage | PartialFrame,
  bodies: readonly KnownBody[],
): void {
  if (message.kind === 'hello') {
    checkSettings(warn, 'hello.settings', message.settings);
    if (Array.isArray(message.bodies)) checkBodies(warn, message.bodies);
    return;
  }
  if (message.kind !== 'frame') return;
  warnOfUnknown(warn, FRAME, message);
  const sentBodies = Array.isArray(message.bodies) ? message.bodies : [];
  checkBodies(warn, sentBodies);
  const ships: unknown = message.ships;
  if (!Array.isArray(ships)) {
    warn('ships-missing', 'frame.ships: expected a list of ship states, empty where there are none.', {
      value: ships,
    });
    return;
  }
  checkIds(warn, ships);
  for (const ship of ships as readonly ShipState[]) {
    if (isSnake(ship)) {
      const text = 'A ship has ship_id: its state is not decoded. Decode the frame with decodeFrameJson.';
      warn('ship-not-decoded', text, { value: ship });
    } else if (typeof ship !== 'object' || (ship as unknown) === null) {
      const text = `frame.ships: expected ship states, got ${describe(ship)}. It is left out.`;
      warn('ship-unusable', text, { value: ship });
    } else if (isWhole(ship)) checkShip(warn, ship, sentBodies.length > 0 ? sentBodies : bodies);
  }
}

function checkIds(warn: Warn, ships: readonly unknown[]): void {
  const seen = new Set<unknown>();
  for (const ship of ships) {
    const shipId = (ship as ShipState | null)?.shipId;
    if (shipId !== undefined && seen.has(shipId)) {
      const message = `frame.ships has ${describe(shipId)} twice: only one of the states is used. Send each ship once.`;
      warn('ship-twice', message, { shipId });
    }
    seen.add(shipId);
  }
}

function isSnake(ship: unknown): boolean {
  return typeof ship === 'object' && ship !== null && 'ship_id' in ship;
}

/** Whether a ship is well-formed; malformed ones are reported where they are refused. */
function isWhole(ship: ShipState | null): boolean {
  const lists: unknown[] = [ship?.position, ship?.velocity, ship?.attitude, ship?.angularVelocity];
  return lists.every((list) => Array.isArray(list) && list.every(Number.isFinite));
}
