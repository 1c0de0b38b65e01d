import { describe, expect, it } from 'vitest';
import { createAuthority, type SpawnOrder } from '../../src/authority';
import { NEUTRAL_CONTROLS, SHIP_STRIDE } from '../../src/dynamics';
import { runScenario, SCENARIOS, loadScenario } from '../../src/scenarios';
import { frameOf, input, MOON, runTo, shipOf, valueOf } from './moon';

const thrust = (tick: number, substep: number, thrustLevel: number) => ({
  tick,
  substep,
  controls: { ...NEUTRAL_CONTROLS, thrustLevel },
});

function moonFlying(plan: SpawnOrder['plan'] & object, options = {}) {
  const authority = valueOf(createAuthority({ ...MOON, ...options }));
  const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf('opening') };
  expect(authority.spawn({ ...order, plan })).toBeNull();
  authority.join('ann', 'own');
  return authority;
}

describe('a ship with a plan', () => {
  it.each(SCENARIOS.filter(({ inputs }) => inputs.length > 0).map(({ name }) => name))(
    'flies %s as on the dynamics alone, to the bit',
    (name) => {
      const scenario = SCENARIOS.find((candidate) => candidate.name === name)!;
      const loaded = valueOf(loadScenario(scenario));
      const { settings, terrain, tickRate, timeScale } = scenario;
      const authority = valueOf(
        createAuthority({ ...MOON, settings, terrain, tickRate, timeScale, bodies: [loaded.body] }),
      );
      const { ship, inputs: plan } = loaded;
      expect(authority.spawn({ shipId: 'own', playerId: 'ann', name: 'Own', ship, plan })).toBeNull();
      valueOf(authority.join('ann', 'own'));
      const { ships } = valueOf(runScenario(scenario));
      const ticks = ships.length / SHIP_STRIDE - 1;
      for (let tick = 1; tick <= ticks; tick++) {
        runTo(authority, tick);
        const place = ships.slice(tick * SHIP_STRIDE, tick * SHIP_STRIDE + 3);
        expect(frameOf(authority).ships[0]!.relativePosition).toEqual([...place]);
      }
    },
  );

  it('flies it at its substeps though the server takes inputs at whole ticks only', () => {
    const authority = moonFlying([thrust(0, 50, 1)], { inputGranularity: 'tick' });
    runTo(authority, 1);
    const burnt = 4800 - frameOf(authority).ships[0]!.fuel;
    expect(burnt).toBeCloseTo((50 * 0.01 * 200000) / (340 * 9.80665), 9);
  });

  it('has at most 10,000 inputs', () => {
    const authority = valueOf(createAuthority(MOON));
    const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf('opening') };
    const plan = Array.from({ length: 10_001 }, (_, tick) => thrust(tick, 0, 1));
    expect(authority.spawn({ ...order, plan })).toMatch(/plan: expected at most 10000, got 10001$/);
    expect(authority.spawn({ ...order, plan: plan.slice(1) })).toBeNull();
  });

  it('drops it at its player’s first input, and never acknowledges it', () => {
    const authority = moonFlying([thrust(0, 10, 0.5), thrust(2, 0, 0.7)]);
    runTo(authority, 1);
    expect(frameOf(authority)).toMatchObject({ lastInput: null, ships: [{ thrustLevel: 0.5 }] });
    authority.receive('ann', { kind: 'inputs', inputs: [input(1, 1, 90, { thrustLevel: 0.2 })] }, 1.2);
    runTo(authority, 4);
    expect(frameOf(authority)).toMatchObject({ lastInput: { seq: 1 }, ships: [{ thrustLevel: 0.2 }] });
  });

  it('has none after despawn and spawn', () => {
    const authority = moonFlying([thrust(2, 0, 0.7)]);
    expect(authority.despawn('own')).toBeNull();
    runTo(authority, 1);
    const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf('opening') };
    expect(authority.spawn(order)).toBeNull();
    runTo(authority, 4);
    expect(frameOf(authority).ships[0]!.thrustLevel).toBe(0);
  });

  it.each([
    ['plan[1]: expected whole numbers', [thrust(3, 0, 0), thrust(2, 0, 0)]],
    ['plan[0]: expected whole numbers', [thrust(0, 0.5, 0)]],
    ['plan[0]: expected whole numbers', [thrust(-1, 0, 0)]],
    ['plan[0].controls.thrustLevel', [thrust(0, 0, Number.NaN)]],
    ['plan: expected at most', Array.from({ length: 10_001 }, () => thrust(0, 0, 0))],
  ])('is refused by field: %s', (field, plan) => {
    const authority = valueOf(createAuthority(MOON));
    const order = { shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf('opening') };
    expect(authority.spawn({ ...order, plan })).toContain(field);
    expect(authority.spawn(order)).toBeNull();
  });
});
