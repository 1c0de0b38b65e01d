import { describe, expect, it } from 'vitest';
import { classifySnapshot } from '../../../src/prediction/snapshots/classify';
import type { ServerFrame } from '../../../src/wire';
import { frameAt, STILL } from '../faults/restingShip';
import { RATE, sessionAt, shipAt } from './sessionAt';

const TICK = 100;
const frame = (tick: number, more: Partial<ServerFrame> = {}) => frameAt(tick, RATE, more);

/** Kind of a frame that arrives at `now` after a frame of TICK at 0. */
function kindOf(given: ServerFrame, now: number, prepare?: (session: ReturnType<typeof sessionAt>) => void) {
  const session = sessionAt(TICK);
  shipAt(session.sim, STILL.shipId, 'landed');
  prepare?.(session);
  return classifySnapshot(session.sim, session.receiver, given, now);
}

describe('a frame after the newest one', () => {
  it.each([
    [TICK + 1, 0.1],
    // A second late, and 2 s early at the most.
    [TICK + 1, 1.1],
    [TICK + 20, 0],
  ])('of tick %i at %f s is the newest', (tick, now) => {
    expect(kindOf(frame(tick), now)).toBe('newest');
  });

  it('is from the future if the server cannot have reached its tick', () => {
    expect(kindOf(frame(TICK + 22), 0)).toBe('future');
    expect(kindOf(frame(TICK + 5000), 1)).toBe('future');
  });

  it('may be two sends early where a send takes seconds', () => {
    const kind = (tick: number) => kindOf(frame(tick), 0, ({ sim }) => (sim.cadence.ticks = 40));
    expect([kind(TICK + 80), kind(TICK + 90)]).toEqual(['newest', 'future']);
  });

  it('is a jump on a new connection', () => {
    const isFresh = kindOf(frame(TICK + 5000), 1, ({ receiver }) => (receiver.fresh = true));
    expect(isFresh).toBe('jump');
  });

  it('is the newest after a silence as long as its ticks', () => {
    expect(kindOf(frame(TICK + 5000), 500)).toBe('newest');
  });
});

describe('a frame of the newest tick', () => {
  it('is a duplicate with the same ships, a part with others', () => {
    expect(kindOf(frame(TICK), 0.1)).toBe('duplicate');
    expect(kindOf(frame(TICK, { ships: [{ ...STILL, shipId: 'another' }] }), 0.1)).toBe('part');
  });

  it.each([{ paused: true }, { tickRate: 5 }, { timeScale: 2 }])('comes again with %o', (tempo) => {
    expect(kindOf(frame(TICK, tempo), 0.1)).toBe('again');
  });
});

describe('a frame of an earlier tick', () => {
  it('is out of order where it was not seen, and a duplicate where it was', () => {
    expect(kindOf(frame(TICK - 1), 0.1)).toBe('older');
    const seen = kindOf(frame(TICK - 1), 0.1, ({ receiver }) => (receiver.seen[TICK - 1] = TICK - 1));
    expect(seen).toBe('duplicate');
  });

  it('is too old beyond the history, or from before the hello', () => {
    const far = kindOf(frame(0), 0.1, ({ sim }) => (sim.ringLength = TICK));
    expect(far).toBe('tooOld');
    const before = kindOf(frame(TICK - 1), 0.1, ({ receiver }) => (receiver.firstTick = TICK));
    expect(before).toBe('tooOld');
  });

  it('is a jump once another one follows it at the pace of the wall clock, not with a burst of old ones', () => {
    const paced = sessionAt(TICK);
    const kinds = [0, 1, 2].map((k) => classifySnapshot(paced.sim, paced.receiver, frame(5 * k), 0.5 * k));
    expect(kinds.indexOf('jump')).toBe(1);
    const burst = sessionAt(TICK);
    for (let k = 0; k < 10; k++)
      expect(classifySnapshot(burst.sim, burst.receiver, frame(5 * k), 0.1)).not.toBe('jump');
  });
});

it('three frames further on, each later than the one before, are a jump even if they arrive together', () => {
  const { sim, receiver } = sessionAt(TICK);
  const kinds = [9000, 9001, 9002].map((tick) => classifySnapshot(sim, receiver, frame(tick), 1));
  expect(kinds).toEqual(['future', 'future', 'jump']);
});
