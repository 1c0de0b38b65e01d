/** How often the server sends: a server may tick fifty times a second and send once. Staleness and fading count sends, not ticks. */
export interface Cadence {
  /** Ticks sent so far, each counted once. */
  sends: number;
  /** Usual number of ticks between two sends; 0 before the second. */
  ticks: number;
  readonly recent: number[];
}

/** Number of sends whose median spacing counts as usual, so that an occasional loss does not matter. */
const RECENT = 7;

export function createCadence(): Cadence {
  return { sends: 0, ticks: 0, recent: [] };
}

/** Records a newer tick, sent `ticks` after the one before; 0 if there is no comparable one before. */
export function noteSend(cadence: Cadence, ticks: number): void {
  cadence.sends += 1;
  if (ticks <= 0) return;
  cadence.recent.push(ticks);
  if (cadence.recent.length > RECENT) cadence.recent.shift();
  const sorted = [...cadence.recent].sort((a, b) => a - b);
  cadence.ticks = sorted[Math.floor((sorted.length - 1) / 2)]!;
}

/**
 * The tick rate changes from `before` to `after` Hz. Until the next send shows whether the interval stays the same in seconds or in ticks,
 * the longer of the two is used.
 */
export function followTickRate(cadence: Cadence, before: number, after: number): void {
  if (before === after) return;
  cadence.recent.length = 0;
  cadence.ticks = Math.max(cadence.ticks, Math.round((cadence.ticks * after) / before));
}

/** A new timeline: the spacing of the last one's sends is used until its second send. */
export function forgetCadence(cadence: Cadence): void {
  cadence.recent.length = 0;
}

/** Usual wall s from one send to the next, at a server of `tickRate` Hz; one tick until it is known. */
export function sendSeconds({ ticks }: Cadence, tickRate: number): number {
  return Math.max(1, ticks) / tickRate;
}

/**
 * Longest prediction past the newest frame, wall s: three sends, or the length of a network stall. If the server answers no pings, a pause
 * shows only as silence: until the next send is overdue, by the longest of the last intervals.
 */
export function horizonOf(cadence: Cadence, tickRate: number, answersPings: boolean): number {
  let longest = 0;
  if (!answersPings) for (const ticks of cadence.recent) longest = Math.max(longest, ticks);
  return longest === 0 ? Math.max(HORIZON, 3 * sendSeconds(cadence, tickRate)) : longest / tickRate + OVERDUE;
}

const HORIZON = 5;
/** A send this late is overdue, s: more than jitter delays it. */
const OVERDUE = 0.75;
