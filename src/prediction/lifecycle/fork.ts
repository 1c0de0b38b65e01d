import type { Session } from '../session';
import type { LatestMessages } from './snapshot';

/** Everything a predictor owns: its session, and the messages of its next snapshot. */
export interface Owned {
  readonly session: Session;
  readonly kept: LatestMessages;
}

/**
 * A second copy of what a predictor owns, which continues independently with the same bits. Constants (options, worlds, messages) and
 * functions are shared; listeners are not copied.
 */
export function copyOwned({ session, kept }: Owned): Owned {
  const { options, terrains, defaults, config, warn } = session;
  const copies = new Map<object, object>();
  for (const shared of [options, terrains, defaults, config, warn]) copies.set(shared, shared);
  copies.set(session.listeners, new Set());
  // The cuts are most of the memory and are recomputed from the boundaries.
  const { cuts } = session.sim.bodies;
  copies.set(
    cuts,
    cuts.map(() => ({ tick: -1, made: 0, rows: [] })),
  );
  return { session: copyOf(session, copies), kept: { ...kept } };
}

/** Deep copy of records, lists, maps, sets and arrays of numbers; shared references stay shared. */
function copyOf<T>(value: T, copies: Map<object, object>): T {
  if (typeof value !== 'object' || value === null || Object.isFrozen(value)) return value;
  const known = copies.get(value);
  if (known !== undefined) return known as T;
  if (ArrayBuffer.isView(value)) return remember(value, (value as unknown as Float64Array).slice(), copies);
  if (value instanceof Map) {
    const copy = remember(value, new Map<unknown, unknown>(), copies);
    for (const [key, item] of value) (copy as Map<unknown, unknown>).set(key, copyOf(item, copies));
    return copy;
  }
  if (value instanceof Set) {
    const copy = remember(value, new Set<unknown>(), copies);
    for (const item of value) (copy as Set<unknown>).add(copyOf(item, copies));
    return copy;
  }
  const copy = remember(value, Array.isArray(value) ? [...(value as unknown[])] : { ...value }, copies);
  for (const [key, item] of Object.entries(value))
    if (typeof item === 'object') (copy as Record<string, unknown>)[key] = copyOf(item, copies);
  return copy;
}

function remember<T extends object>(value: T, copy: object, copies: Map<object, object>): T {
  copies.set(value, copy);
  return copy as T;
}
