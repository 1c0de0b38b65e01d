import type { Diagnosis } from '../drawn/view';
import { areNumbers } from './shipFault';

/** Checks of a frame that no decoder of this library made; those of a ship are in shipFault.ts. */

/** Highest tick that the wire accepts: sums of two are still exact. */
const MAX_TICK = 2 ** 52;

/** Why a frame cannot be of this tick, or null. */
export function tickFault(tick: number): string | null {
  if (Number.isSafeInteger(tick) && tick >= 0 && tick <= MAX_TICK) return null;
  return `frame.tick: expected a whole number from 0 to 2⁵², got ${String(tick)}`;
}

/** A list of records; anything else is dropped and counted. */
export function recordsOf<T>(
  counters: Diagnosis,
  name: string,
  value: readonly T[] | undefined | null,
): readonly T[] {
  if (!Array.isArray(value)) return [];
  const list = value as readonly T[];
  if (list.every(isRecord)) return list;
  counters.shipsRefused += 1;
  counters.lastRefusal = `frame.${name}: expected records`;
  return list.filter(isRecord);
}

/** Whether a body has a place. */
export function isPlaced({ position }: { readonly position?: unknown }): boolean {
  return areNumbers(position, 3);
}

function isRecord(value: unknown): boolean {
  return typeof value === 'object' && value !== null;
}
