import { describe, expect, it } from 'vitest';
import { SHIP_STRIDE } from '../../../src/dynamics';
import { keepWithinBudget } from '../../../src/prediction/frameBudget';
import { sessionAt, shipAt } from './sessionAt';

/** Own ship and `others`, each 100 m farther than the one before, with a budget of 1,000 substeps a frame. */
function fleetOf(others: number) {
  const session = sessionAt(100);
  const { sim, budget } = session;
  const far = Array.from({ length: others }, (_, i) => shipAt(sim, `other-${i}`, '', 100 * (others - i)));
  const own = shipAt(sim, 'own', '');
  own.own = true;
  sim.fleet.own = own;
  return { sim, budget, own, near: far.reverse() };
}

describe('ships whose substeps exceed three quarters of the budget', () => {
  it('are switched off, the farthest first, the player’s ship last', () => {
    const { sim, budget, own, near } = fleetOf(9);
    keepWithinBudget(sim, budget, 150);
    expect(near.map(({ off }) => off)).toEqual([false, false, false, false, true, true, true, true, true]);
    expect(own).toMatchObject({ off: false, mode: 'stepping' });
    expect(sim.counters.budgetOverruns).toBe(1);
    keepWithinBudget(sim, budget, 800);
    expect(own.off || own.mode !== 'stepping').toBe(true);
  });

  it('stay on if only this frame is long, and catch up by replay', () => {
    const { sim, budget, own, near } = fleetOf(9);
    for (let i = 0; i < 10; i++) keepWithinBudget(sim, budget, 10);
    keepWithinBudget(sim, budget, 700);
    expect(near.every(({ off }) => !off)).toBe(true);
    expect(near.every(({ replaying, mode }) => replaying && mode !== 'stepping')).toBe(true);
    expect(own.mode).toBe('stepping');
    for (const { at, replayTick, replaySubstep } of near) {
      expect([replayTick, replaySubstep]).toEqual([100, 0]);
      expect(sim.fleet.replayed.subarray(at, at + SHIP_STRIDE)).toEqual(
        sim.fleet.front.subarray(at, at + SHIP_STRIDE),
      );
    }
  });

  it('keep the replay of a correction that is under way', () => {
    const { sim, budget, near } = fleetOf(9);
    for (let i = 0; i < 10; i++) keepWithinBudget(sim, budget, 10);
    Object.assign(near[8]!, { replaying: true, replayTick: 97, replaySubstep: 4 });
    keepWithinBudget(sim, budget, 700);
    expect(near[8]).toMatchObject({ mode: 'stepping', replaying: true, replayTick: 97, replaySubstep: 4 });
  });

  it('return, the nearest first, once four fifths of the budget suffice', () => {
    const { sim, budget, near } = fleetOf(9);
    keepWithinBudget(sim, budget, 150);
    // 750 / 100 = 7.5 ships could step; 0.8 of them may be on.
    budget.due = 100;
    keepWithinBudget(sim, budget, 100);
    expect(near.map(({ off }) => off)).toEqual([
      ...Array<boolean>(4).fill(false),
      ...Array<boolean>(5).fill(true),
    ]);
    budget.due = 75;
    keepWithinBudget(sim, budget, 75);
    expect(near.map(({ off }) => off)).toEqual([...Array<boolean>(7).fill(false), true, true]);
  });

  it('all stay in step if they fit', () => {
    const { sim, budget, near } = fleetOf(9);
    keepWithinBudget(sim, budget, 75);
    expect(near.every(({ off, mode }) => !off && mode === 'stepping')).toBe(true);
    expect(sim.counters.budgetOverruns).toBe(0);
  });
});
