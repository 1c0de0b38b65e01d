import { bodyStateFields, readBodyState } from '../fields/bodyState';
import type { galaxy } from '../generated/codec.js';
import { readTiming } from './hello';
import {
  GAME_SECONDS,
  MAX_BODIES,
  MAX_EVENTS,
  MAX_SHIPS,
  MAX_SUBSTEPS,
  MAX_TICK,
  WALL_SECONDS,
} from '../limits';
import {
  type Fields,
  flagIn,
  integerIn,
  listIn,
  messageIn,
  numberIn,
  type Reading,
  refuse,
  refuseRepeats,
  valueIn,
} from '../fields/reading';
import type { InputAcknowledgement, PartialFrame, ServerFrame } from '../records';
import { readShipState, shipStateFields } from '../fields/shipState';
import { eventFields, readEvent } from '../fields/worldEvent';

/** PREDICTION, Server messages: ServerFrame. */
export function readFrame(r: Reading, from: Fields): ServerFrame {
  const tick = integerIn(r, from, 'tick', 0, MAX_TICK);
  const frame: ServerFrame = {
    kind: 'frame',
    tick,
    ...readTiming(r, from),
    ...(valueIn(r, from, 'game_time') !== undefined && {
      gameTime: numberIn(r, from, 'game_time', GAME_SECONDS),
    }),
    paused: flagIn(r, from, 'paused'),
    bodies: listIn(r, from, 'bodies', MAX_BODIES, readBodyState),
    ships: listIn(r, from, 'ships', MAX_SHIPS, readShipState),
    events: listIn(r, from, 'events', MAX_EVENTS, (reading, event) => readEvent(reading, event, tick)),
    lastInput:
      valueIn(r, from, 'last_input') === undefined
        ? null
        : messageIn(r, from, 'last_input', (reading, value) => readAcknowledgement(reading, value, tick)),
  };
  const bodyNames = frame.bodies.map(({ name }) => name);
  const shipIds = frame.ships.map(({ shipId }) => shipId);
  refuseRepeats(r, 'bodies', 'name', bodyNames);
  refuseRepeats(r, 'ships', 'ship_id', shipIds);
  const ahead = frame.events.findIndex((event) => event.tick > tick);
  if (ahead >= 0) refuse(r, `events[${ahead}].tick`, `expected at most the frame's own, ${tick}`);
  return frame;
}

/** The last input applied before boundary `frameTick`: an input is acknowledged only after it has acted. */
export function readAcknowledgement(r: Reading, from: Fields, frameTick: number): InputAcknowledgement {
  return {
    seq: integerIn(r, from, 'seq', 1, Number.MAX_SAFE_INTEGER),
    tick: integerIn(r, from, 'tick', 0, frameTick),
    substep: integerIn(r, from, 'substep', 0, MAX_SUBSTEPS - 1),
    margin: numberIn(r, from, 'margin', WALL_SECONDS),
  };
}

/** Absent members are omitted. */
export function frameFields(frame: PartialFrame): galaxy.stream.ServerFrame.$Properties {
  const { tickRate, timeScale, gameTime, paused, bodies, events, lastInput } = frame;
  return {
    tick: frame.tick,
    ...(tickRate !== undefined && { tick_rate: tickRate }),
    ...(timeScale !== undefined && { time_scale: timeScale }),
    ...(gameTime !== undefined && { game_time: gameTime }),
    ...(paused !== undefined && { paused }),
    ...(bodies && { bodies: bodies.map(bodyStateFields) }),
    ships: frame.ships.map(shipStateFields),
    ...(events && { events: events.map(eventFields) }),
    ...(lastInput && { last_input: { ...lastInput } }),
  };
}
