import { describe, expect, it } from 'vitest';
import { hillsTerrain } from '../../../../src/dynamics';
import { createRig, scenarioNamed, SHIP } from '../../rig';
import { distance, sampleOf, truthAt, type Sample } from '../../samples';

/** Flies and returns the error of the drawn ship, m, in the last `seconds`. */
function errorsOf(rig: ReturnType<typeof createRig>, seconds: number): number[] {
  const samples: Sample[] = [];
  rig.fly(seconds, (view) => {
    if (view.ready && view.own !== null) samples.push(sampleOf(view, rig.now));
  });
  return samples.flatMap((sample) => {
    const truth = truthAt(rig.truth, sample);
    return truth === null ? [] : [distance(sample.drawn, truth.position)];
  });
}

describe('a ship that the law does not fit', () => {
  it('is extrapolated, never confirmed meanwhile, counted, and predicted again later', () => {
    // On the client the ships weigh a fiftieth, so their own thrust throws them away.
    const scenario = { ...scenarioNamed('launch'), duration: 40 };
    const rig = createRig({ scenario, tickRate: 5, pilot: () => hover });
    rig.tamper = (message) => {
      if (message.kind !== 'hello') return [message];
      const shipClasses = message.shipClasses.map((one) => ({ ...one, mainEngineThrust: 8e6 }));
      return [{ ...message, shipClasses }];
    };
    rig.fly(4);
    let confirmed = 0;
    rig.fly(1, ({ own }) => {
      expect(own!.extrapolated).toBe('law');
      if (own!.provenance === 'confirmed') confirmed += 1;
    });
    expect(confirmed).toBe(0);
    expect(rig.view().diagnosis.shipsExtrapolated).toBe(1);
    expect(rig.view().own!.extrapolatedStates).toBeGreaterThan(4);
    expect(rig.view().diagnosis.statesExtrapolated).toBe(rig.view().own!.extrapolatedStates);
    // Extrapolation is off by the ship's acceleration over an interval and the lead; the law by forty times that.
    expect(Math.max(...errorsOf(rig, 1))).toBeLessThan(1.5);
    cut = true;
    rig.fly(3);
    expect(rig.view().own!.extrapolated).toBe('');
  });

  it('applies to no ship that the law fits', () => {
    const rig = createRig({ scenario: 'opening', tickRate: 5 });
    let looked = 0;
    rig.fly(20, ({ ships }) => {
      looked += ships.length;
      for (const { extrapolated, extrapolatedStates } of ships)
        expect([extrapolated, extrapolatedStates]).toEqual(['', 0]);
    });
    expect(looked).toBeGreaterThan(500);
  });
});

let cut = false;
const neutral = createRig({ scenario: 'launch' }).loaded.inputs.at(-1)!.controls;
const hover = {
  ...neutral,
  get thrustLevel() {
    return cut ? 0 : 0.3;
  },
};

describe('terrain that is not loaded', () => {
  it('null: the ship is drawn from its states and marked as extrapolated, until the terrain is loaded', () => {
    let loaded = false;
    const terrain = (...place: Parameters<typeof hillsTerrain>) => (loaded ? hillsTerrain(...place) : null);
    const rig = createRig({ scenario: 'slide', tickRate: 5, predictor: { terrains: { hills: terrain } } });
    rig.fly(3, ({ ready, own, diagnosis }) => {
      if (!ready || own === null) return;
      expect(own.extrapolated).toBe('ground');
      expect(own.provenance).not.toBe('confirmed');
      expect(diagnosis.shipsExtrapolated).toBe(1);
      for (const x of [...own.meshPosition, own.groundRadius, own.feetHeight]) expect(x).not.toBeNaN();
    });
    expect(Math.max(...errorsOf(rig, 2))).toBeLessThan(0.3);
    loaded = true;
    rig.fly(1);
    expect(rig.view().ships.find(({ shipId }) => shipId === SHIP)!.extrapolated).toBe('');
    expect(Math.max(...errorsOf(rig, 2))).toBeLessThan(1e-6);
  });
});
