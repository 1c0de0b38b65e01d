/** Limits of one client's messages, and of its state in the gateway. */

/** Bytes of a message from a client; larger ones close the connection with 1009. */
export const MAX_CLIENT_MESSAGE = 64 * 1024;
/** Bytes of a state on /ws, as the game has it. */
export const MAX_STATE = 64 * 1024;
/** Wall s for a client to sign in. */
export const AUTH_WITHIN = 5;
/** Wall s for an HTTP request to come in whole. */
export const REQUEST_WITHIN = 10;
/** Connections of any kind; more are cut at once. */
export const MAX_CONNECTIONS = 4096;
/** Messages kept while a client's token is verified; later ones are dropped. */
export const MAX_EARLY = 32;
/** Messages a second, and how many at once. */
export const MESSAGES = { perSecond: 60, burst: 120 };
/** Input records a second on /stream, and how many at once: after an outage a client sends its last seconds again. */
export const INPUTS = { perSecond: 120, burst: 1024 };
/** Messages beyond the rate, and such as are refused, a second and at once; a client with more is sent away. */
export const EXCESS = { perSecond: 1, burst: 200 };
/** Bytes waiting in a client's socket above which states are skipped. */
export const MAX_BUFFERED = 256 * 1024;
/** Wall s for which a client may be that slow. */
export const SLOW_FOR = 10;
/** Events waiting for a slow client; beyond this it is disconnected and starts again. */
export const MAX_EVENTS_WAITING = 1000;
/** Connections from one address, and such as have not signed in. */
export const MAX_FROM_ADDRESS = 64;
export const MAX_UNSIGNED = 256;
/** Entries that wait for Redis to come back. */
export const MAX_WAITING = 2048;

/** Close codes: the game's two, and this gateway's own. */
export const CLOSE = {
  auth: 4001,
  origin: 4003,
  flood: 4008,
  slow: 4009,
  goingAway: 1001,
  tryLater: 1013,
} as const;

/** A token bucket: fills at a rate, emptied by accepted messages. */
export interface Bucket {
  readonly perSecond: number;
  readonly burst: number;
  level: number;
  at: number;
}

export function createBucket(
  { perSecond, burst }: { perSecond: number; burst: number },
  now: number,
): Bucket {
  return { perSecond, burst, level: burst, at: now };
}

/** Whether `count` may pass at wall second `now`. */
export function take(bucket: Bucket, count: number, now: number): boolean {
  bucket.level = Math.min(bucket.burst, bucket.level + Math.max(0, now - bucket.at) * bucket.perSecond);
  bucket.at = now;
  if (bucket.level < count) return false;
  bucket.level -= count;
  return true;
}
