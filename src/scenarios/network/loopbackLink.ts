import { type Authority, type Loop, runNextTick, setFrozen, skipBacklog, startLoop } from '../../authority';
import { decodeClientMessage, encodeServerMessage, type ServerMessage } from '../../wire';
import { createLink, type Delivery, type Link, type NetworkNumbers } from './network';

/**
 * An authority and its clients, each behind a simulated connection that carries the protocol's bytes; run by the page's worker, and by
 * tests and benchmarks without a page. Wall seconds are arguments.
 */
export interface LoopbackLink {
  readonly authority: Authority;
  readonly loop: Loop;
  readonly counters: Readonly<LoopbackCounters>;
  /** A client joins and is sent the hello and the present frame; returns null, or the reason why it cannot join. */
  readonly connect: (playerId: string, shipId: string, now: number) => string | null;
  /** Breaks the client's connection. The server keeps simulating its ship. */
  readonly drop: (playerId: string) => void;
  /** The client rejoins over a new connection. */
  readonly reconnect: (playerId: string, now: number) => void;
  /** Sends a client's message, as bytes. */
  readonly send: (playerId: string, bytes: Uint8Array, now: number) => void;
  /** The messages that have reached a client by `now`. */
  readonly deliver: (playerId: string, now: number) => Delivery[];
  /** Processes everything due by `now` in order of time: arrivals at the server, and ticks. */
  readonly run: (now: number) => void;
  /** When the next arrival, at either end, or tick is due. */
  readonly nextAt: () => number;
  /** A frozen server neither ticks, sends nor answers. It reads what arrived meanwhile when it resumes. */
  readonly setFrozen: (frozen: boolean, now: number) => void;
  /** While paused: runs one tick or one substep, and sends the frames before and after it. */
  readonly step: (unit: 'substep' | 'tick', now: number) => string | null;
  /** `up`: of messages to the server, where they differ. */
  readonly setNetwork: (numbers: NetworkNumbers, up?: NetworkNumbers) => void;
  /** A lag spike: nothing that is sent from now on arrives before wall second `until`, in either direction. */
  readonly stall: (until: number) => void;
}

export interface LoopbackCounters {
  framesSent: number;
  bytesSent: number;
  /** Client messages that the wire or the authority refused. */
  refused: number;
  /** The reason of the last refusal. */
  lastRefusal: string;
}

interface Connection {
  readonly playerId: string;
  readonly shipId: string;
  readonly up: Link;
  readonly down: Link;
}

/** @param now wall seconds at which the authority's present boundary is */
export function createLoopbackLink(
  authority: Authority,
  network: NetworkNumbers,
  seed: number,
  now: number,
): LoopbackLink {
  const loop = startLoop(authority, now);
  const connections = new Map<string, Connection>();
  const counters: LoopbackCounters = { framesSent: 0, bytesSent: 0, refused: 0, lastRefusal: '' };
  let numbers = network;
  let upNumbers = network;
  let links = 0;
  let resumedAt = -Infinity;

  function newLink(numbers: NetworkNumbers): Link {
    links += 1;
    // Seeds far apart, so that the random sequences of two links do not overlap.
    return createLink(numbers, seed + links * 0x9e3779b1);
  }

  function send(connection: Connection, message: ServerMessage, at: number): void {
    const bytes = encodeServerMessage(message);
    counters.bytesSent += bytes.length;
    connection.down.send(bytes, at);
  }

  function sendFrame(connection: Connection, at: number): void {
    const frame = authority.frameFor(connection.playerId);
    if (frame === null) return;
    counters.framesSent += 1;
    send(connection, frame, at);
  }

  function sendFrames(at: number): void {
    for (const connection of connections.values()) sendFrame(connection, at);
  }

  function welcome(connection: Connection, at: number): string | null {
    const hello = authority.join(connection.playerId, connection.shipId);
    if (!hello.ok) return hello.reason;
    if (hello.value !== null) send(connection, hello.value, at);
    sendFrame(connection, at);
    return null;
  }

  function handle(connection: Connection, { bytes }: Delivery, at: number): void {
    const message = decodeClientMessage(bytes);
    const answer = message.ok ? authority.receive(connection.playerId, message.value, at) : message;
    if (!answer.ok) {
      counters.refused += 1;
      counters.lastRefusal = answer.reason;
    } else if (answer.value !== null) send(connection, answer.value, at);
  }

  /** The connection whose message reaches the server first. */
  function firstUp(): { connection: Connection | null; at: number } {
    let first: Connection | null = null;
    let at = Infinity;
    for (const connection of connections.values()) {
      const next = connection.up.nextAt();
      if (next === null || next >= at) continue;
      first = connection;
      at = next;
    }
    return { connection: first, at };
  }

  return {
    authority,
    loop,
    counters,
    connect(playerId, shipId, at) {
      const connection: Connection = { playerId, shipId, up: newLink(upNumbers), down: newLink(numbers) };
      const reason = welcome(connection, at);
      if (reason === null) connections.set(playerId, connection);
      return reason;
    },
    drop(playerId) {
      connections.get(playerId)?.up.drop();
      connections.get(playerId)?.down.drop();
    },
    reconnect(playerId, at) {
      const connection = connections.get(playerId);
      if (connection === undefined) return;
      connection.up.reconnect(at);
      connection.down.reconnect(at);
      welcome(connection, at);
    },
    send: (playerId, bytes, at) => connections.get(playerId)?.up.send(bytes, at),
    deliver: (playerId, at) => connections.get(playerId)?.down.deliver(at) ?? [],
    run(until) {
      if (loop.frozen) return;
      skipBacklog(loop, authority, until);
      while (true) {
        const { connection, at } = firstUp();
        // A message that arrives at a boundary is in time for the interval before it.
        if (connection !== null && at <= Math.min(until, loop.nextAt)) {
          for (const delivery of connection.up.deliver(at))
            handle(connection, delivery, Math.max(at, resumedAt));
        } else if (loop.nextAt <= until) sendFrames(runNextTick(loop, authority));
        else return;
      }
    },
    nextAt() {
      let next = loop.frozen ? Infinity : Math.min(loop.nextAt, firstUp().at);
      for (const { down } of connections.values()) next = Math.min(next, down.nextAt() ?? Infinity);
      return next;
    },
    setFrozen(frozen, at) {
      if (loop.frozen && !frozen) resumedAt = at;
      setFrozen(loop, authority, frozen, at);
    },
    step(unit, at) {
      const reason = authority.armStep(unit);
      if (reason !== null) return reason;
      sendFrames(at);
      authority.tick(at);
      sendFrames(at);
      return null;
    },
    setNetwork(next, upNext = next) {
      numbers = next;
      upNumbers = upNext;
      for (const { up, down } of connections.values()) {
        up.setNumbers(upNext);
        down.setNumbers(next);
      }
    },
    stall(until) {
      for (const { up, down } of connections.values()) {
        up.stall(until);
        down.stall(until);
      }
    },
  };
}
