import { LANDED } from '../../dynamics';
import { beginLog, LOG_STRIDE, LOGGED_STATE } from './touchdownLog';

/** The touchdown logs of the player's ship, one for each of its rows. */
export interface TouchdownRing {
  /** At the front. */
  readonly front: Float64Array;
  /** Where the replay is. */
  readonly replayed: Float64Array;
  /** At tick boundaries: slot = tick mod length. */
  kept: Float64Array[];
  /** The tick each slot holds, -1 for none. */
  ticks: Float64Array;
}

/** The state to which the player's ship is reset: the row at `from` in `rows`, at tick boundary `tick`. */
export interface Adopted {
  tick: number;
  rows: Float64Array;
  from: number;
}

export function createTouchdownRing(length: number): TouchdownRing {
  return {
    front: new Float64Array(LOG_STRIDE),
    replayed: new Float64Array(LOG_STRIDE),
    kept: emptyLogs(length),
    ticks: new Float64Array(length).fill(Number.NEGATIVE_INFINITY),
  };
}

/** Keeps a log as the one at tick boundary `tick`. */
export function keepLog(ring: TouchdownRing, tick: number, log: Float64Array): void {
  const slot = tick % ring.kept.length;
  ring.kept[slot]!.set(log);
  ring.ticks[slot] = tick;
}

/** The log at tick boundary `tick`, or null. */
export function logAt({ kept, ticks }: TouchdownRing, tick: number): Float64Array | null {
  const slot = tick % kept.length;
  return ticks[slot] === tick ? kept[slot]! : null;
}

/** Forgets every log after `tick`. */
export function forgetLogsAfter({ ticks }: TouchdownRing, tick: number): void {
  for (let slot = 0; slot < ticks.length; slot++)
    if (ticks[slot]! > tick) ticks[slot] = Number.NEGATIVE_INFINITY;
}

/** The same logs in a ring of another length; the newest win a slot. */
export function resizeLogs(ring: TouchdownRing, length: number): void {
  const { kept, ticks } = ring;
  ring.kept = emptyLogs(length);
  ring.ticks = new Float64Array(length).fill(Number.NEGATIVE_INFINITY);
  for (const [slot, tick] of ticks.entries())
    if (tick > ring.ticks[tick % length]!) keepLog(ring, tick, kept[slot]!);
}

/** A ship first seen landed has no touchdown. */
export function logLanded({ front }: TouchdownRing): void {
  if (front[LOGGED_STATE] !== LANDED) beginLog(front, LANDED);
}

function emptyLogs(length: number): Float64Array[] {
  return Array.from({ length }, () => new Float64Array(LOG_STRIDE));
}
