import { describe, expect, it } from 'vitest';
import { createViewClock, followView } from '../../../src/readout/landing/viewClock';
import { makeView } from '../views';

describe('the readout’s own clock', () => {
  it('begins with the first view, and counts game seconds on the body of index 0 too', () => {
    const clock = createViewClock();
    const view = makeView({ body: 'Luna' });
    expect(view.own.body).toBe(0);
    expect(followView(clock, view, view.own)).toBe(false);
    expect([clock.elapsed, clock.now]).toEqual([0, 0]);
    Object.assign(view, { tick: view.tick + 3, timeScale: 10, tickRate: 5 });
    expect(followView(clock, view, view.own)).toBe(true);
    expect([clock.elapsed, clock.now]).toEqual([6, 6]);
  });

  it('never runs back', () => {
    const clock = createViewClock();
    const view = makeView();
    followView(clock, view, view.own);
    Object.assign(view, { tick: view.tick - 1 });
    followView(clock, view, view.own);
    expect([clock.elapsed, clock.now]).toEqual([0, 0]);
    Object.assign(view, { tick: view.tick + 2 });
    followView(clock, view, view.own);
    expect([clock.elapsed, clock.now]).toEqual([2, 2]);
  });
});
