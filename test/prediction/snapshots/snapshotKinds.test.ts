import { describe, expect, it } from 'vitest';
import { receiveSnapshot, beginTimeline } from '../../../src/prediction/snapshots/receiveSnapshot';
import type { ServerFrame } from '../../../src/wire';
import { frameAt, STILL } from '../faults/restingShip';
import { RATE, sessionAt } from '../decisions/sessionAt';

const TICK = 100;

/** A session with the frames of TICK and after, each a tick after the one before; the first arrives at second 0. */
function receiving() {
  const session = sessionAt(TICK);
  const { sim, receiver, counters } = session;
  receiver.lastBodies.tick = -1;
  const receive = (tick: number, more: Partial<ServerFrame> = {}, now = (tick - TICK) / RATE) =>
    receiveSnapshot(sim, receiver, frameAt(tick, RATE, more), now);
  const counted = () => ({
    accepted: counters.framesAccepted,
    duplicate: counters.framesDuplicate,
    future: counters.framesFromFuture,
    late: counters.framesOutOfOrder,
    old: counters.framesTooOld,
  });
  const ships = () => sim.fleet.tracks.map(({ shipId }) => shipId);
  return { session, sim, receiver, counters, receive, counted, ships };
}
const NONE = { accepted: 0, duplicate: 0, future: 0, late: 0, old: 0 };
const other = { ...STILL, shipId: 'other' };

describe('a frame counts', () => {
  it.each<[string, (of: ReturnType<typeof receiving>) => void, object]>([
    ['as accepted where it is the newest', ({ receive }) => receive(101), { accepted: 1 }],
    [
      'as a duplicate',
      ({ receive }) => [101, 101].map((tick) => receive(tick)),
      { accepted: 1, duplicate: 1 },
    ],
    ['as of the future', ({ receive }) => receive(9000, {}, 0.1), { future: 1 }],
    [
      'as late, and is used',
      ({ receive }) => [102, 101].map((tick) => receive(tick, {}, 0.2)),
      { accepted: 2, late: 1 },
    ],
    [
      'as a duplicate where a late one comes again',
      ({ receive }) => [102, 101, 101].map((tick) => receive(tick, {}, 0.2)),
      { accepted: 2, late: 1, duplicate: 1 },
    ],
    [
      'as too old',
      ({ receive, receiver }) => {
        receiver.firstTick = 50;
        receive(49, {}, 0.1);
      },
      { old: 1 },
    ],
  ])('%s', (_, act, counts) => {
    const of = receiving();
    act(of);
    expect(of.counted()).toEqual({ ...NONE, ...counts });
  });
});

describe('a frame that is taken', () => {
  it('brings its ships, its time and its spacing', () => {
    const { sim, receiver, receive, ships } = receiving();
    receiver.jump.count = 2;
    receive(103);
    expect(ships()).toEqual([STILL.shipId]);
    expect([sim.newestTick, receiver.acceptedAt, receiver.fresh, receiver.jump.count]).toEqual([
      103,
      0.3,
      false,
      0,
    ]);
    expect([sim.cadence.sends, sim.cadence.ticks]).toEqual([1, 3]);
    receive(103, { ships: [other] }, 0.35);
    expect(ships()).toEqual([STILL.shipId, 'other']);
    // A part of the same snapshot is no send of its own.
    expect([sim.cadence.sends, receiver.acceptedAt]).toEqual([1, 0.35]);
  });
});

describe('a ship that is no longer sent', () => {
  const left = (sends: number, seconds: number) => {
    const { receive, ships } = receiving();
    receive(101, { ships: [STILL, other] }, 1);
    for (let k = 1; k <= sends; k++) receive(101 + k, {}, 1 + (k * seconds) / sends);
    return ships();
  };

  it('fades after three sends and a second', () => {
    const both = [STILL.shipId, 'other'];
    expect(left(3, 1)).toEqual([STILL.shipId]);
    expect(left(2, 1)).toEqual(both);
    expect(left(3, 0.99)).toEqual(both);
    expect(left(9, 0.9)).toEqual(both);
  });
});

it('another timeline forgets ships, spans, inputs and what was seen, and is counted', () => {
  const { sim, receiver, counters, receive } = receiving();
  receive(101);
  beginTimeline(sim, receiver);
  expect(counters.resyncs).toBe(1);
  expect([sim.fleet.tracks, sim.timeline.spans, sim.inputs.records]).toEqual([[], [], []]);
  expect([sim.newestTick, sim.frontIsStale, sim.bodiesKnown, receiver.fresh]).toEqual([
    -1,
    true,
    false,
    true,
  ]);
  expect(sim.bodies.ticks.every((tick) => tick < 0)).toBe(true);
  expect([receiver.acceptedAt, receiver.seen.some((tick) => tick >= 0)]).toEqual([
    Number.NEGATIVE_INFINITY,
    false,
  ]);
  expect(receiver.clock.present).toBeNaN();
  expect(sim.cadence.recent).toEqual([]);
});
