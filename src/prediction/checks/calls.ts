import type { PartialFrame, ShipState } from '../../wire';
import type { Warn } from '../warnings';

/** What is known of the calls to one predictor so far. */
export interface Calls {
  advances: number;
  views: number;
  frames: number;
  /** Frames that did not have the own ship. */
  unseen: number;
  /** Consecutive calls of `advance` with the same `now`, and with a gap typical of milliseconds or of a slow loop. */
  repeated: number;
  millisecondGaps: number;
  slowGaps: number;
  advancedAt: number;
  receivedAt: number;
  takenAt: number;
  /** Tick and arrival of the first frame; NaN before. */
  firstTick: number;
  firstAt: number;
}

export function createCalls(): Calls {
  return {
    ...{ advances: 0, views: 0, frames: 0, unseen: 0 },
    ...{ repeated: 0, millisecondGaps: 0, slowGaps: 0 },
    ...{ advancedAt: Number.NaN, receivedAt: Number.NaN, takenAt: 0 },
    ...{ firstTick: Number.NaN, firstAt: Number.NaN },
  };
}

/** Consecutive calls after which a pattern is not an accident. */
const ROW = 10;
/** s between two display frames: below the first a page draws normally; above it, and for milliseconds, this is seen. */
const SLOW_GAP = 0.15;
const HIDDEN_GAP = 5;
const MILLISECOND_GAP = 4;
const LONGEST_GAP = 300;
/** s by which the clocks of two callers of one predictor may be apart. */
const CLOCKS_APART = 100;

/** `advance` was called. */
export function noteAdvance(warn: Warn, calls: Calls, now: number): void {
  calls.advances += 1;
  const gap = now - calls.advancedAt;
  calls.advancedAt = now;
  calls.repeated = gap === 0 ? calls.repeated + 1 : 0;
  calls.millisecondGaps = gap >= MILLISECOND_GAP && gap <= LONGEST_GAP ? calls.millisecondGaps + 1 : 0;
  calls.slowGaps = gap > SLOW_GAP && gap < HIDDEN_GAP ? calls.slowGaps + 1 : 0;
  if (calls.repeated === ROW)
    warn('advance-twice', 'advance is called more than once a frame with the same now: once is enough.', {
      now,
    });
  if (calls.millisecondGaps === ROW)
    warn('now-in-milliseconds', `now grows by ${gap} a call: pass seconds, performance.now() / 1000.`, {
      now,
    });
  if (calls.slowGaps === ROW)
    warn('advance-seldom', `advance is called every ${gap} s: call it once a display frame.`, { now, gap });
  if (gap < 0) warn('now-went-back', `now went back by ${-gap} s: pass a monotonic clock.`, { now, gap });
  if (Math.abs(now - calls.receivedAt) > CLOCKS_APART * (1 + calls.millisecondGaps)) {
    const details = { now, receivedAt: calls.receivedAt };
    warn('two-clocks', 'receive and advance are given times of two clocks: use one for both.', details);
  }
}

/** A frame arrived at `now`; `own` is the own ship's id, '' for a spectator. */
export function noteFrame(warn: Warn, calls: Calls, frame: PartialFrame, now: number, own: string): void {
  calls.frames += 1;
  calls.receivedAt = now;
  if (calls.frames >= ROW && calls.advances === 0)
    warn(
      'advance-never',
      `${calls.frames} frames came and advance was never called: call it once a display frame.`,
      {
        frames: calls.frames,
      },
    );
  noteRate(warn, calls, frame, now);
  const ships = Array.isArray(frame.ships) ? frame.ships : [];
  const isThere = own === '' || ships.some((ship) => (ship as ShipState | null)?.shipId === own);
  calls.unseen = isThere ? 0 : calls.unseen + 1;
  if (calls.unseen === ROW)
    warn('own-ship-never-seen', `No frame has the own ship ${own}. Check ownShipId, or call setOwnShip.`, {
      ownShipId: own,
      ships: ships.slice(0, 10).map((ship) => (ship as ShipState | null)?.shipId),
    });
}

/** Warns of a tick rate other than the rate at which ticks arrive: a period for a rate, milliseconds for seconds. */
function noteRate(warn: Warn, calls: Calls, { tick, tickRate, paused }: PartialFrame, now: number): void {
  if (Number.isNaN(calls.firstTick) || tick < calls.firstTick || paused === true) {
    calls.firstTick = tick;
    calls.firstAt = now;
  }
  const seconds = now - calls.firstAt;
  const come = (tick - calls.firstTick) / seconds;
  if (typeof tickRate !== 'number' || calls.frames < ROW || !(seconds >= MEASURED)) return;
  if (come < tickRate * OTHER_RATE && come * OTHER_RATE > tickRate) return;
  const message = `tickRate is ${tickRate} Hz, and ticks come at ${come.toPrecision(3)} a second: pass ticks per second, not their length.`;
  warn('tick-rate', message, { tickRate, measured: come });
}

/** s over which the rate of ticks is measured, and the factor by which it may differ from the rate sent, so that a stall does not count. */
const MEASURED = 3;
const OTHER_RATE = 5;

/** `view` was called. */
export function noteView(warn: Warn, calls: Calls, now: number): void {
  if (calls.advances > 0 && Math.abs(now - calls.advancedAt) > CLOCKS_APART) {
    const details = { now, advancedAt: calls.advancedAt };
    warn('two-clocks', 'advance and view are given times of two clocks: use one for both.', details);
  }
  calls.views += 1;
  if (calls.views === ROW && calls.advances === 0 && calls.frames > 0)
    warn('advance-never', 'view is called and advance never: it shows nothing until advance is called.', {
      views: calls.views,
    });
}

/** Messages to send have been waiting since call `takenAt` of `advance`. */
export function noteUntaken(warn: Warn, calls: Calls, waiting: number): void {
  if (waiting === 0 || calls.advances - calls.takenAt < LONGEST_GAP) return;
  const text = `${waiting} inputs wait to be sent: call takeOutgoing (protobuf) or takeControls (JSON) each frame.`;
  warn('outgoing-not-taken', text, { waiting });
}
