import { describe, expect, it } from 'vitest';
import { createJourney, followJourney } from '../../src/readout/landing/journey';
import { makeView } from './views';

describe('the readout’s own clock', () => {
  it('begins with the first view, and counts game seconds on the body of index 0 too', () => {
    const journey = createJourney();
    const view = makeView({ body: 'Luna' });
    expect(view.own.body).toBe(0);
    expect(followJourney(journey, view, view.own)).toBe(false);
    expect([journey.elapsed, journey.now]).toEqual([0, 0]);
    Object.assign(view, { tick: view.tick + 3, timeScale: 10, tickRate: 5 });
    expect(followJourney(journey, view, view.own)).toBe(true);
    expect([journey.elapsed, journey.now]).toEqual([6, 6]);
  });

  it('never runs back', () => {
    const journey = createJourney();
    const view = makeView();
    followJourney(journey, view, view.own);
    Object.assign(view, { tick: view.tick - 1 });
    followJourney(journey, view, view.own);
    expect([journey.elapsed, journey.now]).toEqual([0, 0]);
    Object.assign(view, { tick: view.tick + 2 });
    followJourney(journey, view, view.own);
    expect([journey.elapsed, journey.now]).toEqual([2, 2]);
  });
});
