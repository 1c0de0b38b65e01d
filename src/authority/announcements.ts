import { DEFAULT_SETTINGS, SHIP_STRIDE } from '../dynamics';
import { PROTOCOL_VERSION } from '../protocol';
import type { Hello, ServerFrame } from '../wire';
import type { Pilot } from './pilots/pilots';
import { granularityOf, type ServerState } from './serverState';
import { toBodyStates, toShipState } from './ships/shipState';

/** The world config that a pilot receives once, on joining. */
export function helloFor(server: ServerState, pilot: Pilot): Hello {
  const { options, bodies, world, tempo, tick } = server;
  return {
    kind: 'hello',
    protocolVersion: PROTOCOL_VERSION,
    playerId: pilot.playerId,
    shipId: pilot.shipId,
    settings: { ...DEFAULT_SETTINGS, ...options.settings },
    shipClasses: options.shipClasses,
    bodies: toBodyStates(bodies, world),
    terrain: options.terrain,
    tick,
    tickRate: tempo.tickRate(),
    timeScale: tempo.timeScale(),
    inputGranularity: granularityOf(options),
  };
}

/** The world at the present boundary for one pilot. */
export function frameFor(server: ServerState, pilot: Pilot): ServerFrame {
  server.frame ??= sharedFrame(server);
  return { ...server.frame, lastInput: server.options.legacy ? null : pilot.lastInput };
}

function sharedFrame(server: ServerState): Omit<ServerFrame, 'lastInput'> {
  const { options, ships, bodies, world, tempo, tick, events } = server;
  return {
    kind: 'frame',
    tick,
    tickRate: tempo.tickRate(),
    timeScale: tempo.timeScale(),
    paused: tempo.paused(),
    bodies: toBodyStates(bodies, world),
    ships: ships.entries.map(({ identity }, i) =>
      toShipState({ ships: ships.rows, at: i * SHIP_STRIDE, bodies, world }, identity, options.legacy),
    ),
    events,
  };
}
