import type { ServerFrame } from '../../wire';
import { forgetRecords } from '../inputs/inputs';
import { fitRings } from '../simulation/rings/fitRings';
import type { Simulation } from '../simulation/simulation';
import { clearFleet, removeTrack } from '../simulation/track';
import { forgetCadence, noteSend } from '../time/cadence';
import { forgetSchedule } from '../time/clock';
import { spanOf } from '../time/timeline';
import { forgetAfter as forgetBodiesAfter } from './bodies/bodyTrack';
import { classifySnapshot, type SnapshotKind } from './classify';
import { forgetPast, isTimed, type Receiver } from './receiver';
import { reconcileStates } from './reconcile/reconcileStates';
import { followTempo } from './tempo/followTempo';

/** Sends without a ship after which it is removed, if it has also been silent for SILENT_SECONDS. */
const SILENT_SENDS = 3;
const SILENT_SECONDS = 1;

/** Receives a complete frame: classifies and counts it and, if it is used, compares it with the prediction. */
export function receiveSnapshot(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const kind = classifySnapshot(sim, receiver, frame, now);
  if (!count(sim, kind)) return;
  if (kind === 'jump') beginTimeline(sim, receiver);
  receiver.seen[frame.tick % receiver.seen.length] = frame.tick;
  if (kind === 'older') {
    sim.features.events?.confirmEvents(sim, receiver, frame);
    sim.features.parts?.takeOlder(sim, receiver, frame, now);
    return;
  }
  receiver.jump.count = 0;
  if (kind === 'part') {
    receiver.acceptedAt = now;
    sim.features.parts?.takePart(sim, receiver, frame, now);
  } else {
    const isSpaced = sim.newestTick >= 0 && isTimed(receiver);
    noteSend(sim.cadence, isSpaced ? frame.tick - sim.newestTick : 0);
    followTempo(sim, receiver, frame, now);
    receiver.acceptedAt = now;
    receiver.fresh = false;
    const { substeps } = spanOf(sim.timeline, frame.tick).timing;
    const ships = Math.max(sim.fleet.tracks.length, frame.ships.length);
    fitRings(sim, { tickRate: frame.tickRate, substeps, ships });
    reconcileStates(sim, receiver, frame, now);
  }
  sim.features.events?.settleEvents(sim, receiver, frame, now);
  if (kind !== 'part') removeSilent(sim, now);
}

/** Counts a frame by its kind. Returns whether it is used. */
function count({ counters }: Simulation, kind: SnapshotKind): boolean {
  switch (kind) {
    case 'duplicate':
      counters.framesDuplicate += 1;
      return false;
    case 'tooOld':
      counters.framesTooOld += 1;
      return false;
    case 'future':
      counters.framesFromFuture += 1;
      return false;
    case 'older':
      counters.framesOutOfOrder += 1;
      break;
    default:
  }
  counters.framesAccepted += 1;
  return true;
}

/** Counts a refused message, with the reason. */
export function refuse({ counters, warn }: Simulation, reason: string): void {
  counters.framesRefused += 1;
  counters.lastRefusal = reason;
  warn('message-refused', `A message was refused; the last valid state is kept. ${reason}.`, { reason });
}

/** Starts a new timeline: earlier predictions cannot be compared with later states. */
export function beginTimeline(sim: Simulation, receiver: Receiver): void {
  sim.counters.resyncs += 1;
  sim.bodiesKnown = false;
  sim.timeline.spans.length = 0;
  forgetRecords(sim.inputs);
  forgetSchedule(receiver.clock);
  forgetBodiesAfter(sim.bodies, -1);
  clearFleet(sim.fleet);
  forgetCadence(sim.cadence);
  forgetPast(receiver);
  sim.newestTick = -1;
  sim.frontIsStale = true;
}

/** Removes ships that have not been sent for 3 sends and SILENT_SECONDS; a ship that is sent seldom stays. */
function removeSilent(sim: Simulation, now: number): void {
  const { tracks } = sim.fleet;
  for (let i = tracks.length - 1; i >= 0; i--) {
    const track = tracks[i]!;
    if (sim.cadence.sends - track.lastSend >= SILENT_SENDS && now - track.seenAt >= SILENT_SECONDS)
      removeTrack(sim.fleet, track);
  }
}
