import { describe, expect, it } from 'vitest';
import { addDelay, createDelays, minDelay, lowerDelay, spreadOf } from '../../../src/prediction/time/delays';
import { answeredPing, createPings, forgetPings, pingIfDue } from '../../../src/prediction/time/pings';

function delaysOf(values: readonly number[], length = values.length) {
  const delays = createDelays(length);
  for (const value of values) addDelay(delays, value);
  return delays;
}

describe('recent delays', () => {
  it('have no minimum and no spread before the first sample', () => {
    expect(minDelay(createDelays(4))).toBeNaN();
    expect(spreadOf(createDelays(4), 0.3)).toBe(0);
  });

  it('forget old samples, even the smallest', () => {
    expect(minDelay(delaysOf([0.01, 0.05, 0.06, 0.07], 3))).toBe(0.05);
  });

  it('of one queue count once, as the smallest', () => {
    const delays = delaysOf([0.05, 0.9]);
    lowerDelay(delays, 0.4);
    lowerDelay(delays, 0.6);
    expect(delays.count).toBe(2);
    expect([...delays.values]).toEqual([0.05, 0.4]);
  });

  it('have a spread that covers 19 of 20 samples above the minimum', () => {
    const even = Array.from({ length: 100 }, (_, i) => 0.1 + i / 1000);
    expect(spreadOf(delaysOf(even), 0.3)).toBeCloseTo(0.095, 6);
  });

  it('have a spread that ignores a stall and a few resent packets', () => {
    const usual = Array.from({ length: 40 }, (_, i) => 0.05 + (i % 10) / 1000);
    expect(spreadOf(delaysOf([...usual, 5, 6]), 0.3)).toBeLessThanOrEqual(0.02);
    expect(spreadOf(delaysOf([...usual, 0.25, 0.25, 0.25]), 0.3)).toBeLessThanOrEqual(0.02);
  });
});

describe('pings', () => {
  it('are frequent at first, then sent five times per second', () => {
    const pings = createPings();
    const at: number[] = [];
    for (let ms = 0; ms <= 2000; ms++) {
      pingIfDue(pings, ms / 1000);
      if (pings.queued.splice(0).length > 0) at.push(ms);
    }
    const gaps = at.slice(1).map((ms, i) => ms - at[i]!);
    // Of a clock that reads whole milliseconds.
    for (const gap of gaps.slice(0, 8)) expect(gap).toBeCloseTo(50, -1);
    for (const gap of gaps.slice(8)) expect(gap).toBeCloseTo(200, -1);
  });

  it('wait until the host takes them: the newest four are kept, the others counted as dropped', () => {
    const pings = createPings();
    for (let k = 0; k < 100; k++) pingIfDue(pings, k);
    expect(pings.queued.map(({ id }) => id)).toEqual([97, 98, 99, 100]);
    expect(pings.dropped).toBe(96);
  });

  it('are still sent after the clock is set back', () => {
    const pings = createPings();
    pingIfDue(pings, 100);
    pingIfDue(pings, 3);
    expect(pings.queued).toHaveLength(2);
  });

  it('accept one answer each, and none for an id that was never sent', () => {
    const pings = createPings();
    pingIfDue(pings, 7);
    expect(answeredPing(pings, 1)).toBe(7);
    expect(answeredPing(pings, 1)).toBeNaN();
    for (const id of [0, 2, -1, 0.5, Number.NaN]) expect(answeredPing(pings, id)).toBeNaN();
  });

  it('in flight during an absence are dropped', () => {
    const pings = createPings();
    pingIfDue(pings, 7);
    forgetPings(pings);
    expect(answeredPing(pings, 1)).toBeNaN();
  });
});
