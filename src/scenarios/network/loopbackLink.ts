import { type Authority, type Loop, runNextTick, setFrozen, skipBacklog, startLoop } from '../../authority';
import { decodeClientMessage, encodeServerMessage, type ServerMessage } from '../../wire';
import { createLink, type Delivery, type Link, type NetworkNumbers } from './network';

/**
 * An authority and its clients, each behind a simulated connection for the protocol's bytes; run by the page's worker, and by
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
  /** A frozen server neither ticks, sends nor answers. On resuming it reads the messages that arrived meanwhile. */
  readonly setFrozen: (frozen: boolean, now: number) => void;
  /** While paused: runs one tick or one substep, and sends the frames before and after it. */
  readonly step: (unit: 'substep' | 'tick', now: number) => string | null;
  /** `up`: of messages to the server, where they differ. */
  readonly setNetwork: (numbers: NetworkNumbers, up?: NetworkNumbers) => void;
  /** A lag spike: nothing that is sent from now on arrives before wall second `until`, in either direction. */
  readonly stall: (until: number) => void;
}

export interface LoopbackCounters {
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

interface LinkState {
  readonly authority: Authority;
  readonly loop: Loop;
  readonly counters: LoopbackCounters;
  readonly seed: number;
  /** By player. */
  readonly connections: Map<string, Connection>;
  numbers: NetworkNumbers;
  upNumbers: NetworkNumbers;
  linksOpened: number;
  /** Wall seconds at which the last freeze ended. */
  resumedAt: number;
}

/** @param now wall seconds at which the authority's present boundary is */
export function createLoopbackLink(
  authority: Authority,
  network: NetworkNumbers,
  seed: number,
  now: number,
): LoopbackLink {
  const state: LinkState = {
    authority,
    loop: startLoop(authority, now),
    counters: { refused: 0, lastRefusal: '' },
    seed,
    connections: new Map(),
    numbers: network,
    upNumbers: network,
    linksOpened: 0,
    resumedAt: -Infinity,
  };
  const { loop, counters, connections } = state;
  return {
    authority,
    loop,
    counters,
    connect: (playerId, shipId, at) => connect(state, playerId, shipId, at),
    drop(playerId) {
      connections.get(playerId)?.up.drop();
      connections.get(playerId)?.down.drop();
    },
    reconnect(playerId, at) {
      const connection = connections.get(playerId);
      if (connection === undefined) return;
      connection.up.reconnect(at);
      connection.down.reconnect(at);
      welcome(state, connection, at);
    },
    send: (playerId, bytes, at) => connections.get(playerId)?.up.send(bytes, at),
    deliver: (playerId, at) => connections.get(playerId)?.down.deliver(at) ?? [],
    run(until) {
      run(state, until);
    },
    nextAt: () => nextAt(state),
    setFrozen(frozen, at) {
      if (loop.frozen && !frozen) state.resumedAt = at;
      setFrozen(loop, authority, frozen, at);
    },
    step: (unit, at) => step(state, unit, at),
    setNetwork(next, upNext = next) {
      state.numbers = next;
      state.upNumbers = upNext;
      for (const { up, down } of connections.values()) {
        up.setNumbers(upNext);
        down.setNumbers(next);
      }
    },
    stall: (until) => connections.forEach(({ up, down }) => [up, down].forEach((link) => link.stall(until))),
  };
}

function connect(state: LinkState, playerId: string, shipId: string, at: number): string | null {
  const connection: Connection = {
    playerId,
    shipId,
    up: openLink(state, state.upNumbers),
    down: openLink(state, state.numbers),
  };
  const reason = welcome(state, connection, at);
  if (reason === null) state.connections.set(playerId, connection);
  return reason;
}

function openLink(state: LinkState, numbers: NetworkNumbers): Link {
  state.linksOpened += 1;
  // Seeds far apart, so that the random sequences of two links do not overlap.
  return createLink(numbers, state.seed + state.linksOpened * 0x9e3779b1);
}

function welcome(state: LinkState, connection: Connection, at: number): string | null {
  const hello = state.authority.join(connection.playerId, connection.shipId);
  if (!hello.ok) return hello.reason;
  if (hello.value !== null) sendDown(connection, hello.value, at);
  sendFrame(state, connection, at);
  return null;
}

function sendDown({ down }: Connection, message: ServerMessage, at: number): void {
  down.send(encodeServerMessage(message), at);
}

function sendFrame({ authority }: LinkState, connection: Connection, at: number): void {
  const frame = authority.frameFor(connection.playerId);
  if (frame !== null) sendDown(connection, frame, at);
}

function sendFrames(state: LinkState, at: number): void {
  for (const connection of state.connections.values()) sendFrame(state, connection, at);
}

function run(state: LinkState, until: number): void {
  const { authority, loop, resumedAt } = state;
  if (loop.frozen) return;
  skipBacklog(loop, authority, until);
  while (true) {
    const { connection, at } = firstArrival(state);
    // A message that arrives at a boundary is in time for the interval before it.
    if (connection !== null && at <= Math.min(until, loop.nextAt)) {
      for (const delivery of connection.up.deliver(at))
        receive(state, connection, delivery, Math.max(at, resumedAt));
    } else if (loop.nextAt <= until) sendFrames(state, runNextTick(loop, authority));
    else return;
  }
}

function receive(state: LinkState, connection: Connection, { bytes }: Delivery, at: number): void {
  const { authority, counters } = state;
  const message = decodeClientMessage(bytes);
  const answer = message.ok ? authority.receive(connection.playerId, message.value, at) : message;
  if (!answer.ok) {
    counters.refused += 1;
    counters.lastRefusal = answer.reason;
  } else if (answer.value !== null) sendDown(connection, answer.value, at);
}

/** The connection whose message reaches the server first, and when. */
function firstArrival({ connections }: LinkState): { connection: Connection | null; at: number } {
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

function nextAt(state: LinkState): number {
  const { loop, connections } = state;
  let next = loop.frozen ? Infinity : Math.min(loop.nextAt, firstArrival(state).at);
  for (const { down } of connections.values()) next = Math.min(next, down.nextAt() ?? Infinity);
  return next;
}

function step(state: LinkState, unit: 'substep' | 'tick', at: number): string | null {
  const reason = state.authority.armStep(unit);
  if (reason !== null) return reason;
  sendFrames(state, at);
  state.authority.tick(at);
  sendFrames(state, at);
  return null;
}
