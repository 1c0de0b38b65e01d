import { EVENT_NAMES, type ShipEventName } from '../dynamics';
import { bodyStateFields, readBodyState } from './bodyState';
import type { galaxy } from './generated/codec.js';
import { readTiming } from './hello';
import { MAX_BODIES, MAX_EVENTS, MAX_SHIPS, MAX_SUBSTEPS, WALL_SECONDS } from './limits';
import {
  choiceIn,
  type Fields,
  flagIn,
  integerIn,
  listIn,
  messageIn,
  nameIn,
  numberIn,
  type Reading,
  refuse,
  refuseRepeats,
  valueIn,
} from './reading';
import type { InputAcknowledgement, ServerFrame, WorldEvent } from './records';
import { readShipState, shipStateFields } from './shipState';

const [, ...SHIP_EVENTS] = EVENT_NAMES;
const LAST_TICK = Number.MAX_SAFE_INTEGER;

/** PREDICTION, What the server says: ServerFrame. */
export function readFrame(r: Reading, from: Fields): ServerFrame {
  const frame: ServerFrame = {
    kind: 'frame',
    tick: integerIn(r, from, 'tick', 0, LAST_TICK),
    ...readTiming(r, from),
    paused: flagIn(r, from, 'paused'),
    bodies: listIn(r, from, 'bodies', MAX_BODIES, readBodyState),
    ships: listIn(r, from, 'ships', MAX_SHIPS, readShipState),
    events: listIn(r, from, 'events', MAX_EVENTS, readEvent),
    lastInput:
      valueIn(from, 'last_input') === undefined
        ? null
        : messageIn(r, from, 'last_input', readAcknowledgement),
  };
  refuseRepeats(
    r,
    'bodies',
    'name',
    frame.bodies.map(({ name }) => name),
  );
  refuseRepeats(
    r,
    'ships',
    'ship_id',
    frame.ships.map(({ shipId }) => shipId),
  );
  const ahead = frame.events.findIndex(({ tick }) => tick > frame.tick);
  if (ahead >= 0) refuse(r, `events[${ahead}].tick`, `expected at most the frame's own, ${frame.tick}`);
  return frame;
}

function readEvent(r: Reading, from: Fields): WorldEvent {
  return {
    type: choiceIn<ShipEventName>(r, from, 'type', SHIP_EVENTS, false),
    shipId: nameIn(r, from, 'ship_id'),
    tick: integerIn(r, from, 'tick', 0, LAST_TICK),
    substep: integerIn(r, from, 'substep', 0, MAX_SUBSTEPS - 1),
  };
}

function readAcknowledgement(r: Reading, from: Fields): InputAcknowledgement {
  return {
    seq: integerIn(r, from, 'seq', 1, Number.MAX_SAFE_INTEGER),
    tick: integerIn(r, from, 'tick', 0, LAST_TICK),
    substep: integerIn(r, from, 'substep', 0, MAX_SUBSTEPS - 1),
    margin: numberIn(r, from, 'margin', WALL_SECONDS),
  };
}

export function frameFields(frame: ServerFrame): galaxy.stream.ServerFrame.$Properties {
  const { lastInput } = frame;
  return {
    tick: frame.tick,
    tick_rate: frame.tickRate,
    time_scale: frame.timeScale,
    paused: frame.paused,
    bodies: frame.bodies.map(bodyStateFields),
    ships: frame.ships.map(shipStateFields),
    events: frame.events.map(({ type, shipId, tick, substep }) => ({ type, ship_id: shipId, tick, substep })),
    ...(lastInput !== null && { last_input: { ...lastInput } }),
  };
}
