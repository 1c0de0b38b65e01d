import { describe, expect, it } from 'vitest';
import { type Clock, createClock, leadOf } from '../../../src/prediction/time/clock';
import { addDelay } from '../../../src/prediction/time/delays';
import { advanceClock, type Pacing } from '../../../src/prediction/time/present';

const NOW = 1000;
const OFFSET = 100;
const FRAME = 1 / 64;
const PACING: Pacing = { deadZone: 0.005, latest: Number.POSITIVE_INFINITY };

/** A clock whose last frame was at NOW, with a present that is `error` s behind where it should be (negative: ahead). */
function clockBehind(error: number, more: Partial<Clock> = {}): Clock {
  const clock = createClock();
  // Bounds as wide as the round trip: the offset is certain.
  addDelay(clock.roundTrips, 0.1);
  Object.assign(clock.bounds, { lower: OFFSET - 0.05, upper: OFFSET + 0.05 });
  Object.assign(clock, { offset: OFFSET, settledOffset: OFFSET, updatedAt: NOW }, more);
  clock.present = NOW - OFFSET + leadOf(clock) - error;
  return clock;
}

/** The next frame: how far the present moved, and whether it jumped. */
function advance(clock: Clock, elapsed = FRAME, pacing: Partial<Pacing> = {}) {
  const before = clock.present;
  const jumped = advanceClock(clock, clock.updatedAt + elapsed, { ...PACING, ...pacing });
  return { moved: clock.present - before, jumped };
}

describe('the present', () => {
  it('starts ahead of the server’s time by the lead', () => {
    const clock = clockBehind(0, { updatedAt: Number.NaN });
    const { present } = clock;
    clock.present = Number.NaN;
    expect(advanceClock(clock, NOW, PACING)).toBe(true);
    expect(clock.present).toBeCloseTo(present, 9);
    expect(clock).toMatchObject({ rate: 1, slewing: false, stepped: false, settledOffset: OFFSET });
  });

  it('advances at the rate of the wall clock while the error is within the dead zone', () => {
    for (const error of [0.0049, -0.0049]) {
      const clock = clockBehind(error);
      expect(advance(clock).moved).toBeCloseTo(FRAME, 9);
      expect(clock).toMatchObject({ rate: 1, slewing: false });
    }
  });

  it.each([
    [0.03, 1.06],
    [-0.02, 0.96],
    [0.2, 1.1],
    [-0.2, 0.9],
    [1.9, 1.1],
    [-1.9, 0.9],
  ])('%f s behind, runs at %f times the rate of the wall clock from the next frame on', (error, rate) => {
    const clock = clockBehind(error);
    expect(advance(clock).moved).toBeCloseTo(FRAME, 9);
    expect(clock.rate).toBeCloseTo(rate, 6);
    expect(advance(clock).moved).toBeCloseTo(rate * FRAME, 9);
  });

  it('slews until the error is below a millisecond', () => {
    const slewing = clockBehind(0.0012, { slewing: true });
    advance(slewing);
    expect(slewing.rate).toBeCloseTo(1 + 0.0012 / 0.5, 6);
    const done = clockBehind(0.0009, { slewing: true, rate: 1 });
    advance(done);
    expect(done).toMatchObject({ rate: 1, slewing: false });
    // Of substeps shorter than that, half of one.
    const short = clockBehind(0.0007, { slewing: true });
    advance(short, FRAME, { deadZone: 0.0005 });
    expect(short.slewing).toBe(true);
  });

  it.each([2.01, -2.01])('%f s behind, jumps', (error) => {
    const clock = clockBehind(error, { rate: 1.1, slewing: true });
    const { present } = clockBehind(0);
    expect(advance(clock).jumped).toBe(true);
    expect(clock.present).toBeCloseTo(present + FRAME, 9);
    expect(clock).toMatchObject({ rate: 1, slewing: false });
  });

  it('catches up for at most a quarter of a second in one frame', () => {
    expect(advance(clockBehind(0.5, { rate: 1.1 }), 3).moved).toBeCloseTo(3 + 0.025, 9);
    expect(advance(clockBehind(0.5, { rate: 1.1 }), 0.2).moved).toBeCloseTo(0.22, 9);
  });

  it('does not move while the caller’s clock stops or goes back', () => {
    expect(advance(clockBehind(0), 0).moved).toBe(0);
    expect(advance(clockBehind(0), -0.01).moved).toBe(0);
  });

  it('reduces a raised lead by 4 ms per second', () => {
    const clock = clockBehind(0, { steer: 0.1 });
    advance(clock, 2);
    expect(clock.steer).toBeCloseTo(0.092, 9);
    advance(clock, 200);
    expect(clock.steer).toBe(0);
  });
});

describe('the present, after the server’s clock jumped,', () => {
  /** A clock whose offset has changed so that the present is `error` behind. */
  const jumped = (error: number, more: Partial<Clock> = {}) => {
    const clock = clockBehind(0, { ...more });
    clock.offset = OFFSET - error;
    return clock;
  };

  it('jumps ahead by more than 0.1 s, and slews by less', () => {
    expect(advance(jumped(0.11)).jumped).toBe(true);
    expect(advance(jumped(0.09)).jumped).toBe(false);
    // The error was there before: the clock has not jumped.
    expect(advance(clockBehind(0.11)).jumped).toBe(false);
  });

  it('waits for a server that is up to 0.8 s behind, and jumps back for one that is further behind', () => {
    const waiting = jumped(-0.5);
    expect(advance(waiting)).toEqual({ moved: 0, jumped: false });
    expect(waiting.rate).toBe(0);
    expect(advance(jumped(-0.8 + 2 * FRAME)).jumped).toBe(false);
    expect(advance(jumped(-0.81)).jumped).toBe(true);
    expect(advance(jumped(-0.09)).moved).toBeCloseTo(FRAME, 9);
  });

  it('waits until the server has caught up to within half a substep', () => {
    const clock = jumped(-0.15);
    let waited = 0;
    while (advance(clock).moved === 0) waited += FRAME;
    expect(waited).toBeGreaterThan(0.15 - 0.005 - FRAME);
    expect(waited).toBeLessThan(0.15 + 2 * FRAME);
    expect(clock).toMatchObject({ stepped: false, settledOffset: OFFSET + 0.15 });
  });
});

describe('an uncertain clock offset', () => {
  const certain = (more: Partial<Clock>, wide = 0.1) => {
    const clock = clockBehind(0, more);
    Object.assign(clock.bounds, { lower: OFFSET - wide / 2, upper: OFFSET + wide / 2 });
    clock.offset = OFFSET - 0.02;
    return clock;
  };

  it('is adopted at once when it becomes certain, if the error is at least 8 ms', () => {
    expect(advance(certain({ wasLoose: true })).jumped).toBe(true);
    expect(advance(certain({ wasLoose: false })).jumped).toBe(false);
    const small = certain({ wasLoose: true });
    small.offset = OFFSET - 0.007;
    expect(advance(small).jumped).toBe(false);
    expect(small.wasLoose).toBe(false);
  });

  it('becomes certain with bounds up to 30 ms wider than the round trip, and uncertain beyond 60 ms', () => {
    expect(advance(certain({ wasLoose: true }, 0.129)).jumped).toBe(true);
    expect(advance(certain({ wasLoose: true }, 0.131)).jumped).toBe(false);
    const wide = (width: number) => {
      const clock = certain({}, width);
      advance(clock);
      return clock.wasLoose;
    };
    expect([wide(0.159), wide(0.161), wide(Number.POSITIVE_INFINITY)]).toEqual([false, true, false]);
  });

  it('is assumed after a gap of more than a quarter of a second', () => {
    const after = (elapsed: number) => {
      const clock = clockBehind(0);
      advance(clock, elapsed);
      return clock.wasLoose;
    };
    expect([after(0.25), after(0.26)]).toEqual([false, true]);
  });
});

describe('the limit of the present', () => {
  it('is the horizon beyond the newest frame', () => {
    const clock = clockBehind(0);
    const latest = clock.present + FRAME / 2;
    expect(advance(clock, FRAME, { latest }).moved).toBeCloseTo(FRAME / 2, 9);
    expect(advance(clock, FRAME, { latest }).moved).toBe(0);
    // Frames come again: at once where it should be.
    expect(advance(clock, 0.5, { latest }).moved).toBe(0);
    expect(advance(clock).jumped).toBe(true);
  });

  it('never moves the present back', () => {
    const clock = clockBehind(0);
    expect(advance(clock, FRAME, { latest: clock.present - 0.05 }).moved).toBe(0);
  });

  it('is the instant at which the server stopped, plus the lead', () => {
    const clock = clockBehind(0);
    clock.stoppedAt = clock.present - leadOf(clock);
    expect(advance(clock, 0.05).moved).toBe(0);
  });
});

describe('the resolution of a coarse clock', () => {
  const after = (...elapsed: number[]) => {
    const clock = clockBehind(0);
    for (const seconds of elapsed) advance(clock, seconds);
    return clock.clockStep;
  };

  it('is the shortest change that followed a call without one', () => {
    expect(after(0.1, 0.1)).toBe(0);
    expect(after(0, 0.1)).toBeCloseTo(0.1, 9);
    expect(after(0, 0.1, 0, 0.2)).toBeCloseTo(0.1, 9);
    expect(after(0, 0.2, 0, 0.1)).toBeCloseTo(0.1, 9);
    expect(after(0, 0.3)).toBe(0);
    expect(after(0, 0.25)).toBe(0.25);
  });

  it('is reset once the clock moves by less', () => {
    expect(after(0, 0.1, 0.08)).toBe(0);
    expect(after(0, 0.1, 0.095)).toBeCloseTo(0.1, 9);
    expect(after(0, 0.1, -1)).toBeCloseTo(0.1, 9);
  });
});
