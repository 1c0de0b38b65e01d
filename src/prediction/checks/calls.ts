import type { PartialFrame, ShipState } from '../../wire';
import type { Warn } from '../warnings';

/** The calls made to one predictor so far. */
export interface Calls {
  advances: number;
  views: number;
  frames: number;
  /** Frames without the own ship. */
  unseen: number;
  /** Consecutive calls of `advance` with the same `now`, with `now` in milliseconds by its gaps, and from a slow loop. */
  repeated: number;
  millisecondGaps: number;
  slowGaps: number;
  advancedAt: number;
  receivedAt: number;
  takenAt: number;
  /** The call that took messages before; '' for none. */
  takenBy: string;
  /** Tick, game time (s) and arrival of the first frame; NaN before. */
  firstTick: number;
  firstGameTime: number;
  firstAt: number;
}

export function createCalls(): Calls {
  return {
    ...{ advances: 0, views: 0, frames: 0, unseen: 0 },
    ...{ repeated: 0, millisecondGaps: 0, slowGaps: 0 },
    ...{ advancedAt: Number.NaN, receivedAt: Number.NaN },
    ...{ takenAt: 0, takenBy: '' },
    ...{ firstTick: Number.NaN, firstGameTime: Number.NaN, firstAt: Number.NaN },
  };
}

/** Consecutive calls that make a pattern. */
const PATTERN = 10;
/** s between two calls of `advance`. SLOW_GAP to HIDDEN_GAP: a slow loop. MILLISECOND_GAP to LONGEST_GAP: milliseconds were passed. */
const SLOW_GAP = 0.15;
const HIDDEN_GAP = 5;
const MILLISECOND_GAP = 4;
const LONGEST_GAP = 300;
/** s: no monotonic clock has run for 30 years; Unix time has. */
const UNIX_TIME = 1e9;
/** s: times further apart come from different clocks. */
const CLOCKS_APART = 100;

/** `advance` was called. */
export function noteAdvance(warn: Warn, calls: Calls, now: number): void {
  calls.advances += 1;
  const gap = now - calls.advancedAt;
  calls.advancedAt = now;
  calls.repeated = gap === 0 ? calls.repeated + 1 : 0;
  calls.millisecondGaps = gap >= MILLISECOND_GAP && gap <= LONGEST_GAP ? calls.millisecondGaps + 1 : 0;
  calls.slowGaps = gap > SLOW_GAP && gap < HIDDEN_GAP ? calls.slowGaps + 1 : 0;
  if (calls.repeated === PATTERN)
    warn('advance-twice', 'advance is called more than once per frame with the same now: once is enough.', {
      now,
    });
  if (calls.millisecondGaps === PATTERN)
    warn('now-in-milliseconds', `now grows by ${gap} per call: pass seconds, performance.now() / 1000.`, {
      now,
    });
  if (calls.slowGaps === PATTERN)
    warn('advance-seldom', `advance is called every ${gap} s: call it once per display frame.`, { now, gap });
  if (now > UNIX_TIME) {
    const message = `now is ${now}, as Date.now() gives it: that clock is set back and forth. Pass performance.now() / 1000.`;
    warn('now-of-calendar', message, { now });
  }
  if (gap < 0) warn('now-went-back', `now went back by ${-gap} s: pass a monotonic clock.`, { now, gap });
  if (Math.abs(now - calls.receivedAt) > CLOCKS_APART * (1 + calls.millisecondGaps)) {
    const details = { now, receivedAt: calls.receivedAt };
    warn(
      'two-clocks',
      'receive and advance are given times from different clocks: use one for both.',
      details,
    );
  }
}

/** A frame arrived at `now`; `own` is the own ship's id, '' for a spectator. */
export function noteFrame(warn: Warn, calls: Calls, frame: PartialFrame, now: number, own: string): void {
  calls.frames += 1;
  calls.receivedAt = now;
  if (calls.frames >= PATTERN && calls.advances === 0)
    warn(
      'advance-never',
      `${calls.frames} frames came and advance was never called: call it once per display frame.`,
      {
        frames: calls.frames,
      },
    );
  noteRate(warn, calls, frame, now);
  const ships = Array.isArray(frame.ships) ? frame.ships : [];
  const isThere = own === '' || ships.some((ship) => (ship as ShipState | null)?.shipId === own);
  calls.unseen = isThere ? 0 : calls.unseen + 1;
  if (calls.unseen === PATTERN)
    warn('own-ship-never-seen', `No frame has the own ship ${own}. Check ownShipId, or call setOwnShip.`, {
      ownShipId: own,
      ships: ships.slice(0, 10).map((ship) => (ship as ShipState | null)?.shipId),
    });
}

/** Warns of a tick rate other than the rate at which ticks arrive: a period for a rate, milliseconds for seconds. */
function noteRate(warn: Warn, calls: Calls, frame: PartialFrame, now: number): void {
  const { tick, tickRate, paused } = frame;
  const gameTime = frame.gameTime ?? Number.NaN;
  if (Number.isNaN(calls.firstTick) || tick < calls.firstTick || paused === true) {
    calls.firstTick = tick;
    calls.firstGameTime = gameTime;
    calls.firstAt = now;
  }
  const seconds = now - calls.firstAt;
  checkGameTime(warn, (gameTime - calls.firstGameTime) / (tick - calls.firstTick), frame);
  const come = (tick - calls.firstTick) / seconds;
  if (typeof tickRate !== 'number' || calls.frames < PATTERN || !(seconds >= MEASURED)) return;
  if (come < tickRate * OTHER_RATE && come * OTHER_RATE > tickRate) return;
  const message = `tickRate is ${tickRate} Hz, and ${come.toPrecision(3)} ticks arrive per second: pass ticks per second, not their length.`;
  warn('tick-rate', message, { tickRate, measured: come });
}

/** s over which the tick rate is measured, and the factor by which it may differ from the rate sent: a stall is no fault. */
const MEASURED = 3;
const OTHER_RATE = 5;

/** Game time that grows `perTick` a tick, by a factor of more than 100 off what the tempo says, is in another unit. */
function checkGameTime(warn: Warn, perTick: number, { tickRate, timeScale }: PartialFrame): void {
  const expected = (timeScale ?? Number.NaN) / (tickRate ?? Number.NaN);
  const ratio = perTick / expected;
  if (!(ratio > 100 || ratio < 0.01)) return;
  const message = `gameTime grows by ${perTick} per tick, and timeScale / tickRate is ${expected} s: pass seconds.`;
  warn('game-time', message, { perTick, expected });
}

/** `view` was called. */
export function noteView(warn: Warn, calls: Calls, now: number): void {
  if (calls.advances > 0 && Math.abs(now - calls.advancedAt) > CLOCKS_APART) {
    const details = { now, advancedAt: calls.advancedAt };
    warn('two-clocks', 'advance and view are given times from different clocks: use one for both.', details);
  }
  calls.views += 1;
  if (calls.views === PATTERN && calls.advances === 0 && calls.frames > 0)
    warn('advance-never', 'view is called but advance never is: view shows nothing until then.', {
      views: calls.views,
    });
}

/** Inputs have been waiting to be sent since call `takenAt` of `advance`. */
export function noteUntaken(warn: Warn, calls: Calls, waiting: number): void {
  if (waiting === 0 || calls.advances - calls.takenAt < LONGEST_GAP) return;
  const text = `${waiting} inputs wait to be sent: call takeOutgoing (protobuf) or takeControls (JSON) each frame.`;
  warn('outgoing-not-taken', text, { waiting });
}

/** `call` took the messages to send. */
export function noteTaken(warn: Warn, calls: Calls, call: string): void {
  calls.takenAt = calls.advances;
  if (calls.takenBy !== '' && calls.takenBy !== call) {
    const message =
      'takeOutgoing and takeControls are both called, and each takes the messages from the other: call takeOutgoing for protobuf, takeControls for JSON.';
    warn('outgoing-taken-twice', message, { call, before: calls.takenBy });
  }
  calls.takenBy = call;
}
