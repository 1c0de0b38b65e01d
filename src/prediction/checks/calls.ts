import type { DecodedFrame, PartialFrame, ShipState } from '../../wire';
import type { Warn } from '../warnings';

/** The calls made to one predictor so far. */
export interface Calls {
  advances: number;
  views: number;
  frames: number;
  /** Consecutive frames without the player's ship; 0 once it was seen (`ownSeen`): it may have crashed. */
  unseen: number;
  ownSeen: string;
  /** Calls of `advance` with the `now` of the previous call, and later calls with another `now`: two in a row clear the count. */
  repeated: number;
  fresh: number;
  /** Consecutive calls of `advance` with `now` in milliseconds by its gaps, and from a slow loop. */
  millisecondGaps: number;
  slowGaps: number;
  advancedAt: number;
  receivedAt: number;
  takenAt: number;
  /** The call that took messages before; '' for none. */
  takenBy: string;
  readonly pace: Pace;
}

/** The pace of the ticks since a first frame. Times in s; NaN before that frame. */
interface Pace {
  /** Tick, game time and arrival of the first frame. */
  firstTick: number;
  firstGameTime: number;
  firstAt: number;
  /** Tick, arrival and tempo of the newest frame; NaN until one is sent. */
  tick: number;
  at: number;
  tickRate: number;
  timeScale: number;
  /** Wall and game time that the ticks since the first should have taken, by the tempo of each frame. */
  wallDue: number;
  gameDue: number;
  /** Consecutive frames that came far later than due, and the arrival of the one before them. */
  late: number;
  lateSince: number;
}

export function createCalls(): Calls {
  return {
    advances: 0,
    views: 0,
    frames: 0,
    unseen: 0,
    ownSeen: '',
    repeated: 0,
    fresh: 0,
    millisecondGaps: 0,
    slowGaps: 0,
    advancedAt: Number.NaN,
    receivedAt: Number.NaN,
    takenAt: 0,
    takenBy: '',
    pace: {
      firstTick: Number.NaN,
      firstGameTime: Number.NaN,
      firstAt: Number.NaN,
      tick: Number.NaN,
      at: Number.NaN,
      tickRate: Number.NaN,
      timeScale: Number.NaN,
      wallDue: 0,
      gameDue: 0,
      late: 0,
      lateSince: Number.NaN,
    },
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
  calls.fresh = gap === 0 ? 0 : calls.fresh + 1;
  if (gap === 0) calls.repeated += 1;
  else if (calls.fresh > 1) calls.repeated = 0;
  calls.millisecondGaps = gap >= MILLISECOND_GAP && gap <= LONGEST_GAP ? calls.millisecondGaps + 1 : 0;
  calls.slowGaps = gap > SLOW_GAP && gap < HIDDEN_GAP ? calls.slowGaps + 1 : 0;
  if (calls.repeated === PATTERN)
    warn(
      'advance-twice',
      `advance is called more than once per frame with the same now (${now}): once is enough.`,
      { now },
    );
  if (calls.millisecondGaps === PATTERN)
    warn('now-in-milliseconds', `now grows by ${gap} per call: pass seconds, performance.now() / 1000.`, {
      now,
    });
  if (calls.slowGaps === PATTERN)
    warn('advance-seldom', `advance is called every ${gap} s: call it once per display frame.`, { now, gap });
  if (now > UNIX_TIME) {
    const message = `now is ${now}, like Date.now(): that clock can be set. Pass performance.now() / 1000.`;
    warn('now-of-calendar', message, { now });
  }
  if (gap < 0) warn('now-went-back', `now went back by ${-gap} s: pass a monotonic clock.`, { now, gap });
  if (Math.abs(now - calls.receivedAt) > CLOCKS_APART * (1 + calls.millisecondGaps)) {
    const details = { now, receivedAt: calls.receivedAt };
    warn(
      'two-clocks',
      `receive is given ${calls.receivedAt} s, advance ${now} s: use one clock for both.`,
      details,
    );
  }
}

/** A frame arrived at `now`; `own` is the id of the player's ship, '' for a spectator. */
export function noteFrame(warn: Warn, calls: Calls, frame: PartialFrame, now: number, own: string): void {
  calls.frames += 1;
  calls.receivedAt = now;
  if (calls.frames >= PATTERN && calls.advances === 0)
    warn(
      'advance-never',
      `${calls.frames} frames have arrived, but advance was never called: call it once per display frame.`,
      {
        frames: calls.frames,
      },
    );
  notePace(warn, calls.pace, frame, now);
  noteOwnShip(warn, calls, frame, own);
}

function noteOwnShip(warn: Warn, calls: Calls, frame: PartialFrame, own: string): void {
  const ships = Array.isArray(frame.ships) ? frame.ships : [];
  if (ships.some((ship) => (ship as ShipState | null)?.shipId === own)) calls.ownSeen = own;
  calls.unseen = own === '' || own === calls.ownSeen ? 0 : calls.unseen + 1;
  if (calls.unseen !== PATTERN) return;
  const leftOut = (frame as Partial<DecodedFrame>).refusals?.[0];
  const help = leftOut === undefined ? '' : ` It left out ${leftOut}.`;
  warn(
    'own-ship-never-seen',
    `No frame has the player's ship ${own}. Check ownShipId, or call setOwnShip.${help}`,
    {
      ownShipId: own,
      ships: ships.slice(0, 10).map((ship) => (ship as ShipState | null)?.shipId),
    },
  );
}

/** s over which the tick rate is measured, and the factor by which it may differ from the rate sent. */
const MEASURED = 3;
const OTHER_RATE = 5;

/** Warns of a tempo that contradicts the ticks: a period for a rate, milliseconds for seconds. A pause or a stall is not a mistake. */
function notePace(warn: Warn, pace: Pace, frame: PartialFrame, now: number): void {
  const { tick, gameTime = Number.NaN } = frame;
  if (typeof tick !== 'number') return;
  if (!(tick >= pace.firstTick) || frame.paused === true || Number.isNaN(pace.tickRate)) {
    Object.assign(pace, { firstTick: tick, firstGameTime: gameTime, firstAt: now });
    Object.assign(pace, { wallDue: 0, gameDue: 0, late: 0 });
  } else if (tick > pace.tick) {
    const due = (tick - pace.tick) / pace.tickRate;
    pace.wallDue += due;
    pace.gameDue += due * pace.timeScale;
    checkTickRate(warn, pace, { tick, now, due });
    checkGameTime(warn, gameTime - pace.firstGameTime, pace.gameDue);
  } else return;
  pace.tick = tick;
  pace.at = now;
  pace.tickRate = frame.tickRate ?? pace.tickRate;
  pace.timeScale = frame.timeScale ?? Number.NaN;
}

/** `due`: wall s that the ticks since the newest frame should have taken. */
function checkTickRate(
  warn: Warn,
  pace: Pace,
  { tick, now, due }: { readonly tick: number; readonly now: number; readonly due: number },
): void {
  const { tickRate, late } = pace;
  const gap = now - pace.at;
  if (late === 0) pace.lateSince = pace.at;
  pace.late = gap > due * OTHER_RATE ? late + 1 : 0;
  const seconds = now - pace.firstAt;
  const isSlow = pace.late >= PATTERN && now - pace.lateSince >= MEASURED;
  const isFast = seconds >= MEASURED && pace.wallDue > seconds * OTHER_RATE;
  if (!isSlow && !isFast) return;
  const come = isSlow ? (tick - pace.tick) / gap : (tick - pace.firstTick) / seconds;
  const message = `tickRate is ${tickRate} Hz, but ${come.toPrecision(3)} ticks arrive per second: pass ticks per second, not the length of a tick.`;
  warn('tick-rate', message, { tickRate, measured: come });
}

/** Game time that grows over a hundred times faster or slower than the tempo is in another unit. */
function checkGameTime(warn: Warn, grown: number, expected: number): void {
  const ratio = grown / expected;
  if (!(ratio > 100 || ratio < 0.01)) return;
  const message = `gameTime grew by ${grown}, but timeScale / tickRate gives ${expected} s: pass seconds.`;
  warn('game-time', message, { grown, expected });
}

/** `view` was called. */
export function noteView(warn: Warn, calls: Calls, now: number): void {
  if (calls.advances > 0 && Number.isFinite(now) && Math.abs(now - calls.advancedAt) > CLOCKS_APART) {
    const details = { now, advancedAt: calls.advancedAt };
    const message = `advance is given ${calls.advancedAt} s, view ${now} s: use one clock for both.`;
    warn('two-clocks', message, details);
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
