import type { PendingMessage, WorldEvent } from '../../wire';

/**
 * Received frames that are not decoded yet. The next `advance` decodes the newest few and reads only the events of those they supersede,
 * so that a page hidden for minutes returns at once.
 */
export interface PendingFrames {
  readonly queue: Waiting[];
  /** Of superseded frames, in order. */
  readonly events: WorldEvent[];
}

/** A message and its arrival: the caller's `now`, and client wall s. */
export interface Waiting {
  readonly message: PendingMessage;
  readonly now: number;
  readonly at: number;
}

/** Events of superseded frames that are kept; the oldest go first. */
export const MAX_KEPT_EVENTS = 1000;
