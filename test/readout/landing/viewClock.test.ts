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

  it.each([0, 1, 2])('follows a ship that a correction moves by less than 100 m along axis %i', (axis) => {
    const followed = (metres: number) => {
      const clock = createViewClock();
      const view = makeView();
      view.own.velocity.fill(0);
      followView(clock, view, view.own);
      view.own.position[axis]! += metres;
      return followView(clock, view, view.own);
    };
    expect([99.99, -99.99, 100.01, -100.01].map(followed)).toEqual([true, true, false, false]);
  });

  it.each([0, 1, 2])(
    'follows a ship over 100 m more than twice the way of its speed along axis %i',
    (axis) => {
      const followed = (speed: number, metres: number) => {
        const clock = createViewClock();
        const view = makeView();
        view.own.velocity.fill(0);
        followView(clock, view, view.own);
        view.own.velocity[axis] = speed;
        view.own.position[axis]! += metres;
        return followView(clock, Object.assign(view, { tick: view.tick + 3 }), view.own);
      };
      const reach = 100 + 2 * 7 * 3;
      expect([followed(-7, reach - 0.01), followed(-7, reach + 0.01), followed(0, 100.01)]).toEqual([
        ...[true, false, false],
      ]);
    },
  );
});
