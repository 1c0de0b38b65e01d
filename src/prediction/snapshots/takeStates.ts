import type { ServerFrame, ShipState } from '../../wire';
import { acknowledge, type InputOutcome, prune } from '../inputs/inputs';
import { has, offsetOf } from '../simulation/history';
import { startReplay } from '../simulation/replay';
import { historyLength } from '../simulation/fitRings';
import type { Simulation } from '../simulation/simulation';
import { addTrack, removeTrack } from '../simulation/track';
import { steerByMargin } from '../time/clock';
import { unknownNameOf } from './reconcile/adopt';
import { writeBodiesOfFrame } from './bodies/bodiesOfFrame';
import { boundaryAt, knowsBoundary } from './bodies/bodyTrack';
import type { Receiver } from './receiver';
import { reconcile, showServerState } from './reconcile/reconcile';
import { shipFault } from './shipFault';
import type { SnapshotContext } from './snapshotContext';

/** New ships that one call takes. */
const MAX_NEW = 1000;

/** Compares the newest frame's bodies and ships with the predictions for its tick. */
export function takeStates(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const { context } = receiver;
  writeBodiesOfFrame(context, sim, receiver, frame);
  context.tick = frame.tick;
  context.now = now;
  context.lastInput = frame.lastInput;
  receiver.rest = null;
  takeShips(sim, receiver, frame);
  for (const track of sim.fleet.tracks) {
    if (track.mode !== 'waiting' || track.replaying || track.off || track.serverTick < 0) continue;
    if (has(track.history, frame.tick))
      startReplay(track, sim, frame.tick, track.history.rows, offsetOf(track.history, frame.tick));
    else startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

/**
 * Takes the ships of a frame, but of new ones no more than MAX_NEW: the rest follow in the next calls of `advance`, so that no call
 * blocks for long.
 */
function takeShips(sim: Simulation, receiver: Receiver, frame: ServerFrame): void {
  let added = 0;
  const rest: ShipState[] = [];
  for (const state of frame.ships) {
    const isNew = !sim.fleet.byId.has(state.shipId) && state.shipId !== receiver.ownShipId;
    if (isNew && added === MAX_NEW) rest.push(state);
    else takeShip(sim, receiver, state);
    if (isNew) added = Math.min(MAX_NEW, added + 1);
  }
  if (rest.length > 0) receiver.rest = { frame: { ...frame, ships: rest }, now: receiver.context.now };
}

/** Takes some of the new ships that the newest frame still has. Returns that frame, for their events; null if there are none. */
export function takeRest(sim: Simulation, receiver: Receiver): ServerFrame | null {
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

/** Takes one ship's state in the frame of the receiver's context. */
function takeShip(sim: Simulation, receiver: Receiver, state: ShipState): void {
  const { context } = receiver;
  const fault = shipFault(state);
  if (fault !== null) {
    refuseShip(sim, state, fault);
    return;
  }
  if (isRemoved(receiver, state.shipId, context.tick)) return;
  const own = state.shipId === receiver.ownShipId;
  const track =
    sim.fleet.byId.get(state.shipId) ?? addTrack(sim.fleet, state.shipId, historyLength(sim, own));
  track.own = own;
  if (own) sim.fleet.own = track;
  context.inputs = own ? answered(sim, receiver, state) : 'asPredicted';
  const unknown = unknownNameOf(state, sim.world);
  track.policy = receiver.policies.get(state.shipId) ?? 'predict';
  const isPredicted = unknown === null && track.policy === 'predict';
  const reason = isPredicted
    ? reconcile(sim, track, state, context)
    : showServerState(sim, track, state, context);
  if (reason === null) track.lastSend = sim.cadence.sends;
  if (reason !== null || unknown !== null) refuseShip(sim, state, reason ?? unknown!);
  if (reason !== null && track.serverTick < 0) removeTrack(sim.fleet, track);
}

/** Whether the caller has removed the ship: only a frame later than those received by then restores it. */
function isRemoved({ removed }: Receiver, shipId: string, tick: number): boolean {
  const removedAt = removed.get(shipId);
  if (removedAt === undefined) return false;
  if (tick <= removedAt) return true;
  removed.delete(shipId);
  return false;
}

function refuseShip({ counters, warn }: Simulation, state: ShipState, reason: string): void {
  counters.shipsRefused += 1;
  const shipId = String((state as { shipId?: unknown } | null)?.shipId);
  counters.lastRefusal = `frame.ships (${shipId}): ${reason}`;
  warn('ship-unusable', `A ship is not predicted. ${counters.lastRefusal}`, { shipId, reason });
}

/** Takes the frame's acknowledgement of own inputs, also for steering the lead. */
function answered(sim: Simulation, { clock, context }: Receiver, state: ShipState): InputOutcome {
  const { inputs } = sim;
  const { tick, now, lastInput: acknowledgement } = context;
  const before = inputs.applied;
  const outcome = acknowledge(inputs, tick, acknowledgement, state, now);
  if (acknowledgement !== null && acknowledgement.seq > before) {
    const stored = inputs.records.find((candidate) => candidate.record.seq === acknowledgement.seq);
    if (stored !== undefined) steerByMargin(clock, acknowledgement.margin, stored.steer, now);
    sim.counters.margin = acknowledgement.margin;
  }
  prune(inputs, tick - sim.ringLength);
  return outcome;
}
