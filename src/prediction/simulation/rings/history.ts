import { SHIP_STRIDE } from '../../../dynamics';

/**
 * A ring of one ship's predicted rows at tick boundaries (PREDICTION, Reconciliation): slot = tick mod length.
 * A row is the state in the server's frame of that tick, before the tick's inputs and choice of reference body.
 */
export interface History {
  readonly length: number;
  readonly rows: Float64Array;
  /** The tick each slot holds, -1 for none. */
  readonly ticks: Float64Array;
}

/** Ticks in 10 s of wall time, but at least 12, so that slow servers have a history too. */
export function ringLength(tickRate: number): number {
  return Math.max(12, Math.ceil(10 * tickRate) + 2);
}

export function createHistory(length: number): History {
  return {
    length,
    rows: new Float64Array(length * SHIP_STRIDE),
    ticks: new Float64Array(length).fill(Number.NEGATIVE_INFINITY),
  };
}

/** Keeps a row as the state at `tick`. */
export function keep(history: History, tick: number, rows: Float64Array, at: number): void {
  const slot = tick % history.length;
  const to = slot * SHIP_STRIDE;
  for (let k = 0; k < SHIP_STRIDE; k++) history.rows[to + k] = rows[at + k]!;
  history.ticks[slot] = tick;
}

/** Whether the state at `tick` is kept. */
export function has(history: History, tick: number): boolean {
  return history.ticks[tick % history.length] === tick;
}

/** Offset of the row at `tick` in `rows`. Throws if `has` is false: a bug of the predictor, never a fault of its input. */
export function offsetOf(history: History, tick: number): number {
  const slot = tick % history.length;
  const held = history.ticks[slot]!;
  if (held !== tick) {
    throw new RangeError(
      `history: expected tick ${tick} in its slot, got ${held < 0 ? 'none' : `tick ${held}`}`,
    );
  }
  return slot * SHIP_STRIDE;
}

/** Forgets every state after `tick`. */
export function forgetAfter(history: History, tick: number): void {
  for (let slot = 0; slot < history.length; slot++) {
    if (history.ticks[slot]! > tick) history.ticks[slot] = Number.NEGATIVE_INFINITY;
  }
}

/** The same states in a ring of another length; the newest win a slot. */
export function resized(history: History, length: number): History {
  const next = createHistory(length);
  for (let slot = 0; slot < history.length; slot++) {
    const tick = history.ticks[slot]!;
    if (tick > next.ticks[tick % length]!) keep(next, tick, history.rows, slot * SHIP_STRIDE);
  }
  return next;
}

/** Bytes of a predicted state. */
export const ROW_BYTES = SHIP_STRIDE * 8;
/** Bytes that the histories of all ships but the player’s may take. */
const HISTORY_BYTES = 32 * 2 ** 20;
/** Rows that every ship keeps, however many there are. */
const MIN_ROWS = 12;

/** Rows that each of `ships` ships may keep. `ships` is rounded up to a power of two, so that a growing fleet seldom changes it. */
export function rowsWithin(ships: number): number {
  const rounded = 2 ** Math.ceil(Math.log2(Math.max(1, ships)));
  return Math.max(MIN_ROWS, Math.floor(HISTORY_BYTES / (rounded * ROW_BYTES)));
}
