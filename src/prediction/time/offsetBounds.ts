/**
 * What is known of the offset, client − server time in seconds, as two bounds (the clock filter of RFC 5905, each way for itself):
 * whatever arrives here was sent before, so each arrival bounds the offset from above; whatever arrived there was sent before, so
 * each answered ping bounds it from below. Queues only ever add to a delay: they make a bound weaker, never wrong. A bound ages by
 * what the two clocks may drift apart. Bounds that contradict each other say that one of the clocks was set anew, or stood.
 */
export interface OffsetBounds {
  upper: number;
  lower: number;
  /** Client wall s to which both are aged. */
  agedTo: number;
  /** The last arrivals in a row that were late, and by much the same: how many, and the newest one's times and delay. */
  late: number;
  lateSent: number;
  lateArrived: number;
}

/** How far two clocks may drift apart, s/s: 500 ppm, and some. */
const DRIFT = 6e-4;
/** An answer within this tells what holds now, s. */
const FRESH = 1;
/** Contradictions up to this are the roundings of clocks, s. */
const MARGIN = 0.005;
/** An arrival this much before the fastest is no luck, s: the bound before was a delayed one, or the server's schedule went ahead. */
const EARLY = 0.1;
/** Later than the fastest by this much, and again and again by the same, is a schedule that was shifted, s. */
const LATE = 0.05;
/** How much two arrivals of a shifted schedule may differ, s. */
const ALIKE = 0.1;
/** Lateness that a network's resends may come to, s: one arrival more has to bear it out. */
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

/** Nothing is known any more. */
export function forgetBounds(bounds: OffsetBounds): void {
  Object.assign(bounds, createOffsetBounds());
}

/** The client's clock went back by `seconds`, and some time passed meanwhile that nobody knows: an upper bound stays one. */
export function shiftBounds(bounds: OffsetBounds, seconds: number): void {
  bounds.upper -= seconds;
  bounds.lower = Number.NEGATIVE_INFINITY;
  bounds.agedTo -= seconds;
  bounds.late = 0;
}

function age(bounds: OffsetBounds, now: number): void {
  const seconds = now - bounds.agedTo;
  if (seconds > 0) {
    bounds.upper += DRIFT * seconds;
    bounds.lower -= DRIFT * seconds;
  }
  // What waited undecoded is received later than it came.
  if (!(now < bounds.agedTo)) bounds.agedTo = now;
}

/** What else is known when a sample is taken, s. */
export interface Sampling {
  /** The least round trip. */
  readonly roundTrip: number;
  /** The grain of the client's clock: 0 for a fine one. */
  readonly grain: number;
  /** Pings are being answered: a shifted schedule shows in the answers. */
  readonly hearsPongs: boolean;
}

/**
 * Something sent at server time `sent` arrived at client time `now`.
 * @returns whether it contradicts what was known: then only this sample counts
 */
export function boundAbove(bounds: OffsetBounds, sent: number, now: number, known: Sampling): boolean {
  age(bounds, now);
  const value = now - sent;
  const isFirst = bounds.upper === Number.POSITIVE_INFINITY;
  const impossible = value < bounds.lower - MARGIN - known.grain;
  const early = !isFirst && value < bounds.upper - EARLY - known.grain;
  if (impossible) bounds.lower = value - known.roundTrip;
  if (value <= bounds.upper) {
    bounds.upper = value;
    bounds.late = 0;
    return impossible || early;
  }
  if (known.hearsPongs || value <= bounds.upper + LATE + known.grain) {
    bounds.late = 0;
    return false;
  }
  if (!isShifted(bounds, sent, now, known.grain)) return false;
  bounds.upper = value;
  bounds.lower = Number.NEGATIVE_INFINITY;
  bounds.late = 0;
  return true;
}

/** Late like the one before and as far behind it as it was sent: no queue that empties, but a schedule that was shifted. */
function isShifted(bounds: OffsetBounds, sent: number, now: number, grain: number): boolean {
  const apart = sent - bounds.lateSent;
  const gap = now - bounds.lateArrived;
  const like = bounds.late > 0 && apart > 0 && Math.abs(gap - apart) <= ALIKE + grain && gap >= apart / 2;
  bounds.late = like ? bounds.late + 1 : 1;
  bounds.lateSent = sent;
  bounds.lateArrived = now;
  return bounds.late >= (now - sent - bounds.upper > RESENT ? 2 : 3);
}

/** s by which a lower bound has aged already: a ping tells what the offset was when it left, and its answer may have waited. */
function agedBy(pinged: number, now: number): number {
  return DRIFT * Math.max(0, now - pinged - FRESH);
}

/**
 * A ping of client time `pinged` was answered while the server stood at server time `stood`: the offset grows until it goes on, so
 * that the answer bounds it from below alone, and what bounded it from above does so no more.
 */
export function boundBelow(
  bounds: OffsetBounds,
  { pinged, stood, now }: { readonly pinged: number; readonly stood: number; readonly now: number },
): void {
  age(bounds, now);
  bounds.lower = Math.max(bounds.lower, pinged - stood - agedBy(pinged, now));
  bounds.upper = Number.POSITIVE_INFINITY;
  bounds.late = 0;
}

/**
 * A ping of client time `pinged` was answered at server time `answered`, and the answer arrived at `now`.
 * @returns whether it contradicts what was known: the bound that it contradicts is forgotten then
 */
export function boundBothSides(
  bounds: OffsetBounds,
  { pinged, answered, now }: { readonly pinged: number; readonly answered: number; readonly now: number },
  grain: number,
): boolean {
  age(bounds, now);
  const low = pinged - answered - agedBy(pinged, now);
  const high = now - answered;
  const margin = MARGIN + grain;
  const wentUp = low > bounds.upper + margin;
  const wentDown = high < bounds.lower - margin;
  bounds.upper = wentUp ? high : Math.min(bounds.upper, high);
  bounds.lower = wentDown ? low : Math.max(bounds.lower, low);
  bounds.late = 0;
  return wentUp || wentDown;
}
