/** Snapshots that come in parts: in several messages, out of order, or with thousands of new ships. */
import type { ServerFrame, ShipState } from '../../wire';
import type { Simulation } from '../simulation/simulation';
import { boundaryAt, knowsBoundary } from './bodies/bodyTrack';
import type { Receiver } from './receiver';
import type { SnapshotContext } from './snapshotContext';
import { reconcileShip } from './reconcile/reconcileStates';

/** New ships that one call takes. */
const MAX_NEW = 1000;

/**
 * Takes the ships of a frame, but of new ones no more than MAX_NEW: the rest follow in the next calls of `advance`, so that no call
 * blocks for long.
 */
export function takeShips(sim: Simulation, receiver: Receiver, frame: ServerFrame): void {
  receiver.rest = null;
  let added = 0;
  const rest: ShipState[] = [];
  for (const state of frame.ships) {
    const isNew = !sim.fleet.byId.has(state.shipId) && state.shipId !== receiver.ownShipId;
    if (isNew && added === MAX_NEW) rest.push(state);
    else reconcileShip(sim, receiver, state);
    if (isNew) added = Math.min(MAX_NEW, added + 1);
  }
  if (rest.length > 0) receiver.rest = { frame: { ...frame, ships: rest }, now: receiver.context.now };
}

/** Takes some of the new ships that the newest frame still has. Returns that frame, for their events; null if there are none. */
function takeRest(sim: Simulation, receiver: Receiver): ServerFrame | null {
  const { rest } = receiver;
  if (rest === null) return null;
  receiver.rest = null;
  takePart(sim, receiver, rest.frame, rest.now);
  return rest.frame;
}

/** Takes another message of the newest tick: the ships that earlier ones did not have. */
export function takePart(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const bodies = boundaryAt(sim.bodies, sim.timeline, frame.tick);
  placeContext(receiver.context, frame, bodies, now);
  takeMissing(sim, receiver, frame);
}

/** Takes a frame overtaken by newer ones: only its ships that no newer frame had. */
export function takeOlder(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  if (!knowsBoundary(sim.bodies, frame.tick)) return;
  const bodies = boundaryAt(sim.bodies, sim.timeline, frame.tick);
  placeContext(receiver.context, frame, bodies, now);
  takeMissing(sim, receiver, frame);
}

function placeContext(
  out: SnapshotContext,
  { tick, lastInput }: ServerFrame,
  bodies: Float64Array,
  now: number,
): void {
  out.tick = tick;
  out.now = now;
  out.bodies = bodies;
  out.predictedBodies = bodies;
  out.turned = 0;
  out.lastInput = lastInput;
}

function takeMissing(sim: Simulation, receiver: Receiver, frame: ServerFrame): void {
  const ships = frame.ships.filter(({ shipId }) => {
    const track = sim.fleet.byId.get(shipId);
    return track === undefined || track.serverTick < frame.tick;
  });
  takeShips(sim, receiver, { ...frame, ships });
}

/** Takes some of the new ships that the newest frame still has, with their events. */
export function receiveRest(sim: Simulation, receiver: Receiver): void {
  const frame = takeRest(sim, receiver);
  if (frame !== null) sim.features.events?.confirmEvents(sim, receiver, frame);
}
