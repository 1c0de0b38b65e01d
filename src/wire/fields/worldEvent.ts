import type { galaxy } from '../generated/codec.js';
import { MAX_SUBSTEPS, MAX_TICK } from '../limits';
import { type Fields, flagIn, integerIn, nameIn, type Reading, textIn, valueIn } from './reading';
import type { WorldEvent } from '../records';

/**
 * An event of the interval that ended at `frameTick`. JSON may call its type `event`, as Redis does, and may leave out
 * the tick (then the frame's own interval) and the substep.
 */
export function readEvent(r: Reading, from: Fields, frameTick: number): WorldEvent {
  const isRedis = valueIn(r, from, 'type') === undefined && valueIn(r, from, 'event') !== undefined;
  const isOfFrame = r.source === 'json' && valueIn(r, from, 'tick') === undefined;
  const playerId = textIn(r, from, 'player_id');
  const body = textIn(r, from, 'body');
  const reason = textIn(r, from, 'reason');
  return {
    type: nameIn(r, from, isRedis ? 'event' : 'type'),
    shipId: nameIn(r, from, 'ship_id'),
    tick: isOfFrame ? Math.max(0, frameTick - 1) : integerIn(r, from, 'tick', 0, MAX_TICK),
    substep:
      valueIn(r, from, 'substep') === undefined ? null : integerIn(r, from, 'substep', 0, MAX_SUBSTEPS - 1),
    ...(flagIn(r, from, 'again') && { again: true }),
    ...(playerId !== '' && { playerId }),
    ...(body !== '' && { body }),
    ...(reason !== '' && { reason }),
  };
}

/** Absent members are omitted. */
export function eventFields(event: WorldEvent): galaxy.stream.Event.$Properties {
  const { type, shipId, tick, substep, again, playerId, body, reason } = event;
  return {
    type,
    ship_id: shipId,
    tick,
    ...(substep !== null && { substep }),
    ...(again === true && { again }),
    ...(playerId !== undefined && { player_id: playerId }),
    ...(body !== undefined && { body }),
    ...(reason !== undefined && { reason }),
  };
}
