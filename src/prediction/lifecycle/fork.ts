import type { Session } from '../session';
import { createSubstepRows } from '../snapshots/bodies/bodyTrack';
import type { LatestMessages } from './snapshot';

/** Everything a predictor owns: its session, and the messages of its next snapshot. */
export interface Owned {
  readonly session: Session;
  readonly kept: LatestMessages;
}

/**
 * A copy of a predictor's state, which continues independently with the same bits. Constants (options, worlds, messages) and
 * functions are shared; listeners are not copied.
 */
export function copyOwned({ session, kept }: Owned): Owned {
  const { options, terrains, defaults, config, warn } = session;
  const copying: Copying = { copies: new Map(), chunk: new ArrayBuffer(CHUNK), used: 0 };
  const { copies } = copying;
  for (const shared of [options, terrains, defaults, config, warn]) copies.set(shared, shared);
  copies.set(session.listeners, new Set());
  // They are most of the memory and are recomputed from the boundaries.
  const { substepRows } = session.sim.bodies;
  copies.set(substepRows, substepRows.map(createSubstepRows));
  return { session: copyOf(session, copying), kept: { ...kept } };
}

/** Bytes of the buffers that a copy's arrays share: the garbage collector's time grows with the number of buffers. */
const CHUNK = 1 << 15;

interface Copying {
  /** The copy of each original. */
  readonly copies: Map<object, object>;
  /** Where the next array goes, and how many bytes of it are in use. */
  chunk: ArrayBuffer;
  used: number;
}

/** A copy of an array of numbers in the shared buffer; a larger array gets a buffer. */
function copyArray(from: Float64Array, copying: Copying): Float64Array {
  const bytes = Math.ceil(from.byteLength / 8) * 8;
  if (bytes > CHUNK / 4) return from.slice();
  if (copying.used + bytes > CHUNK) {
    copying.chunk = new ArrayBuffer(CHUNK);
    copying.used = 0;
  }
  const Numbers = from.constructor as Float64ArrayConstructor;
  const copy = new Numbers(copying.chunk, copying.used, from.length);
  copying.used += bytes;
  copy.set(from);
  return copy;
}

/** Deep copy of records, lists, maps, sets and arrays of numbers; shared references stay shared. */
function copyOf<T>(value: T, copying: Copying): T {
  if (typeof value !== 'object' || value === null || Object.isFrozen(value)) return value;
  const known = copying.copies.get(value);
  if (known !== undefined) return known as T;
  if (ArrayBuffer.isView(value))
    return remember(value, copyArray(value as unknown as Float64Array, copying), copying);
  if (value instanceof Map) {
    const copy = remember(value, new Map<unknown, unknown>(), copying);
    for (const [key, item] of value) (copy as Map<unknown, unknown>).set(key, copyOf(item, copying));
    return copy;
  }
  if (value instanceof Set) {
    const copy = remember(value, new Set<unknown>(), copying);
    for (const item of value) (copy as Set<unknown>).add(copyOf(item, copying));
    return copy;
  }
  const copy = remember(value, Array.isArray(value) ? [...(value as unknown[])] : { ...value }, copying);
  for (const [key, item] of Object.entries(value))
    if (typeof item === 'object') (copy as Record<string, unknown>)[key] = copyOf(item, copying);
  return copy;
}

function remember<T extends object>(value: T, copy: object, copying: Copying): T {
  copying.copies.set(value, copy);
  return copy as T;
}
