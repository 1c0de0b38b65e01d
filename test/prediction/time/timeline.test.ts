import { describe, expect, it } from 'vitest';
import { SHIP_STRIDE } from '../../../src/dynamics';
import {
  createHistory,
  has,
  keep,
  offsetOf,
  resized,
  ringLength,
} from '../../../src/prediction/simulation/rings/history';
import {
  changeLongestSubstep,
  createTimeline,
  indexOf,
  setTempo,
  spanOf,
  wallOfTick,
  addSubsteps,
  writeMoment,
} from '../../../src/prediction/time/timeline';

const tempo = (tickRate: number, timeScale = 1, paused = false) => ({ tickRate, timeScale, paused });

describe('the timeline', () => {
  it('counts ticks and substeps in whole numbers across rate changes', () => {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 10, tempo(1), 0);
    setTempo(timeline, 12, tempo(1), null);
    setTempo(timeline, 13, tempo(20, 10), null);
    expect(timeline.spans.map(({ fromTick }) => fromTick)).toEqual([10, 13]);
    expect(wallOfTick(timeline, 13)).toBe(3);
    expect(wallOfTick(timeline, 33)).toBe(4);
    expect(spanOf(timeline, 12).timing.substeps).toBe(100);
    expect(spanOf(timeline, 13).timing.substeps).toBe(50);
    expect(indexOf(timeline, 13, 0) - indexOf(timeline, 10, 0)).toBe(300);
    expect(indexOf(timeline, 15, 7) - indexOf(timeline, 12, 98)).toBe(2 + 100 + 7);
    const later = { tick: 0, substep: 0 };
    addSubsteps(later, timeline, 12, 98, 2 + 50 + 3);
    expect(later).toEqual({ tick: 14, substep: 3 });
  });

  it('divides all its ticks anew by another longest substep', () => {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 10, tempo(1), 0);
    setTempo(timeline, 13, tempo(20, 10), null);
    changeLongestSubstep(timeline, 0.005);
    expect([12, 13].map((tick) => spanOf(timeline, tick).timing.substeps)).toEqual([200, 100]);
    expect([10, 13, 14].map((tick) => indexOf(timeline, tick, 0))).toEqual([0, 600, 700]);
    expect(wallOfTick(timeline, 13)).toBe(3);
  });

  it('finds the moment of a wall time, which does not advance in a pause', () => {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 5, tempo(1), 100);
    const moment = { tick: 0, substeps: 0 };
    writeMoment(moment, timeline, 102.25);
    expect(moment).toEqual({ tick: 7, substeps: 25 });
    setTempo(timeline, 8, tempo(1, 1, true), null);
    writeMoment(moment, timeline, 250);
    expect(moment).toEqual({ tick: 8, substeps: 0 });
    setTempo(timeline, 8, tempo(1), 260);
    writeMoment(moment, timeline, 261.5);
    expect(moment).toEqual({ tick: 9, substeps: 50 });
  });
});

describe('the ring of predicted states', () => {
  const row = (value: number) => new Float64Array(SHIP_STRIDE).fill(value);

  it('spans at least 10 s of wall time', () => {
    for (const tickRate of [0.1, 1, 5, 20, 100])
      expect((ringLength(tickRate) - 1) / tickRate).toBeGreaterThanOrEqual(10);
  });

  it('keeps slot = tick mod length, and an assertion names both ticks', () => {
    const history = createHistory(12);
    for (let tick = 90; tick <= 112; tick++) keep(history, tick, row(tick), 0);
    expect(has(history, 101)).toBe(true);
    expect(has(history, 100)).toBe(false);
    expect(history.rows[offsetOf(history, 107)]).toBe(107);
    expect(() => offsetOf(history, 90)).toThrow('history: expected tick 90 in its slot, got tick 102');
    expect(() => offsetOf(createHistory(12), 3)).toThrow('in its slot, got none');
  });

  it('keeps the newest states when its length changes', () => {
    const history = createHistory(30);
    for (let tick = 1; tick <= 40; tick++) keep(history, tick, row(tick), 0);
    const shorter = resized(history, 12);
    for (let tick = 29; tick <= 40; tick++) expect(shorter.rows[offsetOf(shorter, tick)]).toBe(tick);
    const longer = resized(history, 202);
    for (let tick = 11; tick <= 40; tick++) expect(longer.rows[offsetOf(longer, tick)]).toBe(tick);
  });
});
