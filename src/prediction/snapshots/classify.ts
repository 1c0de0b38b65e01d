import type { ServerFrame } from '../../wire';
import type { Simulation } from '../simulation/simulation';
import { sendSeconds } from '../time/cadence';
import { serverTime } from '../time/clock';
import { spanOf, wallOfTick } from '../time/timeline';
import type { Receiver } from './receiver';

/** What a frame is beside those before it (PREDICTION, Restarts). */
export type SnapshotKind =
  /** Goes on from the newest one. */
  | 'newest'
  /** The newest tick again, with news: time stands still, stops or goes on. */
  | 'again'
  /** The newest tick again, with ships not told of yet: a part of the same snapshot. */
  | 'part'
  /** Overtaken by newer ones, not seen yet. */
  | 'older'
  | 'duplicate'
  | 'tooOld'
  | 'future'
  /** Another time: the server began anew, or its counter jumped. */
  | 'jump';

/** A frame this far ahead of where the server can be is of another time, s. */
const FUTURE = 2;
/** Frames in a row that go forward bear each other out, even when they come all at once. */
const BURST = 3;

/** Changes nothing but what the receiver keeps of frames that may be a jump. */
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
    return receiver.fresh || isConfirmed(receiver, frame, now) ? 'jump' : 'future';
  }
  if (tick === newestTick) return sameTick(sim, frame);
  if (receiver.fresh || isConfirmed(receiver, frame, now)) return 'jump';
  if (tick <= newestTick - sim.ringLength) return 'tooOld';
  return receiver.seen[tick % receiver.seen.length] === tick ? 'duplicate' : 'older';
}

/** Whether a server may have come to this tick by now, by what has passed since the newest frame or by its clock. */
function isPlausible(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): boolean {
  const { tick, tickRate } = frame;
  const tolerance = Math.max(FUTURE, 2 * sendSeconds(sim.cadence, tickRate));
  if ((tick - sim.newestTick) / tickRate - (now - receiver.acceptedAt) <= tolerance) return true;
  return wallOfTick(sim.timeline, tick) - serverTime(receiver.clock, now) <= tolerance;
}

/**
 * A jump in time is believed when the next frame goes on from it, at the pace of the wall clock: late copies of old frames come all
 * at once, or between newer ones.
 */
function isConfirmed(receiver: Receiver, { tick, tickRate }: ServerFrame, now: number): boolean {
  const { jump } = receiver;
  const span = (tick - jump.tick) / tickRate;
  const goesOn = jump.count > 0 && tick > jump.tick && span <= Math.max(FUTURE, 2 * (now - jump.at));
  jump.count = goesOn ? jump.count + 1 : 1;
  const paced = goesOn && now - jump.at >= span / 2;
  const forward = tick > receiver.newest && jump.count >= BURST;
  jump.tick = tick;
  jump.at = now;
  if (!paced && !forward) return false;
  jump.count = 0;
  return true;
}

function sameTick(sim: Simulation, frame: ServerFrame): SnapshotKind {
  if (frame.paused || differs(sim, frame)) return 'again';
  for (const { shipId } of frame.ships) {
    const track = sim.fleet.byId.get(shipId);
    if (track === undefined || track.serverTick < frame.tick) return 'part';
  }
  return 'duplicate';
}

/** Whether a frame's tempo is another than the one held for its tick. */
export function differs(sim: Simulation, { tick, tickRate, timeScale, paused }: ServerFrame): boolean {
  const held = spanOf(sim.timeline, tick);
  return held.paused !== paused || held.tickRate !== tickRate || held.timeScale !== timeScale;
}
