/** How often the server sends: a server may tick fifty times a second and send once. Staleness and fading count sends, not ticks. */
export interface Cadence {
  /** Ticks sent so far, each counted once. */
  sends: number;
  /** Usual ticks from one send to the next; 0 before two were seen. */
  ticks: number;
  readonly recent: number[];
}

/** Sends of which the usual distance is the median: one in a few may be missed. */
const RECENT = 7;

export function createCadence(): Cadence {
  return { sends: 0, ticks: 0, recent: [] };
}

/** The server sent a newer tick, `ticks` after the one before; 0: nothing comparable came before. */
export function noteSend(cadence: Cadence, ticks: number): void {
  cadence.sends += 1;
  if (ticks <= 0) return;
  cadence.recent.push(ticks);
  if (cadence.recent.length > RECENT) cadence.recent.shift();
  const sorted = [...cadence.recent].sort((a, b) => a - b);
  cadence.ticks = sorted[Math.floor((sorted.length - 1) / 2)]!;
}

/** Another time: distances between its sends are not known yet. */
export function forgetCadence(cadence: Cadence): void {
  cadence.recent.length = 0;
  cadence.ticks = 0;
}

/** Usual wall s from one send to the next, at a server of `tickRate` Hz; one tick before anything is known. */
export function sendSeconds({ ticks }: Cadence, tickRate: number): number {
  return Math.max(1, ticks) / tickRate;
}

/** Wall s that are predicted past the newest frame at most: three sends, and what a stall of a network may be. */
export function horizonOf(cadence: Cadence, tickRate: number): number {
  return Math.max(HORIZON, 3 * sendSeconds(cadence, tickRate));
}

const HORIZON = 5;
