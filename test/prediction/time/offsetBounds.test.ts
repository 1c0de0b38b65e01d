/** The bounds of the client's clock minus the server's, from single arrivals and answers. */
import { describe, expect, it } from 'vitest';
import {
  boundAbove,
  boundBelow,
  boundBothSides,
  createOffsetBounds,
  forgetBounds,
  forgetLower,
  type OffsetBounds,
  type Sampling,
} from '../../../src/prediction/time/offsetBounds';

/** Client s minus server s. */
const OFFSET = 100;
const QUIET: Sampling = { roundTrip: 0.1, clockStep: 0, hearsPongs: false, isOverdue: false };

/** Bounds after answers within 0.1 s at second 50. */
function known(): OffsetBounds {
  const bounds = createOffsetBounds();
  boundBothSides(bounds, { pinged: 50, answered: 50.05 - OFFSET, now: 50.1 }, 0);
  return bounds;
}
/** A message that arrives at `now`, `delay` s after it was sent. */
const arrive = (bounds: OffsetBounds, now: number, delay: number, more: Partial<Sampling> = {}) =>
  boundAbove(bounds, now - delay - OFFSET, now, { ...QUIET, ...more });

describe('a pong', () => {
  it('bounds the offset from both sides by the send time of its ping and its own arrival', () => {
    const bounds = known();
    expect(bounds.lower).toBeCloseTo(OFFSET - 0.05, 9);
    expect(bounds.upper).toBeCloseTo(OFFSET + 0.05, 9);
  });

  it('narrows the bounds and never widens them', () => {
    const bounds = known();
    expect(boundBothSides(bounds, { pinged: 50.1, answered: 50.12 - OFFSET, now: 50.14 }, 0)).toBe(false);
    expect([bounds.lower, bounds.upper]).toEqual([
      expect.closeTo(OFFSET - 0.02, 3),
      expect.closeTo(OFFSET + 0.02, 3),
    ]);
    boundBothSides(bounds, { pinged: 50.1, answered: 50.2 - OFFSET, now: 50.3 }, 0);
    expect([bounds.lower, bounds.upper]).toEqual([
      expect.closeTo(OFFSET - 0.02, 3),
      expect.closeTo(OFFSET + 0.02, 3),
    ]);
  });

  it.each([
    [-1, 'lower'],
    [1, 'upper'],
  ] as const)('of a schedule shifted by %i s drops the %s bound', (seconds, side) => {
    const bounds = known();
    const answer = { pinged: 50.1, answered: 50.15 - OFFSET - seconds, now: 50.2 };
    expect(boundBothSides(bounds, answer, 0)).toBe(true);
    expect(bounds[side]).toBeCloseTo(OFFSET + seconds + (side === 'upper' ? 0.05 : -0.05), 4);
    // With a clock of such steps it is no contradiction.
    expect(boundBothSides(known(), answer, 1)).toBe(false);
  });

  it('of a stopped server bounds the offset only from below', () => {
    const bounds = known();
    boundBelow(bounds, { pinged: 51, stopped: 50.5 - OFFSET, now: 51.1 });
    expect(bounds.lower).toBeCloseTo(OFFSET + 0.5, 4);
    expect(bounds.upper).toBe(Number.POSITIVE_INFINITY);
    const stopped = known();
    boundBelow(stopped, { pinged: 51, stopped: 51.5 - OFFSET, now: 51.1 });
    expect(stopped.lower).toBeCloseTo(OFFSET - 0.05, 2);
  });
});

describe('an arrival', () => {
  it('lowers the upper bound to its delay, and never raises it', () => {
    const bounds = known();
    expect(arrive(bounds, 50.1, 0.03)).toBe(false);
    expect(bounds.upper).toBeCloseTo(OFFSET + 0.03, 9);
    expect(arrive(bounds, 50.2, 0.06)).toBe(false);
    expect(bounds.upper).toBeCloseTo(OFFSET + 0.03, 3);
    expect(bounds.lower).toBeCloseTo(OFFSET - 0.05, 3);
  });

  it('far earlier than all before it contradicts the bounds', () => {
    expect(arrive(known(), 50.1, -0.04)).toBe(false);
    const early = known();
    Object.assign(early, { lower: OFFSET - 5 });
    expect(arrive(early, 50.1, -0.06)).toBe(true);
    expect(early.lower).toBeCloseTo(OFFSET - 5, 4);
    expect(arrive(known(), 50.1, -0.06, { clockStep: 0.1 })).toBe(false);
  });

  it('earlier than the lower bound replaces both: the offset is within a round trip below it', () => {
    const bounds = known();
    expect(arrive(bounds, 50.1, -1)).toBe(true);
    expect([bounds.lower, bounds.upper]).toEqual([
      expect.closeTo(OFFSET - 1.1, 9),
      expect.closeTo(OFFSET - 1, 9),
    ]);
  });

  it('that is the first contradicts nothing', () => {
    const bounds = createOffsetBounds();
    expect(arrive(bounds, 50, 0.2)).toBe(false);
    expect([bounds.upper, bounds.lower]).toEqual([expect.closeTo(OFFSET + 0.2, 9), Number.NEGATIVE_INFINITY]);
  });
});

describe('late arrivals', () => {
  /** Which of these arrivals, each `gap` s after the one before and `delays` late, moves the bounds. */
  const moved = (delays: readonly number[], more: Partial<Sampling> = {}, gap = 0.1, sent = gap) => {
    const bounds = known();
    const all = delays.map((delay, i) => {
      const server = 50.2 + i * sent - OFFSET;
      return boundAbove(bounds, server, 50.2 + i * gap + delay, { ...QUIET, ...more });
    });
    return { first: all.indexOf(true), bounds };
  };

  it('with the same delay shift the schedule at the third, or at the second if a resend cannot explain the delay', () => {
    const { first, bounds } = moved([0.2, 0.2, 0.2]);
    expect(first).toBe(2);
    expect([bounds.upper, bounds.lower]).toEqual([expect.closeTo(OFFSET + 0.2, 6), Number.NEGATIVE_INFINITY]);
    expect(moved([0.5, 0.5, 0.5]).first).toBe(1);
  });

  it('count as jitter up to 50 ms above the least delay, or up to the clock’s resolution', () => {
    expect(moved([0.09, 0.09, 0.09, 0.09]).first).toBe(-1);
    expect(moved([0.11, 0.11, 0.11]).first).toBe(2);
    expect(moved([0.2, 0.2, 0.2], { clockStep: 0.2 }).first).toBe(-1);
  });

  it('between timely ones do not shift the schedule', () => {
    expect(moved([0.2, 0.2, 0.05, 0.2, 0.2]).first).toBe(-1);
  });

  it('from a draining queue do not shift the schedule', () => {
    // They were sent 0.1 s apart and arrive almost together.
    expect(moved([0.6, 0.52, 0.44, 0.36], {}).first).toBe(-1);
  });

  it('shift the schedule at once after a silence, and never while pings are answered', () => {
    expect(moved([0.2], { isOverdue: true }).first).toBe(0);
    expect(moved([0.5, 0.5, 0.5, 0.5], { hearsPongs: true }).first).toBe(-1);
  });
});

describe('the bounds', () => {
  it('widen with the drift of the two clocks', () => {
    const bounds = known();
    const { upper, lower } = bounds;
    arrive(bounds, 1050.1, 9, { hearsPongs: true });
    const wider = bounds.upper - upper;
    expect(wider).toBeGreaterThan(0);
    expect(lower - bounds.lower).toBeCloseTo(wider, 9);
    // Not for a message that waited undecoded.
    arrive(bounds, 1040, 9, { hearsPongs: true });
    expect(bounds.upper - upper).toBeCloseTo(wider, 12);
    expect(bounds.agedTo).toBe(1050.1);
  });

  it('are reset together, or the lower one alone', () => {
    const bounds = known();
    bounds.late = 2;
    forgetLower(bounds);
    expect(bounds).toMatchObject({ lower: Number.NEGATIVE_INFINITY, late: 0 });
    expect(bounds.upper).toBeCloseTo(OFFSET + 0.05, 9);
    forgetBounds(bounds);
    expect(bounds).toEqual(createOffsetBounds());
    expect(bounds).toMatchObject({
      upper: Number.POSITIVE_INFINITY,
      lower: Number.NEGATIVE_INFINITY,
      late: 0,
    });
  });
});
