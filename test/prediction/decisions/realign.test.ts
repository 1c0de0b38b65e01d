import { expect, it } from 'vitest';
import { isFarBehind } from '../../../src/prediction/snapshots/reconcile/realign';
import { setTempo } from '../../../src/prediction/time/timeline';
import { sessionAt } from './sessionAt';

const TICK = 100;

/** Whether a present is far behind that lies `substeps` before the front, which is at the begin of TICK. */
function isFar(substeps: number, { tickRate = 10, timeScale = 1 } = {}): boolean {
  const { sim } = sessionAt(TICK - 50, tickRate);
  setTempo(sim.timeline, TICK - 50, { tickRate, timeScale, paused: false }, null);
  sim.front.tick = TICK;
  const perTick = Math.max(1, Math.round((100 * timeScale) / tickRate));
  const tick = TICK - Math.ceil(substeps / perTick);
  return isFarBehind(sim, { tick, substep: (TICK - tick) * perTick - substeps });
}

it('a present is far behind the simulation beyond a quarter of a wall second', () => {
  expect([-30, 3, 25, 26].map((substeps) => isFar(substeps))).toEqual([false, false, false, true]);
  expect([50, 51].map((substeps) => isFar(substeps, { timeScale: 2 }))).toEqual([false, true]);
});

it('a present two substeps behind is not far, however long they take', () => {
  expect([2, 3].map((substeps) => isFar(substeps, { tickRate: 1, timeScale: 0.01 }))).toEqual([false, true]);
});
