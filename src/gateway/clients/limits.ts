/** Limits on each client's messages and on its state in the gateway. */

/** Maximum bytes of a client's message; a larger one closes the connection with 1009. */
export const MAX_CLIENT_MESSAGE = 64 * 1024;
/** Maximum bytes of a state on /ws, the game's limit. */
export const MAX_STATE = 64 * 1024;
/** Time for a client to sign in, wall s. */
export const AUTH_TIMEOUT = 5;
/** Time for a complete HTTP request to arrive, wall s. */
export const REQUEST_TIMEOUT = 10;
/** Maximum connections of any kind; further ones are dropped at once. */
export const MAX_CONNECTIONS = 4096;
/** Maximum messages queued while a client's token is verified; later ones are dropped. */
export const MAX_QUEUED_MESSAGES = 32;
/** Rate and burst of messages. */
export const MESSAGES = { perSecond: 60, burst: 120 };
/** Rate and burst of input records on /stream. The burst is large because a client resends its last seconds after an outage. */
export const INPUTS = { perSecond: 120, burst: 1024 };
/** Tolerated rate and burst of excess and refused messages; a client that exceeds them is disconnected. */
export const EXCESS = { perSecond: 1, burst: 200 };
/** Bytes buffered in a client's socket above which states are skipped. */
export const MAX_BUFFERED = 256 * 1024;
/** Time for a client to answer a close before its connection is terminated, wall s. */
export const CLOSE_TIMEOUT = 2;
/** Maximum missed events that a client gets when it signs in again. */
export const MAX_RESENT_EVENTS = 500;
/** A client whose socket stays full longer than this is disconnected, wall s. */
export const SLOW_TIMEOUT = 10;
/** Maximum events queued for a slow client; beyond this it is disconnected and must reconnect. */
export const MAX_QUEUED_EVENTS = 1000;
/** Maximum connections from one address. */
export const MAX_PER_ADDRESS = 64;
/** Maximum connections, over all addresses, that have not signed in. */
export const MAX_UNAUTHENTICATED = 256;
/** Maximum inbox entries queued while Redis is unavailable. */
export const MAX_QUEUED_ENTRIES = 2048;

/** Close codes: the game's 4001 and 4003, this gateway's 4008 and 4009, and WebSocket's own. */
export const CLOSE = {
  auth: 4001,
  origin: 4003,
  flood: 4008,
  slow: 4009,
  goingAway: 1001,
  tryLater: 1013,
} as const;

/** A token bucket: refills at a rate; accepted messages take from it. */
export interface Bucket {
  readonly perSecond: number;
  readonly burst: number;
  /** Tokens left at `at`. */
  level: number;
  /** Wall s. */
  at: number;
}

export function createBucket(
  { perSecond, burst }: { perSecond: number; burst: number },
  now: number,
): Bucket {
  return { perSecond, burst, level: burst, at: now };
}

/** Consumes `count` tokens if the bucket has them at `now` (wall s); returns whether it did. */
export function consume(bucket: Bucket, count: number, now: number): boolean {
  bucket.level = Math.min(bucket.burst, bucket.level + Math.max(0, now - bucket.at) * bucket.perSecond);
  bucket.at = now;
  if (bucket.level < count) return false;
  bucket.level -= count;
  return true;
}
