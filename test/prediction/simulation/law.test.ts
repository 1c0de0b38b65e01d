import { describe, expect, it } from 'vitest';
import { SCENARIOS } from '../../../src/scenarios';
import { corrections, flyAndMeasure } from '../measure';
import { createRig } from '../rig';

const COASTING = ['settle', 'bounce', 'slide', 'topple', 'crash'];

describe('prediction by the server’s law', () => {
  it.each(SCENARIOS.map(({ name }) => name))('%s is drawn as the server simulates it', (scenario) => {
    const rig = createRig({ scenario });
    const measured = flyAndMeasure(rig, Math.min(24, rig.loaded.scenario.duration + 2));
    expect(measured.frames).toBeGreaterThan(100);
    expect(rig.authority.counters.inputsLate).toBe(0);
    expect(corrections(rig)).toBe(0);
    expect(measured.worst).toBeLessThan(1e-6);
    expect(measured.wrongStates).toBe(0);
  });

  it.each([
    [5, 1],
    [20, 1],
    [100, 1],
    [1, 10],
    [20, 10],
    [1, 100],
    [100, 100],
  ])('needs no correction at %i Hz and time scale %i', (tickRate, timeScale) => {
    for (const scenario of COASTING) {
      // Half the frames of the scenarios above.
      const rig = createRig({ scenario, tickRate, timeScale, hz: 30 });
      const measured = flyAndMeasure(rig, 24 / timeScale + 3);
      expect(measured.frames, scenario).toBeGreaterThan(50);
      expect(corrections(rig), scenario).toBe(0);
      expect(measured.worst, scenario).toBeLessThan(1e-6);
      expect(measured.wrongStates, scenario).toBe(0);
    }
  });

  it('reports each event once as predicted and once as confirmed, at the server’s substep', () => {
    const rig = createRig({ scenario: 'bounce' });
    rig.fly(26);
    const told = rig.truth.events.map(({ type, tick, substep }) => `${type} ${tick}.${substep}`);
    const heard = (kind: string) =>
      rig.notices.filter((n) => n.kind === kind).map((n) => `${n.type} ${n.tick}.${n.substep}`);
    expect(told).toHaveLength(4);
    expect(heard('predicted')).toEqual(told);
    expect(heard('confirmed')).toEqual(told);
    expect(heard('retracted')).toEqual([]);
  });

  it('spends no substep on a landed ship that agrees', () => {
    const rig = createRig({ scenario: 'settle' });
    rig.fly(6);
    const before = { ...rig.view().diagnosis };
    expect(rig.view().own!.surfaceContactState).toBe('landed');
    rig.fly(20);
    expect(rig.view().diagnosis.steppedSubsteps).toBe(before.steppedSubsteps);
    expect(rig.view().diagnosis.replayedSubsteps).toBe(before.replayedSubsteps);
    expect(corrections(rig)).toBe(0);
  });
});
