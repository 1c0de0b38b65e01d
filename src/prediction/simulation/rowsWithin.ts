import { ROW_BYTES } from './fitRings';

/** Bytes that the histories of all ships but the own one may take. */
const HISTORY_BYTES = 32 * 2 ** 20;
/** Rows that every ship keeps, however many there are. */
const MIN_ROWS = 12;

/** Rows that each of `ships` ships may keep. `ships` is rounded up to a power of two, so that a growing fleet seldom changes it. */
export function rowsWithin(ships: number): number {
  const rounded = 2 ** Math.ceil(Math.log2(Math.max(1, ships)));
  return Math.max(MIN_ROWS, Math.floor(HISTORY_BYTES / (rounded * ROW_BYTES)));
}
