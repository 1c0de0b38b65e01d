import { ok, type Result, err } from '../../dynamics';
import { bell, createDice, type Dice } from './random';

/**
 * One direction of a WebSocket over a network, simulated: it never loses a message, it is late. A lost packet is sent again, and
 * all that was sent after it waits behind it (head-of-line blocking). Wall seconds, handed in; a seed gives the same delays always.
 */
export interface NetworkNumbers {
  /** One way, s. */
  readonly delay: number;
  /** Standard deviation of the delay, s; no packet is off by more than three of them. */
  readonly jitter: number;
  /** Share of packets that are lost once and sent again. */
  readonly stallShare: number;
  /** What sending it again costs, s. */
  readonly stallSeconds: number;
  /** Packets lost in a row, on average: Gilbert–Elliott's bad state. */
  readonly stallRun: number;
}

const STEADY = { stallShare: 0, stallSeconds: 0.2, stallRun: 1 };

/** The networks of PREDICTION, What is measured: ± is taken for a standard deviation, and loss for a resend after 200 ms. */
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

/** The numbers, or a reason that names the one out of its range. */
export function loadNetwork(given: NetworkNumbers): Result<NetworkNumbers> {
  for (const [name, [low, high, unit]] of Object.entries(RANGES)) {
    const value: unknown = given[name as keyof NetworkNumbers];
    if (typeof value !== 'number' || !(value >= low && value <= high))
      return err(`${name}: expected ${low} to ${high} ${unit}`.trimEnd() + `, got ${String(value)}`);
  }
  const { delay, jitter, stallShare, stallSeconds, stallRun } = given;
  // The chain leaves the good state with share/(1 − share)/run a packet, which must be a probability.
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

/** Monotone. */
export interface LinkCounters {
  sent: number;
  /** Lost once, and late for it. */
  stalled: number;
  /** Across reconnects: sent again though it had come, come after younger ones, never come. */
  duplicated: number;
  reordered: number;
  lost: number;
}

export interface Link {
  readonly send: (bytes: Uint8Array, now: number) => void;
  /** What has arrived by `now`, in the order of arrival. */
  readonly deliver: (now: number) => Delivery[];
  /** When the next message arrives, or null. */
  readonly nextAt: () => number | null;
  /** For messages sent from now on. */
  readonly setNumbers: (numbers: NetworkNumbers) => void;
  /** The connection breaks: nothing arrives, what is sent is lost. */
  readonly drop: () => void;
  /**
   * A new connection. Of what was under way when the old one broke, each message may still come out of the old one's buffers, may be
   * sent again on the new one, both or neither: a die decides.
   */
  readonly reconnect: (now: number) => void;
  readonly counters: Readonly<LinkCounters>;
}

interface Flight extends Delivery {
  /** The how-manieth sent. */
  readonly order: number;
}

export function createLink(initial: NetworkNumbers, seed: number): Link {
  const dice = createDice(seed);
  const counters: LinkCounters = { sent: 0, stalled: 0, duplicated: 0, reordered: 0, lost: 0 };
  const chain = createStalls(dice);
  let numbers = initial;
  let flights: Flight[] = [];
  let down = false;
  let lastAt = -Infinity;
  let newestOrder = 0;

  function fly(bytes: Uint8Array, order: number, now: number): void {
    const stalled = chain(numbers);
    if (stalled) counters.stalled += 1;
    const late = numbers.delay + numbers.jitter * bell(dice) + (stalled ? numbers.stallSeconds : 0);
    // In order: nothing overtakes within a connection.
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
    drop() {
      down = true;
    },
    reconnect(now) {
      const under = flights;
      flights = [];
      down = false;
      lastAt = now;
      for (const flight of under) {
        const [buffered, again] = [dice() < 0.5, dice() < 0.5];
        // Old buffers empty within about one more delay.
        if (buffered)
          insert(flights, { ...flight, at: Math.max(flight.at, now + 2 * numbers.delay * dice()) });
        if (again) fly(flight.bytes, flight.order, now);
        if (buffered && again) counters.duplicated += 1;
        if (!buffered && !again) counters.lost += 1;
      }
    },
  };
}

/** Gilbert–Elliott: whether the next packet is lost. Its long-run share is stallShare, its runs are stallRun long on average. */
function createStalls(dice: Dice): (numbers: NetworkNumbers) => boolean {
  let bad = false;
  return ({ stallShare, stallRun }) => {
    const leave = 1 / stallRun;
    const enter = (stallShare * leave) / (1 - stallShare);
    bad = dice() < (bad ? 1 - leave : enter);
    return bad;
  };
}

function insert(flights: Flight[], flight: Flight): void {
  let i = flights.length;
  while (i > 0 && flights[i - 1]!.at > flight.at) i--;
  flights.splice(i, 0, flight);
}
