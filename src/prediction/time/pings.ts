import type { Ping } from '../../wire';

/** Pings in flight, which measure the round trip independently of ticks (PREDICTION, Server messages). Client wall s. */
export interface Pings {
  nextId: number;
  nextAt: number;
  readonly sentAt: Float64Array;
  readonly queued: Ping[];
  /** Skipped because the host did not take the waiting ones. */
  dropped: number;
  /** When a ping was last answered, client wall s. */
  answeredAt: number;
}

/** s between pings; the first few are closer together, so that the clock settles. */
const EVERY = 0.2;
const FIRST_EVERY = 0.05;
const FIRST = 8;
/** Most pings that wait to be sent; a host that never takes them gets no more. */
const MAX_QUEUED = 4;
/** Most pings in flight. */
const LENGTH = 256;

export function createPings(): Pings {
  return {
    nextId: 1,
    nextAt: Number.NEGATIVE_INFINITY,
    sentAt: new Float64Array(LENGTH).fill(Number.NaN),
    queued: [],
    dropped: 0,
    answeredAt: Number.NEGATIVE_INFINITY,
  };
}

/** Queues a ping if one is due. */
export function pingIfDue(pings: Pings, now: number): void {
  if (now < pings.nextAt && pings.nextAt - now <= EVERY) return;
  const id = pings.nextId++;
  pings.sentAt[id % LENGTH] = now;
  pings.queued.push({ kind: 'ping', id });
  if (pings.queued.length > MAX_QUEUED) {
    pings.queued.shift();
    pings.dropped += 1;
  }
  pings.nextAt = now + (id <= FIRST ? FIRST_EVERY : EVERY);
}

/** When ping `id` was sent, client wall s; NaN if it was not sent, already answered, or dropped. */
export function answeredPing(pings: Pings, id: number): number {
  if (!(id < pings.nextId && id >= pings.nextId - LENGTH && id >= 1)) return Number.NaN;
  const sent = pings.sentAt[id % LENGTH]!;
  pings.sentAt[id % LENGTH] = Number.NaN;
  return sent;
}

/** Forgets the pings in flight: another server answers, or the page was frozen. */
export function forgetPings(pings: Pings): void {
  pings.sentAt.fill(Number.NaN);
}
