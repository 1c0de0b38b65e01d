import { describe, expect, it } from 'vitest';
import { SHIP_STRIDE } from '../../../../src/dynamics';
import {
  createHistory,
  forgetAfter,
  has,
  keep,
  offsetOf,
  resized,
  ringLength,
  rowsWithin,
} from '../../../../src/prediction/simulation/rings/history';
import { beginLog, LOG_STRIDE, LOGGED_STATE } from '../../../../src/prediction/touchdown/touchdownLog';
import {
  createTouchdownRing,
  forgetLogsAfter,
  keepLog,
  logAt,
  logLanded,
  resizeLogs,
} from '../../../../src/prediction/touchdown/touchdownRing';

const rowOf = (value: number) => new Float64Array(2 * SHIP_STRIDE).fill(value, SHIP_STRIDE);
const logOf = (state: number) => {
  const log = new Float64Array(LOG_STRIDE);
  beginLog(log, state);
  return log;
};

describe('a ship’s predicted states', () => {
  const kept = (length: number, ...ticks: number[]) => {
    const history = createHistory(length);
    for (const tick of ticks) keep(history, tick, rowOf(tick), SHIP_STRIDE);
    return history;
  };
  const ticksOf = (history: ReturnType<typeof kept>) =>
    Array.from({ length: 60 }, (_, tick) => tick).filter((tick) => has(history, tick));

  it('are kept for the newest ticks, each complete', () => {
    const history = kept(4, 0, 1, 2, 3, 4);
    expect(ticksOf(history)).toEqual([1, 2, 3, 4]);
    for (const tick of [1, 4]) {
      const at = offsetOf(history, tick);
      expect([...history.rows.subarray(at, at + SHIP_STRIDE)]).toEqual(Array<number>(SHIP_STRIDE).fill(tick));
    }
    expect(() => offsetOf(history, 0)).toThrow('got tick 4');
    expect(() => offsetOf(createHistory(4), 0)).toThrow('got none');
  });

  it('can be forgotten after a tick', () => {
    const history = kept(4, 1, 2, 3, 4);
    forgetAfter(history, 2);
    expect(ticksOf(history)).toEqual([1, 2]);
  });

  it.each([
    [8, [0, 1, 2, 3]],
    [2, [2, 3]],
  ])('are the newest ones after the ring is resized to %i', (length, ticks) => {
    const next = resized(kept(4, 0, 1, 2, 3), length);
    expect([next.length, ticksOf(next)]).toEqual([length, ticks]);
    for (const tick of ticks) expect(next.rows[offsetOf(next, tick)]).toBe(tick);
    // Out of order: 12 is in the slot after 13's.
    const turned = resized(kept(4, 10, 11, 12, 13), 2);
    expect(ticksOf(turned)).toEqual([12, 13]);
  });

  it('span 10 s and at least 12 ticks', () => {
    expect([0.1, 1, 1.05, 20, 50].map(ringLength)).toEqual([12, 12, 13, 202, 502]);
  });

  it('take at most 32 MB for all ships, rounded up to a power of two, but at least 12 rows each', () => {
    const bytes = (ships: number) => rowsWithin(ships) * SHIP_STRIDE * 8;
    for (const ships of [1, 2, 64, 1024]) {
      expect(ships * bytes(ships)).toBeLessThanOrEqual(32 * 2 ** 20);
      expect(ships * (bytes(ships) + SHIP_STRIDE * 8)).toBeGreaterThan(32 * 2 ** 20);
    }
    expect(rowsWithin(0)).toBe(rowsWithin(1));
    expect(rowsWithin(65)).toBe(rowsWithin(128));
    expect(rowsWithin(1e6)).toBe(12);
  });
});

describe('the touchdown logs of a ship', () => {
  const kept = (length: number, ...ticks: number[]) => {
    const ring = createTouchdownRing(length);
    for (const tick of ticks) keepLog(ring, tick, logOf(tick % 4));
    return ring;
  };
  const ticksOf = (ring: ReturnType<typeof kept>) =>
    Array.from({ length: 60 }, (_, tick) => tick).filter((tick) => logAt(ring, tick) !== null);

  it('are kept for the newest ticks', () => {
    const ring = kept(4, 0, 1, 2, 3, 4);
    expect(ticksOf(ring)).toEqual([1, 2, 3, 4]);
    expect(logAt(ring, 3)![LOGGED_STATE]).toBe(3);
    forgetLogsAfter(ring, 2);
    expect(ticksOf(ring)).toEqual([1, 2]);
  });

  it.each([
    [8, [0, 1, 2, 3]],
    [2, [2, 3]],
  ])('are the newest ones after the ring is resized to %i', (length, ticks) => {
    const ring = kept(4, 0, 1, 2, 3);
    resizeLogs(ring, length);
    expect([ring.kept.length, ring.ticks.length, ticksOf(ring)]).toEqual([length, length, ticks]);
    for (const tick of ticks) expect(logAt(ring, tick)![LOGGED_STATE]).toBe(tick);
    const turned = kept(4, 10, 11, 12, 13);
    resizeLogs(turned, 2);
    expect(ticksOf(turned)).toEqual([12, 13]);
  });

  it('start anew for a ship that is first seen landed, unless it was landed before', () => {
    const ring = kept(4);
    ring.front.set(logOf(1));
    ring.front[0] = 1;
    logLanded(ring);
    expect([ring.front[0], ring.front[LOGGED_STATE]]).toEqual([0, 2]);
    ring.front[0] = 1;
    logLanded(ring);
    expect(ring.front[0]).toBe(1);
  });
});
