import { type Result, err } from '../../dynamics';
import { MAX_SHIPS } from '../limits';
import {
  beginReading,
  describe,
  endReading,
  type Fields,
  fieldsOf,
  listIn,
  refuse,
  refuseRepeats,
  valueIn,
} from '../fields/reading';
import type { ShipState } from '../records';
import { readShipState, shipStateFields } from '../fields/shipState';

/** A ShipState for JSON.stringify, under the game's names; vectors {x, y, z}, quaternions {w, x, y, z}. */
export type ShipStateJson = Readonly<Record<string, unknown>>;

/**
 * A ShipState from the game's browser socket: a parsed JSON object, names in snake_case or camelCase, values as
 * JSON values or strings, as in Redis, vectors {x, y, z} or [x, y, z], quaternions {w, x, y, z} or [w, x, y, z]. Required are ship_id, position, velocity, attitude,
 * angular_velocity and fuel; the others count as not sent when they are absent or null, with the same meaning as in
 * protobuf. Refused with the path of the first invalid field, below `path`. Never throws on a parsed JSON value.
 */
export function decodeShipStateJson(value: unknown, path = 'ship'): Result<ShipState> {
  const r = beginReading('json', path);
  return endReading(r, readShipState(r, fieldsOf(r, value)));
}

/**
 * Several ShipStates: a list, or an object by ship_id, whose states may omit ship_id. One invalid state refuses all. The game's
 * envelope around its states is not published: pass its contents.
 */
export function decodeShipStatesJson(value: unknown, path = 'ships'): Result<ShipState[]> {
  const r = beginReading('json');
  const list = Array.isArray(value) ? value : statesById(value, path);
  if (typeof list === 'string') return err(list);
  const states = listIn(r, { [path]: list }, path, MAX_SHIPS, readShipState);
  refuseRepeats(
    r,
    path,
    'ship_id',
    states.map(({ shipId }) => shipId),
  );
  return endReading(r, states);
}

export function encodeShipStateJson(state: ShipState): ShipStateJson {
  return { ...shipStateFields(state) };
}

/**
 * The states of an object by ship_id, each with its ship_id; or why there are none. Paths number them, since an id from
 * outside may be of any length.
 */
function statesById(value: unknown, path: string): Fields[] | string {
  const r = beginReading('json', path);
  const states = Object.entries(fieldsOf(r, value)).map(([shipId, state], i): Fields => {
    r.path.push(i);
    const fields = fieldsOf(r, state);
    const own = valueIn(r, fields, 'ship_id') ?? shipId;
    if (own !== shipId) refuse(r, 'ship_id', `expected ${describe(shipId)}, got ${describe(own)}`);
    r.path.pop();
    return { ...fields, ship_id: own };
  });
  return r.reason ?? states;
}
