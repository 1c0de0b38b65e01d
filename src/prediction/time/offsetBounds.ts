/**
 * The offset, client − server time in seconds, as two bounds (the clock filter of RFC 5905, separately for each direction). A message is
 * sent before it arrives: each arrival bounds the offset from above, each answered ping from below. Queueing only adds delay, so it makes
 * a bound weaker, never wrong. A bound ages by the largest drift of the two clocks. Bounds that contradict each other mean that one of
 * the clocks has jumped or stopped.
 */
export interface OffsetBounds {
  upper: number;
  lower: number;
  /** Client wall s to which both are aged. */
  agedTo: number;
  /** Consecutive arrivals that were late by about the same: their number, and the newest one's times and delay. */
  late: number;
  lateSent: number;
  lateArrived: number;
}

/** Largest drift between two clocks, s/s: slightly more than 500 ppm. */
const DRIFT = 6e-4;
/** An answer within this is current, s. */
const FRESH = 1;
/** Contradictions up to this are rounding errors of clocks, s. */
const MARGIN = 0.005;
/** An arrival this much before the fastest is significant, s: the old bound was delayed, or the server's schedule moved ahead. */
const EARLY = 0.1;
/** Arrivals repeatedly later than the fastest by the same amount, at least this much, mean a shifted schedule, s. */
const LATE = 0.05;
/** How much two arrivals of a shifted schedule may differ, s. */
const ALIKE = 0.1;
/** Lateness that resent packets can cause, s: one more arrival must confirm it. */
const RESENT = 0.35;

export function createOffsetBounds(): OffsetBounds {
  return {
    upper: Number.POSITIVE_INFINITY,
    lower: Number.NEGATIVE_INFINITY,
    agedTo: Number.NaN,
    late: 0,
    lateSent: 0,
    lateArrived: 0,
  };
}

/** Forgets both bounds. */
export function forgetBounds(bounds: OffsetBounds): void {
  Object.assign(bounds, createOffsetBounds());
}

/** Forgets the lower bound: the client's clock stopped for an unknown time, after which the upper bound is still valid. */
export function forgetLower(bounds: OffsetBounds): void {
  bounds.lower = Number.NEGATIVE_INFINITY;
  bounds.late = 0;
}

function age(bounds: OffsetBounds, now: number): void {
  const seconds = now - bounds.agedTo;
  if (seconds > 0) {
    bounds.upper += DRIFT * seconds;
    bounds.lower -= DRIFT * seconds;
  }
  // Undecoded messages are received later than they arrived.
  if (!(now < bounds.agedTo)) bounds.agedTo = now;
}

/** Estimates that a sample is judged by, s. */
export interface Sampling {
  /** The smallest round trip. */
  readonly roundTrip: number;
  /** Smallest step of the client's clock, s; 0 for a fine one. */
  readonly clockStep: number;
  /** Pings are being answered: a shifted schedule shows in the answers. */
  readonly hearsPongs: boolean;
  /** The first message after a silence, of a server that answers no pings: if it is late, the server paused, or others follow at once. */
  readonly isOverdue: boolean;
}

/**
 * Takes a message sent at server time `sent` that arrived at client time `now`.
 * @returns whether it contradicts the bounds: then only this sample counts
 */
export function boundAbove(bounds: OffsetBounds, sent: number, now: number, known: Sampling): boolean {
  age(bounds, now);
  const value = now - sent;
  const isFirst = bounds.upper === Number.POSITIVE_INFINITY;
  const impossible = value < bounds.lower - MARGIN - known.clockStep;
  const early = !isFirst && value < bounds.upper - EARLY - known.clockStep;
  if (impossible) bounds.lower = value - known.roundTrip;
  if (value <= bounds.upper) {
    bounds.upper = value;
    bounds.late = 0;
    return impossible || early;
  }
  if (known.hearsPongs || value <= bounds.upper + LATE + known.clockStep) {
    bounds.late = 0;
    return false;
  }
  if (!known.isOverdue && !isShifted(bounds, sent, now, known.clockStep)) return false;
  bounds.upper = value;
  bounds.lower = Number.NEGATIVE_INFINITY;
  bounds.late = 0;
  return true;
}

/** Whether the arrival is as late as the one before, and spaced as sent: a shifted schedule, not a draining queue. */
function isShifted(bounds: OffsetBounds, sent: number, now: number, clockStep: number): boolean {
  const apart = sent - bounds.lateSent;
  const gap = now - bounds.lateArrived;
  const like = bounds.late > 0 && apart > 0 && Math.abs(gap - apart) <= ALIKE + clockStep && gap >= apart / 2;
  bounds.late = like ? bounds.late + 1 : 1;
  bounds.lateSent = sent;
  bounds.lateArrived = now;
  return bounds.late >= (now - sent - bounds.upper > RESENT ? 2 : 3);
}

/** Age of a lower bound on arrival, s: a ping bounds the offset at its sending, and its answer may have waited. */
function ageOnArrival(pinged: number, now: number): number {
  return DRIFT * Math.max(0, now - pinged - FRESH);
}

/**
 * Takes the answer to a ping of client time `pinged` by a server that stopped at server time `stopped`. The offset grows until it resumes, so
 * the answer bounds it only from below, and the upper bound becomes invalid.
 */
export function boundBelow(
  bounds: OffsetBounds,
  { pinged, stopped, now }: { readonly pinged: number; readonly stopped: number; readonly now: number },
): void {
  age(bounds, now);
  bounds.lower = Math.max(bounds.lower, pinged - stopped - ageOnArrival(pinged, now));
  bounds.upper = Number.POSITIVE_INFINITY;
  bounds.late = 0;
}

/**
 * Takes the answer to a ping of client time `pinged`, sent at server time `answered`, that arrived at `now`.
 * @returns whether it contradicts a bound, which is then dropped
 */
export function boundBothSides(
  bounds: OffsetBounds,
  { pinged, answered, now }: { readonly pinged: number; readonly answered: number; readonly now: number },
  clockStep: number,
): boolean {
  age(bounds, now);
  const low = pinged - answered - ageOnArrival(pinged, now);
  const high = now - answered;
  const margin = MARGIN + clockStep;
  const wentUp = low > bounds.upper + margin;
  const wentDown = high < bounds.lower - margin;
  bounds.upper = wentUp ? high : Math.min(bounds.upper, high);
  bounds.lower = wentDown ? low : Math.max(bounds.lower, low);
  bounds.late = 0;
  return wentUp || wentDown;
}
