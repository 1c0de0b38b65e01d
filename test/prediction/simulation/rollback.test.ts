import { describe, expect, it } from 'vitest';
import { SCENARIOS } from '../../../src/scenarios';
import { createRig, scenarioNamed } from '../rig';

/** Ticks rolled back at every boundary, as in GGRS's sync test. */
const BACK = 8;

describe('forced rollback: save, step, go back 8 ticks, replay, compare bits', () => {
  it.each(SCENARIOS.map(({ name }) => name))('%s', (scenario) => {
    const rig = createRig({ scenario, tickRate: 5, predictor: { forcedRollback: BACK } });
    rig.fly(Math.min(16, rig.loaded.scenario.duration));
    const { rollbacksCompared, rollbacksDifferent } = rig.view().diagnosis;
    expect(rollbacksCompared).toBeGreaterThan(10);
    expect(rollbacksDifferent).toBe(0);
  });

  it('fails for a terrain that depends on how often it was called', () => {
    let asked = 0;
    const broken = () => (asked++ % 1000) * 1e-12;
    const scenario = { ...scenarioNamed('slide'), terrain: 'flat' };
    const rig = createRig({
      scenario,
      tickRate: 5,
      predictor: { forcedRollback: BACK, terrains: { flat: broken } },
    });
    rig.fly(8);
    const { rollbacksCompared, rollbacksDifferent } = rig.view().diagnosis;
    expect(rollbacksCompared).toBeGreaterThan(10);
    expect(rollbacksDifferent).toBeGreaterThan(rollbacksCompared / 2);
  });
});
