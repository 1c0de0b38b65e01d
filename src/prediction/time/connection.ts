import { type Cadence, sendSeconds } from './cadence';

/** State of the connection between client and server (PREDICTION, Clock). */
export type Connection =
  /** No frame has arrived yet. */
  | 'waiting'
  /** Frames arrive as usual. */
  | 'live'
  /** No frames, but pings are answered, or the server is paused. */
  | 'serverPaused'
  /** Neither frames nor answers: the link has stalled, or the page was frozen. */
  | 'stalled'
  /** The same for so long that waiting is pointless. */
  | 'gone';

/** Pings are answered if one was within this, s. */
const ANSWERED = 1;
/** Silence after which the server counts as lost, s, and in sends. */
const GONE = 10;
const GONE_SENDS = 5;
/** Silent for two sends, and at fast servers for this long, a state is stale, s: a stall of a mobile link alone is 0.2 s. */
const STALE_AFTER = 0.3;
const STALE_SENDS = 2;
/** How late the second frame may be while the send interval is unknown, s. */
const FIRST_SENDS = 1.5;

/** Silence after which a ship's state is stale, s, at a server of `tickRate` Hz. */
export function staleAfter(cadence: Cadence, tickRate: number): number {
  const least = cadence.ticks === 0 ? FIRST_SENDS : STALE_AFTER;
  return Math.max(STALE_SENDS * sendSeconds(cadence, tickRate), least);
}

/** Client wall s since each kind of message. */
export interface Heard {
  readonly frame: number;
  readonly pong: number;
}

export function connectionOf(
  heard: Heard,
  cadence: Cadence,
  { tickRate, paused }: { readonly tickRate: number; readonly paused: boolean },
): Connection {
  if (heard.frame === Number.POSITIVE_INFINITY) return 'waiting';
  const isLive = heard.frame <= staleAfter(cadence, tickRate);
  if (isLive) return paused ? 'serverPaused' : 'live';
  if (heard.pong <= ANSWERED) return 'serverPaused';
  const silence = Math.min(heard.frame, heard.pong);
  const isGone = silence > Math.max(GONE, GONE_SENDS * sendSeconds(cadence, tickRate));
  if (isGone) return 'gone';
  return paused && heard.pong === Number.POSITIVE_INFINITY ? 'serverPaused' : 'stalled';
}
