import { type Cadence, sendSeconds } from './cadence';

/** State of the connection between client and server (PREDICTION, Clock). */
export type Connection =
  /** No frame has arrived yet. */
  | 'waiting'
  /** Frames arrive as usual. */
  | 'live'
  /** No frames, but pings are answered, or the server is paused. */
  | 'serverPaused'
  /** No frames, of a server that has never answered a ping: it is paused or the link has stalled, which look the same. */
  | 'silent'
  /** Neither frames nor answers: the link has stalled, or the page was frozen. */
  | 'stalled'
  /** The same for so long that the server counts as lost. */
  | 'gone';

/** Pings count as answered if a pong arrived within this, s. */
const ANSWERED = 1;
/** Silence after which the server counts as lost: the longer of this, s, and this many sends. */
const GONE = 10;
const GONE_SENDS = 5;
/** Silence after which a state is stale: the longer of this, s, and two sends. A stall of a mobile link alone takes 0.2 s. */
const STALE_AFTER = 0.3;
const STALE_SENDS = 2;
/** The same while the send interval is unknown, s. */
const FIRST_SENDS = 1.5;

/** Silence after which a ship's state is stale, s, with a server of `tickRate` Hz. */
export function staleAfter(cadence: Cadence, tickRate: number): number {
  const least = cadence.ticks === 0 ? FIRST_SENDS : STALE_AFTER;
  return Math.max(STALE_SENDS * sendSeconds(cadence, tickRate), least);
}

/** Client wall s since the last message of each kind. */
export interface SinceLast {
  readonly frame: number;
  readonly pong: number;
}

export function connectionOf(
  since: SinceLast,
  cadence: Cadence,
  { tickRate, paused }: { readonly tickRate: number; readonly paused: boolean },
): Connection {
  if (since.frame === Number.POSITIVE_INFINITY) return 'waiting';
  const isLive = since.frame <= staleAfter(cadence, tickRate);
  if (isLive) return paused ? 'serverPaused' : 'live';
  if (since.pong <= ANSWERED) return 'serverPaused';
  if (since.pong === Number.POSITIVE_INFINITY) return paused ? 'serverPaused' : 'silent';
  const silence = Math.min(since.frame, since.pong);
  return silence > Math.max(GONE, GONE_SENDS * sendSeconds(cadence, tickRate)) ? 'gone' : 'stalled';
}
