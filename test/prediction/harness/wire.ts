import type { Dice } from './random';

/** A way of a WebSocket: nothing is lost or overtaken on one connection; what waits comes in a burst. */
export interface Way<T> {
  readonly send: (message: T, at: number) => void;
  /** What has come by `t`, in order. */
  readonly take: (t: number) => Arrival<T>[];
  /** Nothing arrives before `until`. */
  readonly hold: (until: number) => void;
  /** Another connection: what is under way comes late, between or after what follows. */
  readonly reconnect: (t: number) => void;
  /** Share of messages that come twice, the copy up to this much later, s. */
  duplicates: { share: number; within: number };
}

export interface WayOptions {
  /** One way, s; and its standard deviation. */
  readonly delay: number;
  readonly jitter: number;
  /** Share of messages that are resent, and how long that takes, s. */
  readonly resent: number;
  readonly resend: number;
}

/** A message, and when it came, true s. */
export interface Arrival<T> {
  readonly message: T;
  at: number;
}

export function createWay<T>(options: WayOptions, dice: Dice): Way<T> {
  let flights: Arrival<T>[] = [];
  let lastAt = 0;
  let heldUntil = 0;
  const noise = () => dice.next() + dice.next() + dice.next() + dice.next() - 2;
  const way: Way<T> = {
    duplicates: { share: 0, within: 0 },
    send(message, at) {
      const resend = dice.chance(options.resent) ? options.resend : 0;
      const delay = Math.max(0, options.delay + options.jitter * 1.7 * noise() + resend);
      lastAt = Math.max(lastAt, at + delay, heldUntil);
      flights.push({ message, at: lastAt });
      if (dice.chance(way.duplicates.share))
        flights.push({ message, at: lastAt + dice.between(0, way.duplicates.within) });
    },
    take(t) {
      const come = flights.filter(({ at }) => at <= t);
      if (come.length === 0) return [];
      flights = flights.filter(({ at }) => at > t);
      return come.sort((a, b) => a.at - b.at);
    },
    hold(until) {
      heldUntil = Math.max(heldUntil, until);
      for (const flight of flights) flight.at = Math.max(flight.at, until);
    },
    reconnect(t) {
      for (const flight of flights) flight.at += dice.between(0, 1);
      lastAt = t;
    },
  };
  return way;
}
