import { ok, type Result, err } from '../../dynamics';
import { normalNoise, createRandom, type Random } from './random';

/**
 * One direction of a simulated WebSocket connection: messages are never lost, only late. A lost packet is sent again, and everything
 * sent after it waits (head-of-line blocking). Wall seconds are arguments; the same seed gives the same delays.
 */
export interface NetworkNumbers {
  /** One way, s. */
  readonly delay: number;
  /** Standard deviation of the delay, s; no packet deviates by more than three of them. */
  readonly jitter: number;
  /** Share of packets that are lost once and sent again. */
  readonly stallShare: number;
  /** Delay of sending it again, s. */
  readonly stallSeconds: number;
  /** Mean number of packets lost in a row: Gilbert–Elliott's bad state. */
  readonly stallRun: number;
}

const STEADY = { stallShare: 0, stallSeconds: 0.2, stallRun: 1 };

/** The networks of PREDICTION, Measurements: ± is a standard deviation, and a loss is a resend after 200 ms. */
export const NETWORK_PRESETS = Object.freeze({
  lan: { ...STEADY, delay: 0.002, jitter: 0 },
  broadband: { ...STEADY, delay: 0.02, jitter: 0.003 },
  fourG: { delay: 0.05, jitter: 0.008, stallShare: 0.02, stallSeconds: 0.2, stallRun: 1.5 },
  satellite: { ...STEADY, delay: 0.3, jitter: 0.015 },
  broken: { delay: 0.1, jitter: 0.03, stallShare: 0.1, stallSeconds: 0.2, stallRun: 2 },
}) satisfies Readonly<Record<string, NetworkNumbers>>;

export type NetworkPreset = keyof typeof NETWORK_PRESETS;

const RANGES: Readonly<Record<keyof NetworkNumbers, readonly [number, number, string]>> = {
  delay: [0, 10, 's'],
  jitter: [0, 5, 's'],
  stallShare: [0, 0.9, ''],
  stallSeconds: [0, 10, 's'],
  stallRun: [1, 100, 'packets'],
};

/** The numbers, or an error that names the one out of range. */
export function loadNetwork(given: NetworkNumbers): Result<NetworkNumbers> {
  for (const [name, [low, high, unit]] of Object.entries(RANGES)) {
    const value: unknown = given[name as keyof NetworkNumbers];
    if (typeof value !== 'number' || !(value >= low && value <= high))
      return err(`${name}: expected ${low} to ${high} ${unit}`.trimEnd() + `, got ${String(value)}`);
  }
  const { delay, jitter, stallShare, stallSeconds, stallRun } = given;
  // The chain leaves the good state with probability share/(1 − share)/run per packet.
  const most = stallRun / (stallRun + 1);
  if (stallShare > most)
    return err(`stallShare: expected at most ${most} with runs of ${stallRun}, got ${stallShare}`);
  return ok({ delay, jitter, stallShare, stallSeconds, stallRun });
}

export interface Delivery {
  readonly bytes: Uint8Array;
  /** Wall seconds. */
  readonly at: number;
}

/** Monotonic. */
export interface LinkCounters {
  sent: number;
  /** Packets lost once and sent again. */
  stalled: number;
  /** Across reconnects: messages delivered twice, delivered after newer ones, never delivered. */
  duplicated: number;
  reordered: number;
  lost: number;
}

export interface Link {
  readonly send: (bytes: Uint8Array, now: number) => void;
  /** The messages that have arrived by `now`, in the order of arrival. */
  readonly deliver: (now: number) => Delivery[];
  /** When the next message arrives, or null. */
  readonly nextAt: () => number | null;
  /** Applies to messages sent from now on. */
  readonly setNumbers: (numbers: NetworkNumbers) => void;
  /** Nothing that is sent from now on arrives before wall second `until`. */
  readonly stall: (until: number) => void;
  /** Breaks the connection: nothing arrives, and messages sent are lost. */
  readonly drop: () => void;
  /**
   * Opens a new connection. Each message in flight when the old one broke may still be delivered from its buffers, may be sent again on
   * the new one, both or neither, at random.
   */
  readonly reconnect: (now: number) => void;
  readonly counters: Readonly<LinkCounters>;
}

interface Flight extends Delivery {
  /** Its position in the order of sending. */
  readonly order: number;
}

export function createLink(initial: NetworkNumbers, seed: number): Link {
  const rng = createRandom(seed);
  const counters: LinkCounters = { sent: 0, stalled: 0, duplicated: 0, reordered: 0, lost: 0 };
  const chain = createStalls(rng);
  let numbers = initial;
  let flights: Flight[] = [];
  let down = false;
  let lastAt = -Infinity;
  let newestOrder = 0;

  function fly(bytes: Uint8Array, order: number, now: number): void {
    const stalled = chain(numbers);
    if (stalled) counters.stalled += 1;
    const late = numbers.delay + numbers.jitter * normalNoise(rng) + (stalled ? numbers.stallSeconds : 0);
    // Within a connection, messages keep their order.
    lastAt = Math.max(lastAt, now + Math.max(0, late));
    insert(flights, { bytes, order, at: lastAt });
  }

  return {
    counters,
    send(bytes, now) {
      counters.sent += 1;
      if (down) counters.lost += 1;
      else fly(bytes, counters.sent, now);
    },
    deliver(now) {
      if (down) return [];
      let due = 0;
      while (due < flights.length && flights[due]!.at <= now) due++;
      const delivered = flights.slice(0, due);
      flights = flights.slice(due);
      for (const { order } of delivered) {
        if (order < newestOrder) counters.reordered += 1;
        newestOrder = Math.max(newestOrder, order);
      }
      return delivered;
    },
    nextAt: () => (down ? null : (flights[0]?.at ?? null)),
    setNumbers(next) {
      numbers = next;
    },
    stall: (until) => void (lastAt = Math.max(lastAt, until)),
    drop() {
      down = true;
    },
    reconnect(now) {
      const under = flights;
      flights = [];
      down = false;
      lastAt = now;
      for (const flight of under) {
        const [buffered, again] = [rng() < 0.5, rng() < 0.5];
        // Old buffers drain within about one more delay.
        if (buffered)
          insert(flights, { ...flight, at: Math.max(flight.at, now + 2 * numbers.delay * rng()) });
        if (again) fly(flight.bytes, flight.order, now);
        if (buffered && again) counters.duplicated += 1;
        if (!buffered && !again) counters.lost += 1;
      }
    },
  };
}

/** Gilbert–Elliott: whether the next packet is lost. In the long run a share of stallShare, in runs of stallRun on average. */
function createStalls(rng: Random): (numbers: NetworkNumbers) => boolean {
  let bad = false;
  return ({ stallShare, stallRun }) => {
    const leave = 1 / stallRun;
    const enter = (stallShare * leave) / (1 - stallShare);
    bad = rng() < (bad ? 1 - leave : enter);
    return bad;
  };
}

function insert(flights: Flight[], flight: Flight): void {
  let i = flights.length;
  while (i > 0 && flights[i - 1]!.at > flight.at) i--;
  flights.splice(i, 0, flight);
}
