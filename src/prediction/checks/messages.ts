import type { BodyState, PartialFrame, ServerMessage, ShipState } from '../../wire';
import type { Warn } from '../warnings';
import { checkBodies } from './bodies';
import { nearestName, warnOfUnknown } from './names';
import { checkSettings } from './options';
import { checkShip } from './ships';

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

/** Warns of a message that is none: not decoded, still in its Result, of a misspelt kind. Returns whether it may be one. */
export function checkKind(warn: Warn, message: unknown): boolean {
  if (typeof message === 'string' || ArrayBuffer.isView(message) || message instanceof ArrayBuffer) {
    const text =
      'receive was given what the socket gave: decode it first (decodeFrameJson, decodeServerMessage).';
    warn('message-not-decoded', text, { value: message });
    return false;
  }
  if (typeof message !== 'object' || message === null) return false;
  const { kind, ok, value } = message as { kind?: unknown; ok?: unknown; value?: unknown };
  if (kind === undefined && typeof ok === 'boolean') {
    warn('message-in-result', 'receive was given a Result: look at .ok, then hand in .value.', { ok, value });
    return false;
  }
  if (KINDS.includes(kind as string)) return true;
  const nearest = nearestName(String(kind), KINDS);
  const hint = nearest === '' ? 'hello, frame or pong is expected' : `did you mean ${nearest}?`;
  warn('message-kind', `A message is of kind ${String(kind)}: ${hint}.`, { kind, nearest });
  return false;
}

/** Warns of what in a message nobody reads, or cannot be. `bodies`: the world's, where the frame tells none. */
export function checkMessage(
  warn: Warn,
  message: ServerMessage | PartialFrame,
  bodies: readonly BodyState[],
): void {
  if (message.kind === 'hello') {
    checkSettings(warn, 'hello.settings', message.settings);
    if (Array.isArray(message.bodies)) checkBodies(warn, message.bodies);
    return;
  }
  if (message.kind !== 'frame') return;
  warnOfUnknown(warn, FRAME, message);
  const told = Array.isArray(message.bodies) ? message.bodies : [];
  checkBodies(warn, told);
  const ships: unknown = message.ships;
  if (!Array.isArray(ships)) {
    warn('ships-missing', 'frame.ships: expected a list of ship states, empty where there are none.', {
      value: ships,
    });
    return;
  }
  for (const ship of ships as readonly ShipState[]) {
    if (isSnake(ship)) {
      const text =
        'A ship has ship_id: its state is as the socket has it. Decode the frame with decodeFrameJson.';
      warn('ship-not-decoded', text, { value: ship });
    } else if (isWhole(ship)) checkShip(warn, ship, told.length > 0 ? told : bodies);
  }
}

function isSnake(ship: unknown): boolean {
  return typeof ship === 'object' && ship !== null && 'ship_id' in ship;
}

/** Malformed ones are told of where they are refused. */
function isWhole(ship: ShipState | null): boolean {
  const lists: unknown[] = [ship?.position, ship?.velocity, ship?.attitude, ship?.angularVelocity];
  return lists.every((list) => Array.isArray(list) && list.every(Number.isFinite));
}
