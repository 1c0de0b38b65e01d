import { describe, expect, it } from 'vitest';
import { decodePending, receivePending } from '../../../src/prediction/snapshots/pending';
import type { PendingMessage, ServerMessage, WorldEvent } from '../../../src/wire';
import { frameAt, helloAt } from '../faults/restingShip';
import { RATE, sessionAt } from '../decisions/sessionAt';

const TICK = 100;
const event = (tick: number): WorldEvent => ({ type: 'ship.contact', shipId: 'own', tick, substep: 0 });

const waitingFrame = (tick: number, events: readonly WorldEvent[] = []): PendingMessage =>
  ({
    isFrame: true,
    events: () => events,
    decode: () => ({ ok: true, value: frameAt(tick, RATE, { events: [...events] }) }),
  }) as never;
const waitingHello = (): PendingMessage =>
  ({ isFrame: false, events: () => [], decode: () => ({ ok: true, value: helloAt(TICK, RATE) }) }) as never;

/** A session and what it has received: kind, tick, number of events, and when. */
function waiting() {
  const session = sessionAt(TICK);
  session.setBack = 1;
  const received: unknown[] = [];
  const take = (message: ServerMessage, now: number, at: number) =>
    received.push([
      message.kind,
      message.kind === 'frame' ? [message.tick, message.events.map(({ tick }) => tick)] : null,
      now,
      at,
    ]);
  return {
    session,
    received,
    receive: (message: PendingMessage, now: number) => receivePending(session, message, now, take as never),
    decode: () => decodePending(session, take as never),
  };
}

it.each([null, undefined, 'bytes', new Uint8Array(3), { ok: true, value: {} }, frameAt(TICK, RATE)])(
  'a value that is no pending message is refused by name: %s',
  (value) => {
    const { session, received, receive, decode } = waiting();
    receive(value as never, 5);
    decode();
    expect(received).toEqual([]);
    expect(session.counters.framesRefused).toBe(1);
    expect(session.counters.lastRefusal).toMatch(
      /^message: expected what pendingServerMessage returns, got ./,
    );
  },
);

describe('frames that wait undecoded', () => {
  it('are received in their order, as of their arrival', () => {
    const { received, receive, decode } = waiting();
    decode();
    receive(waitingFrame(101), 5);
    receive(waitingFrame(102), 6);
    expect(received).toEqual([]);
    decode();
    const both = [
      ['frame', [101, []], 5, 6],
      ['frame', [102, []], 6, 7],
    ];
    expect(received).toEqual(both);
    decode();
    expect(received).toEqual(both);
  });

  it('are at most the newest four; the events of older ones are reported with the next', () => {
    const { session, received, receive, decode } = waiting();
    for (const tick of [101, 102, 103, 104, 105, 106]) receive(waitingFrame(tick, [event(tick)]), 5);
    decode();
    expect(received).toEqual([
      ['frame', [103, [101, 102, 103]], 5, 6],
      ...[104, 105, 106].map((tick) => ['frame', [tick, [tick]], 5, 6]),
    ]);
    expect(session.counters.framesSuperseded).toBe(2);
  });

  it('are received before a message that does not wait', () => {
    const { received, receive } = waiting();
    receive(waitingFrame(101), 5);
    receive(waitingHello(), 6);
    expect(received.map((one) => (one as unknown[])[0])).toEqual(['frame', 'hello']);
  });

  it('keep the newest thousand events', () => {
    const { received, receive, decode } = waiting();
    for (let i = 0; i < 1007; i++) receive(waitingFrame(i, i < 1003 ? [event(i)] : []), 5);
    decode();
    const [, [, events]] = received[0] as [string, [number, number[]]];
    expect([events.length, events[0], events.at(-1)]).toEqual([1000, 3, 1002]);
  });

  it('are refused if they cannot be decoded', () => {
    const { session, received, receive, decode } = waiting();
    const broken = { ...waitingFrame(101), decode: () => ({ ok: false, reason: 'frame: broken' }) };
    receive(broken as never, 5);
    decode();
    expect([received, session.counters.framesRefused, session.counters.lastRefusal]).toEqual([
      [],
      1,
      'frame: broken',
    ]);
  });

  it('are ignored without an arrival time', () => {
    const { session, receive } = waiting();
    receive(waitingFrame(101), Number.NaN);
    expect(session.pending?.queue ?? []).toEqual([]);
  });
});
