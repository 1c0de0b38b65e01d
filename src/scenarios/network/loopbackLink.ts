import { type Authority, type Loop, runNextTick, setFrozen, skipBacklog, startLoop } from '../../authority';
import { decodeClientMessage, encodeServerMessage, type ServerMessage } from '../../wire';
import { createLink, type Delivery, type Link, type NetworkNumbers } from './network';

/**
 * An authority on a wall clock that is handed in, and its clients, each behind a simulated connection that carries the protocol's
 * bytes: what the page's worker runs, and tests and benchmarks without a page.
 */
export interface Exchange {
  readonly authority: Authority;
  readonly loop: Loop;
  readonly counters: Readonly<ExchangeCounters>;
  /** A client joins, is told the hello and sent the present frame; or the reason why it cannot. */
  readonly connect: (playerId: string, shipId: string, now: number) => string | null;
  /** The client's connection breaks. The server flies its ship on. */
  readonly drop: (playerId: string) => void;
  /** The client joins again over a new connection. */
  readonly reconnect: (playerId: string, now: number) => void;
  /** From a client, as bytes. */
  readonly send: (playerId: string, bytes: Uint8Array, now: number) => void;
  /** What has come to a client by `now`. */
  readonly deliver: (playerId: string, now: number) => Delivery[];
  /** Lets everything up to `now` happen at its own time and in its order: arrivals at the server, and ticks. */
  readonly run: (now: number) => void;
  /** When something happens next: an arrival at either end, or a tick. */
  readonly nextAt: () => number;
  /** A frozen server neither ticks, sends nor answers. What came meanwhile, it reads when it goes on. */
  readonly setFrozen: (frozen: boolean, now: number) => void;
  /** While paused: one tick or one substep at once, with the frames before and after it. */
  readonly step: (unit: 'substep' | 'tick', now: number) => string | null;
  readonly setNetwork: (numbers: NetworkNumbers) => void;
}

export interface ExchangeCounters {
  framesSent: number;
  bytesSent: number;
  /** Messages of clients that wire or authority refused. */
  refused: number;
  /** Why, the last time. */
  lastRefusal: string;
}

interface Line {
  readonly playerId: string;
  readonly shipId: string;
  readonly up: Link;
  readonly down: Link;
}

/** @param now wall seconds at which the authority's present boundary is */
export function createExchange(
  authority: Authority,
  network: NetworkNumbers,
  seed: number,
  now: number,
): Exchange {
  const loop = startLoop(authority, now);
  const lines = new Map<string, Line>();
  const counters: ExchangeCounters = { framesSent: 0, bytesSent: 0, refused: 0, lastRefusal: '' };
  let numbers = network;
  let links = 0;
  let thawedAt = -Infinity;

  function newLink(): Link {
    links += 1;
    // Far apart, so that two links share no stretch of their numbers' beginning.
    return createLink(numbers, seed + links * 0x9e3779b1);
  }

  function tell(line: Line, message: ServerMessage, at: number): void {
    const bytes = encodeServerMessage(message);
    counters.bytesSent += bytes.length;
    line.down.send(bytes, at);
  }

  function tellFrame(line: Line, at: number): void {
    const frame = authority.frameFor(line.playerId);
    if (frame === null) return;
    counters.framesSent += 1;
    tell(line, frame, at);
  }

  function tellFrames(at: number): void {
    for (const line of lines.values()) tellFrame(line, at);
  }

  function welcome(line: Line, at: number): string | null {
    const hello = authority.join(line.playerId, line.shipId);
    if (!hello.ok) return hello.reason;
    if (hello.value !== null) tell(line, hello.value, at);
    tellFrame(line, at);
    return null;
  }

  function hear(line: Line, { bytes }: Delivery, at: number): void {
    const message = decodeClientMessage(bytes);
    const answer = message.ok ? authority.receive(line.playerId, message.value, at) : message;
    if (!answer.ok) {
      counters.refused += 1;
      counters.lastRefusal = answer.reason;
    } else if (answer.value !== null) tell(line, answer.value, at);
  }

  /** The line whose client's message reaches the server first. */
  function firstUp(): { line: Line | null; at: number } {
    let first: Line | null = null;
    let at = Infinity;
    for (const line of lines.values()) {
      const next = line.up.nextAt();
      if (next === null || next >= at) continue;
      first = line;
      at = next;
    }
    return { line: first, at };
  }

  return {
    authority,
    loop,
    counters,
    connect(playerId, shipId, at) {
      const line: Line = { playerId, shipId, up: newLink(), down: newLink() };
      const reason = welcome(line, at);
      if (reason === null) lines.set(playerId, line);
      return reason;
    },
    drop(playerId) {
      lines.get(playerId)?.up.drop();
      lines.get(playerId)?.down.drop();
    },
    reconnect(playerId, at) {
      const line = lines.get(playerId);
      if (line === undefined) return;
      line.up.reconnect(at);
      line.down.reconnect(at);
      welcome(line, at);
    },
    send: (playerId, bytes, at) => lines.get(playerId)?.up.send(bytes, at),
    deliver: (playerId, at) => lines.get(playerId)?.down.deliver(at) ?? [],
    run(until) {
      if (loop.frozen) return;
      skipBacklog(loop, authority, until);
      while (true) {
        const { line, at } = firstUp();
        // What arrives with a boundary is in time for the interval before it.
        if (line !== null && at <= Math.min(until, loop.nextAt)) {
          for (const delivery of line.up.deliver(at)) hear(line, delivery, Math.max(at, thawedAt));
        } else if (loop.nextAt <= until) tellFrames(runNextTick(loop, authority));
        else return;
      }
    },
    nextAt() {
      let next = loop.frozen ? Infinity : Math.min(loop.nextAt, firstUp().at);
      for (const { down } of lines.values()) next = Math.min(next, down.nextAt() ?? Infinity);
      return next;
    },
    setFrozen(frozen, at) {
      if (loop.frozen && !frozen) thawedAt = at;
      setFrozen(loop, authority, frozen, at);
    },
    step(unit, at) {
      const reason = authority.armStep(unit);
      if (reason !== null) return reason;
      tellFrames(at);
      authority.tick(at);
      tellFrames(at);
      return null;
    },
    setNetwork(next) {
      numbers = next;
      for (const { up, down } of lines.values()) {
        up.setNumbers(next);
        down.setNumbers(next);
      }
    },
  };
}
