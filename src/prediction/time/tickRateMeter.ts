import { MAX_RATE, MIN_RATE } from '../../dynamics';

/**
 * The tick rate of a server that does not send it, measured from the ticks of its frames and their arrivals (PREDICTION, Timeline).
 * A frame arrives with a delay, never early: the schedule is the line under the arrivals, as in Moon's estimate of clock skew. A pause, or
 * another rate, leaves the arrivals on two lines; the newer one counts.
 */
export interface TickRateMeter {
  /** Of at most two frames per TOGETHER, oldest first. */
  readonly arrivals: Arrival[];
  /** The accepted measurement, Hz; NaN until arrivals agree. */
  rate: number;
  /** How much later than the least delayed frames the newest arrived, s. */
  late: number;
  /** Whether the rate of the frame being received, and of the one before, is sent or measured; otherwise it is assumed. */
  isKnown: boolean;
  wasKnown: boolean;
}

/** A frame's tick, and its arrival, client wall s. */
interface Arrival {
  readonly tick: number;
  readonly at: number;
}

/** Arrivals kept. */
const MAX_ARRIVALS = 64;
/** Of the frames that arrive within this, the newest waited least, s. */
const TOGETHER = 0.125;
/** Arrivals that agree without an earlier measurement, and against one. */
const NEEDED = 3;
const NEEDED_TO_CHANGE = 4;
/** s that arrivals must span to contradict a measurement. */
const CHANGED_FOR = 1;
/** How late arrivals of one schedule may be: a share of the time they span, at most JITTER, s. */
const SHARE = 0.05;
const JITTER = 0.1;
/** Delays count as varying by at least this, s, so that no measurement counts as more accurate than it can be. */
const FINEST = 0.005;
/** Steps towards the line under the arrivals; a few suffice. */
const MAX_STEPS = 8;

export function createTickRateMeter(): TickRateMeter {
  return { arrivals: [], rate: Number.NaN, late: 0, isKnown: false, wasKnown: false };
}

/** Whether the game can have a tick rate, Hz. */
export function isTickRate(rate = Number.NaN): boolean {
  return rate >= MIN_RATE && rate <= MAX_RATE;
}

/**
 * Takes the arrival of a frame at client wall second `now`.
 * @returns the measured rate, Hz, or null if none is known yet
 */
export function measureTickRate(meter: TickRateMeter, tick: number, now: number): number | null {
  const { arrivals } = meter;
  // A restarted server, or an overtaken frame.
  while ((arrivals.at(-1)?.tick ?? tick) > tick) arrivals.pop();
  if (arrivals.at(-1)?.tick !== tick) {
    if (now - (arrivals.at(-2)?.at ?? Number.NEGATIVE_INFINITY) < TOGETHER) arrivals.pop();
    arrivals.push({ tick, at: now });
    if (arrivals.length > MAX_ARRIVALS) arrivals.shift();
    meter.late = 0;
    weigh(meter);
  }
  return Number.isNaN(meter.rate) ? null : meter.rate;
}

/** Accepts the line under all arrivals if most of either half are near it and it still holds, else that under the newest ones. */
function weigh(meter: TickRateMeter): void {
  const { arrivals } = meter;
  if (arrivals.length < NEEDED) return;
  const whole = lineUnder(arrivals, 0);
  const half = Math.ceil(arrivals.length / 2);
  const usual = Math.max(medianOf(whole.delays.slice(0, half)), medianOf(whole.delays.slice(half)));
  const stillHolds = whole.delays.slice(-NEEDED).some((delay) => delay <= whole.tolerance);
  if (stillHolds && usual <= whole.tolerance) {
    accept(meter, whole, 2 * Math.max(usual, FINEST));
    return;
  }
  const from = newestFrom(meter);
  const newest = lineUnder(arrivals, from);
  if (newest.delays.some((delay) => delay > newest.tolerance)) return;
  // A queue that drains looks like a higher rate, but its frames are late.
  const isFaster = newest.perTick < 1 / meter.rate;
  const early = arrivals.at(-1)!;
  if (isFaster && earliest([...arrivals.slice(0, from), early], 1 / meter.rate) !== early) return;
  if (!accept(meter, newest, newest.tolerance)) return;
  // Which of the others are older than the change is not known.
  arrivals.splice(0, arrivals.length - 2);
}

/** The first of the fewest newest arrivals that can contradict a measurement. */
function newestFrom({ arrivals, rate }: TickRateMeter): number {
  const needed = Number.isNaN(rate) ? NEEDED : NEEDED_TO_CHANGE;
  const span = Number.isNaN(rate) ? 0 : CHANGED_FOR;
  let from = Math.max(0, arrivals.length - needed);
  while (from > 0 && arrivals.at(-1)!.at - arrivals[from]!.at < span) from--;
  return from;
}

/** A line under arrivals. */
interface Line {
  /** Its slope, wall s per tick. */
  readonly perTick: number;
  /** Wall s between the two arrivals on it, and how late each may be. */
  readonly apart: number;
  readonly tolerance: number;
  /** How late each arrived, s. */
  readonly delays: readonly number[];
}

function medianOf(delays: readonly number[]): number {
  return [...delays].sort((a, b) => a - b)[delays.length >> 1]!;
}

/** The line between the least delayed arrival of either half, from arrival `from` on: no arrival is under it. */
function lineUnder(arrivals: readonly Arrival[], from: number): Line {
  const used = arrivals.slice(from);
  const half = Math.ceil(used.length / 2);
  const earlier = used.slice(0, half);
  const later = used.slice(half);
  // Not known yet: begins with the first of either half.
  let perTick = Number.NaN;
  for (let step = 0; step < MAX_STEPS; step++)
    perTick = slopeOf(earliest(earlier, perTick), earliest(later, perTick));
  const before = earliest(earlier, perTick);
  const after = earliest(later, perTick);
  const tolerance = Math.min(JITTER, SHARE * (used.at(-1)!.at - used[0]!.at));
  const delays = used.map(({ tick, at }) => at - before.at - (tick - before.tick) * perTick);
  return { perTick, apart: after.at - before.at, tolerance, delays };
}

function slopeOf(before: Arrival, after: Arrival): number {
  return (after.at - before.at) / (after.tick - before.tick);
}

/** The least delayed of arrivals on a schedule of `perTick` wall s per tick. */
function earliest(arrivals: readonly Arrival[], perTick: number): Arrival {
  const origin = arrivals[0]!.tick;
  return arrivals.reduce((least, one) =>
    one.at - (one.tick - origin) * perTick < least.at - (least.tick - origin) * perTick ? one : least,
  );
}

/**
 * Accepts the rate of a line whose ends are known within `doubt` s, unless the known rate is within that uncertainty. Returns false for a
 * rate that the game cannot have.
 */
function accept(meter: TickRateMeter, { perTick, apart, delays }: Line, doubt: number): boolean {
  const rate = 1 / perTick;
  const uncertainty = (rate * doubt) / apart;
  const rounded = roundest(rate, uncertainty);
  if (!isTickRate(rounded)) return false;
  meter.late = delays.at(-1)!;
  if (!(Math.abs(meter.rate - rate) <= uncertainty)) meter.rate = rounded;
  return true;
}

/** With as many, every double is itself. */
const DIGITS_OF_DOUBLE = 17;

/** The number with the fewest digits within `uncertainty` of `rate`: servers are set to such rates. */
function roundest(rate: number, uncertainty: number): number {
  for (let digits = 1; digits < DIGITS_OF_DOUBLE; digits++) {
    const rounded = Number(rate.toPrecision(digits));
    if (Math.abs(rounded - rate) <= uncertainty) return rounded;
  }
  return rate;
}
