import { MAX_RATE } from '../../dynamics';
import type { ServerFrame } from '../../wire';
import type { Simulation } from '../simulation/simulation';
import { sendSeconds } from '../time/cadence';
import { serverTime } from '../time/clock';
import { isSameTempo, spanOf, wallOfTick } from '../time/timeline';
import { isTimed, type Receiver } from './receiver';

/** The kind of a frame relative to the frames before it (PREDICTION, Restarts). */
export type SnapshotKind =
  /** Follows the newest one. */
  | 'newest'
  /** The newest tick again with changes: time is paused, stops or resumes. */
  | 'again'
  /** The newest tick again with other ships: part of the same snapshot. */
  | 'part'
  /** Overtaken by newer ones, not seen yet. */
  | 'older'
  | 'duplicate'
  | 'tooOld'
  | 'future'
  /** Another timeline: the server restarted, or its counter jumped. */
  | 'jump';

/** A frame further ahead of the server's clock than this is of another timeline, s. */
const FUTURE = 2;
/** This many consecutive frames, each later than the one before, confirm each other even if they arrive together. */
const BURST = 3;

/** Classifies a frame. Changes only the receiver's record of possible jumps. */
export function classifySnapshot(
  sim: Simulation,
  receiver: Receiver,
  frame: ServerFrame,
  now: number,
): SnapshotKind {
  const { newestTick } = sim;
  const { tick } = frame;
  if (tick < receiver.firstTick) return 'tooOld';
  if (newestTick < 0) return 'newest';
  if (tick > newestTick) {
    if (isPlausible(sim, receiver, frame, now)) return 'newest';
    return receiver.fresh || isConfirmed(sim, receiver, frame, now) ? 'jump' : 'future';
  }
  if (tick === newestTick) return sameTick(sim, frame);
  if (receiver.fresh || isConfirmed(sim, receiver, frame, now)) return 'jump';
  if (tick <= newestTick - sim.ringLength) return 'tooOld';
  return receiver.seen[tick % receiver.seen.length] === tick ? 'duplicate' : 'older';
}

/** The frame's tick rate, Hz; the game's highest while it is only assumed. */
function fastestRate(receiver: Receiver, frame: ServerFrame): number {
  return isTimed(receiver) ? frame.tickRate : MAX_RATE;
}

/** Whether the server can have reached this tick: by the time since the newest frame, or by its clock. */
function isPlausible(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): boolean {
  const { tick } = frame;
  const tickRate = fastestRate(receiver, frame);
  const tolerance = Math.max(FUTURE, 2 * sendSeconds(sim.cadence, tickRate));
  if ((tick - sim.newestTick) / tickRate - (now - receiver.acceptedAt) <= tolerance) return true;
  return wallOfTick(sim.timeline, tick) - serverTime(receiver.clock, now) <= tolerance;
}

/**
 * A jump is accepted when the next frame follows it at the pace of the wall clock: late copies of old frames arrive together, or
 * between newer ones.
 */
function isConfirmed(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): boolean {
  const { jump } = receiver;
  const { tick } = frame;
  const span = (tick - jump.tick) / fastestRate(receiver, frame);
  const follows = jump.count > 0 && tick > jump.tick && span <= Math.max(FUTURE, 2 * (now - jump.at));
  jump.count = follows ? jump.count + 1 : 1;
  const paced = follows && now - jump.at >= span / 2;
  const forward = tick > sim.newestTick && jump.count >= BURST;
  jump.tick = tick;
  jump.at = now;
  if (!paced && !forward) return false;
  jump.count = 0;
  return true;
}

function sameTick(sim: Simulation, frame: ServerFrame): SnapshotKind {
  if (frame.paused || !isSameTempo(spanOf(sim.timeline, frame.tick), frame)) return 'again';
  for (const { shipId } of frame.ships) {
    const track = sim.fleet.byId.get(shipId);
    if (track === undefined || track.serverTick < frame.tick) return 'part';
  }
  return 'duplicate';
}
