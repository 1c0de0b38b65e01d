import type { BodyState, ServerFrame } from '../../wire';
import { forgetRecords } from '../inputs/inputs';
import { fitRings } from '../simulation/fitRings';
import type { Simulation } from '../simulation/simulation';
import { clearFleet, type Policy, removeTrack } from '../simulation/track';
import { forgetCadence, noteSend } from '../time/cadence';
import { type Clock, forgetSchedule } from '../time/clock';
import { spanOf } from '../time/timeline';
import { forgetAfter as forgetBodiesAfter } from './bodies/bodyTrack';
import { classifySnapshot, type SnapshotKind } from './classify';
import { createSnapshotContext, type SnapshotContext } from './snapshotContext';
import { settleEvents, tellEvents } from './settleEvents';
import { takeOlder, takePart, takeStates } from './takeStates';
import { followTempo } from './tempo';

/** State by which one connection's frames are classified. */
export interface Receiver {
  readonly clock: Clock;
  ownShipId: string;
  /** The server sends events; without them, states confirm predicted events. */
  tellsEvents: boolean;
  /** A new connection: the next frame may have any tick. */
  fresh: boolean;
  /** Frames before this tick are of the previous world or connection. */
  firstTick: number;
  /** Possible jumps in time: how many in a row, the last one's tick and arrival. */
  readonly jump: { tick: number; at: number; count: number };
  /** Ticks of received frames, slot = tick mod length. */
  readonly seen: Float64Array;
  /** The newest received tick, and its arrival, client wall s. */
  newest: number;
  acceptedAt: number;
  /** Ships that are not to be predicted, present or not. */
  readonly policies: Map<string, Policy>;
  /** Ships removed by the caller, with the newest tick then: states up to that tick do not restore them. */
  readonly removed: Map<string, number>;
  /** The bodies known before the first frame are taken to be of its tick, unless it has others. */
  startsBodies: boolean;
  /** The bodies sent last, to detect whether they move. */
  readonly lastBodies: { tick: number; bodies: readonly BodyState[] };
  /** Of the frame being received. */
  readonly context: SnapshotContext;
}

/** Sends without a ship after which it is removed, if it has also been silent for FADE_SECONDS. */
const FADE_SENDS = 3;
const FADE_SECONDS = 1;

export function createReceiver(clock: Clock, ownShipId: string): Receiver {
  return {
    clock,
    ownShipId,
    tellsEvents: false,
    fresh: true,
    firstTick: 0,
    jump: { tick: -1, at: 0, count: 0 },
    seen: new Float64Array(1024).fill(-1),
    newest: -1,
    acceptedAt: Number.NEGATIVE_INFINITY,
    policies: new Map(),
    removed: new Map(),
    startsBodies: true,
    lastBodies: { tick: -1, bodies: [] },
    context: createSnapshotContext(),
  };
}

/** Starts over: earlier frames do not relate to later ones. */
export function forgetPast(receiver: Receiver): void {
  receiver.jump.count = 0;
  receiver.fresh = true;
  receiver.firstTick = 0;
  receiver.seen.fill(-1);
  receiver.newest = -1;
  receiver.acceptedAt = Number.NEGATIVE_INFINITY;
  receiver.removed.clear();
  receiver.startsBodies = true;
  receiver.lastBodies.bodies = [];
  receiver.lastBodies.tick = -1;
}

/** Receives a complete frame of the simulated world: classifies and counts it, and compares it with the prediction if it is used. */
export function receiveSnapshot(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const kind = classifySnapshot(sim, receiver, frame, now);
  if (!count(sim, kind)) return;
  if (kind === 'jump') startAnew(sim, receiver);
  receiver.seen[frame.tick % receiver.seen.length] = frame.tick;
  if (kind === 'older') {
    tellEvents(sim, receiver, frame);
    takeOlder(sim, receiver, frame, now);
    return;
  }
  receiver.acceptedAt = now;
  receiver.jump.count = 0;
  if (kind === 'part') takePart(sim, receiver, frame, now);
  else {
    noteSend(sim.cadence, sim.newestTick < 0 ? 0 : frame.tick - sim.newestTick);
    followTempo(sim, receiver, frame, now);
    receiver.newest = frame.tick;
    receiver.fresh = false;
    const { substeps } = spanOf(sim.timeline, frame.tick).timing;
    const ships = Math.max(sim.fleet.tracks.length, frame.ships.length);
    fitRings(sim, { tickRate: frame.tickRate, substeps, ships });
    takeStates(sim, receiver, frame, now);
  }
  settleEvents(sim, receiver, frame, now);
  if (kind !== 'part') fade(sim, now);
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
  warn('message-refused', `A message was refused, and the last good state stays. ${reason}.`, { reason });
}

/** Starts another timeline: the predictions so far cannot be compared with later states. */
export function startAnew(sim: Simulation, receiver: Receiver): void {
  sim.counters.resyncs += 1;
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

/** Removes ships that have not been sent for 3 sends and FADE_SECONDS; a ship that is sent seldom stays. */
function fade(sim: Simulation, now: number): void {
  const { tracks } = sim.fleet;
  for (let i = tracks.length - 1; i >= 0; i--) {
    const track = tracks[i]!;
    if (sim.cadence.sends - track.lastSend >= FADE_SENDS && now - track.seenAt >= FADE_SECONDS)
      removeTrack(sim.fleet, track);
  }
}
