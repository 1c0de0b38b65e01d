import type { ServerFrame, ShipState } from '../../../wire';
import { inferApplied, type InputOutcome, prune } from '../../inputs/inputs';
import { has, offsetOf } from '../../simulation/rings/history';
import { startReplay } from '../../simulation/replay';
import { historyLength } from '../../simulation/rings/fitRings';
import type { Simulation } from '../../simulation/simulation';
import { addTrack, removeTrack } from '../../simulation/track';
import { unknownNameOf } from './adopt';
import { writeBodiesOfFrame } from '../bodies/bodiesOfFrame';
import type { Receiver } from '../receiver';
import { reconcile, showServerState } from './reconcile';

/** Compares the newest frame's bodies and ships with the predictions for its tick. */
export function reconcileStates(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const { context } = receiver;
  writeBodiesOfFrame(context, sim, receiver, frame);
  context.tick = frame.tick;
  context.now = now;
  context.lastInput = frame.lastInput;
  (sim.features.parts?.takeShips ?? reconcileAll)(sim, receiver, frame);
  for (const track of sim.fleet.tracks) {
    if (track.mode !== 'waiting' || track.replaying || track.off || track.serverTick < 0) continue;
    if (has(track.history, frame.tick))
      startReplay(track, sim, frame.tick, track.history.rows, offsetOf(track.history, frame.tick));
    else startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

function reconcileAll(sim: Simulation, receiver: Receiver, { ships }: ServerFrame): void {
  for (const state of ships) reconcileShip(sim, receiver, state);
}

/** Takes one ship's state in the frame of the receiver's context. */
export function reconcileShip(sim: Simulation, receiver: Receiver, state: ShipState): void {
  const { context } = receiver;
  const fault = sim.features.records?.shipFault(state) ?? null;
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

/** Learns from the frame which of the own inputs were applied, and when. */
function answered(sim: Simulation, receiver: Receiver, state: ShipState): InputOutcome {
  const { inputs, features } = sim;
  const { tick, now } = receiver.context;
  const outcome =
    features.acknowledgements?.applyAcknowledgement(sim, receiver, state) ??
    inferApplied(inputs, tick, state, now);
  prune(inputs, tick - sim.ringLength);
  return outcome;
}
