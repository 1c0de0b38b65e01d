/**
 * The last delays of one kind, s: the smallest, and the spread above it. Kept by count, not by time: after a silence the
 * last ones are still the best estimate.
 */
export interface Delays {
  readonly values: Float64Array;
  readonly sorted: Float64Array;
  /** Samples ever taken; slot = count mod length. */
  count: number;
  /** The last result of `spreadOf`, and its limit; NaN after a new delay: every frame needs it, and few add a delay. */
  spread: number;
  spreadLimit: number;
}

/** Share of the samples below `spreadOf`. */
const MOST = 0.95;
/** Share of the samples without resent packets; the limit is LIMIT times their spread, and at least MIN_LIMIT, s. */
const USUAL = 0.8;
const LIMIT = 1.5;
const MIN_LIMIT = 0.02;

/** @param length number of samples kept */
export function createDelays(length: number): Delays {
  return {
    values: new Float64Array(length),
    sorted: new Float64Array(length),
    count: 0,
    spread: Number.NaN,
    spreadLimit: Number.NaN,
  };
}

export function addDelay(delays: Delays, value: number): void {
  delays.values[delays.count % delays.values.length] = value;
  delays.count += 1;
  delays.spread = Number.NaN;
}

/** Lowers the last delay to `value` if that is smaller: both waited in one queue, of which the smallest delay counts. */
export function lowerDelay(delays: Delays, value: number): void {
  const { values, count } = delays;
  const slot = (count - 1) % values.length;
  values[slot] = Math.min(values[slot]!, value);
  delays.spread = Number.NaN;
}

/** The smallest delay, s; NaN without samples. */
export function minDelay({ values, count }: Delays): number {
  const n = Math.min(count, values.length);
  if (n === 0) return Number.NaN;
  let least = values[0]!;
  for (let i = 1; i < n; i++) if (values[i]! < least) least = values[i]!;
  return least;
}

/**
 * The spread above the smallest delay that 19 of 20 do not exceed, s; delays more than `most` above it are not counted. 0 without samples. Among a
 * few dozen delays, two or three resent packets are one in twenty and come and go: they count at most LIMIT times the usual
 * spread.
 */
export function spreadOf(delays: Delays, most: number): number {
  if (Number.isNaN(delays.spread) || delays.spreadLimit !== most) {
    delays.spread = measureSpread(delays, most);
    delays.spreadLimit = most;
  }
  return delays.spread;
}

function measureSpread(delays: Delays, most: number): number {
  const least = minDelay(delays);
  if (Number.isNaN(least)) return 0;
  const { values, sorted, count } = delays;
  let n = 0;
  for (let i = 0; i < Math.min(count, values.length); i++)
    if (values[i]! - least <= most) sorted[n++] = values[i]! - least;
  sorted.fill(Number.POSITIVE_INFINITY, n);
  sorted.sort();
  const at = (share: number) => sorted[Math.floor(n * share)]!;
  return Math.min(at(MOST), Math.max(MIN_LIMIT, LIMIT * at(USUAL)));
}
