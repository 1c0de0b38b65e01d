import { describe, expect, it } from 'vitest';
import { fitRings, historyLength } from '../../../../src/prediction/simulation/rings/fitRings';
import { has, keep, ringLength } from '../../../../src/prediction/simulation/rings/history';
import { sessionAt, shipAt } from '../../decisions/sessionAt';

const TICK = 100;

/** A fleet of one other ship at 10 Hz with its last ten ticks kept. */
function fleet() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'other', '');
  for (let tick = TICK - 9; tick <= TICK; tick++) keep(track.history, tick, track.serverRow, 0);
  return { sim, track };
}

describe('the rings of predicted states', () => {
  it('grow with the tick rate, and keep their contents', () => {
    const { sim, track } = fleet();
    fitRings(sim, { tickRate: 50, substeps: 2, ships: 10 });
    expect(sim.ringLength).toBe(ringLength(50));
    expect(track.history.length).toBe(ringLength(50));
    expect(sim.bodies.length).toBe(ringLength(50));
    for (let tick = TICK - 9; tick <= TICK; tick++) expect(has(track.history, tick)).toBe(true);
  });

  it('do not shrink at a lower rate', () => {
    const { sim, track } = fleet();
    const before = track.history;
    fitRings(sim, { tickRate: 1, substeps: 100, ships: 10 });
    expect(track.history).toBe(before);
  });

  it('shrink to as few as twelve rows per ship to fit into 32 MB, except that of the player’s ship', () => {
    const { sim, track } = fleet();
    fitRings(sim, { tickRate: 100, substeps: 1, ships: 100_000 });
    expect(track.history.length).toBe(12);
    expect(historyLength(sim, false)).toBe(12);
    expect(historyLength(sim, true)).toBe(ringLength(100));
    for (let tick = TICK - 9; tick <= TICK; tick++) expect(has(track.history, tick)).toBe(true);
    expect(sim.counters.historyBytes).toBe(100_000 * 12 * 36 * 8);
  });
});
