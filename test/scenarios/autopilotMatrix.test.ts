import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { BODIES, GRAVITATIONAL_CONSTANT, SHIP_CLASSES, type ShipClass, type Vec3 } from '../../src/dynamics';
import type { LocalState } from '../../src/scenarios';
import { flyDown, LANDER_CLASS } from './autopilotFlight';

const BODY_NAMES = ['Luna', 'Earth', 'Mars', 'Phobos'];
const STARTS: Readonly<Record<string, Partial<LocalState>>> = {
  upright: {},
  sideways: { tilt: 90, leanTo: 70 },
  'upside down': { tilt: 180 },
  'nearly upside down': { tilt: 170, leanTo: 200, heading: 40 },
  'turning away': { tilt: 150, spin: [-0.8, 0, 0] },
  spinning: { tilt: 30, spin: [0.5, -0.4, 0.3] },
  tumbling: { tilt: 120, leanTo: 300, spin: [0.8, 0.6, -0.5] },
};
const CASES = Object.keys(STARTS).flatMap((start) => BODY_NAMES.map((body) => [start, body] as const));
/**
 * m. The controller turns the lander at ω_n / 2 = 0.5 rad/s at most: upside down over Earth it then needs 400 m to land
 * softly at 10 Hz and 600 m at 1 Hz with a tick's delay, by trial in steps of 100 m; the rest is for spin and drift.
 */
const HEIGHTS: Readonly<Record<string, number>> = { Earth: 900 };
const startFrom = (body: string, start: Partial<LocalState>) => ({ height: HEIGHTS[body] ?? 200, ...start });
const TEMPI = [1, 10].flatMap((tickRate) => [0, 1].map((delay) => ({ tickRate, delay })));

describe('the landing autopilot at any attitude', () => {
  // Measured: touches between 0.9 and 2.0 m/s, upside down on Earth at 1 Hz with a tick's delay the fastest; the design requires less than 3.
  it.each(CASES)(
    'lands softly from %s over %s at 1 and 10 Hz, without delay and a tick late',
    (start, body) => {
      for (const tempo of TEMPI) {
        const { maneuver, ship, impact } = flyDown({
          body,
          ...tempo,
          initial: startFrom(body, STARTS[start]!),
        });
        expect([maneuver.phase, maneuver.reason, ship.surfaceContactState]).toEqual([
          'complete',
          '',
          'landed',
        ]);
        expect(impact, JSON.stringify(tempo)).toBeGreaterThan(0.5);
        expect(impact, JSON.stringify(tempo)).toBeLessThan(2.2);
      }
    },
  );

  // Of 600 such the fastest touched at 1.98 m/s.
  it('lands softly from any attitude, spin and drift', () => {
    const part = fc.double({ min: -1, max: 1, noNaN: true });
    const given = fc.record({
      body: fc.constantFrom(...BODY_NAMES),
      tempo: fc.constantFrom(...TEMPI),
      tilt: fc.double({ min: 0, max: 180, noNaN: true }),
      leanTo: fc.double({ min: 0, max: 360, noNaN: true }),
      spin: fc.tuple(part, part, part).map(([x, y, z]): Vec3 => [0.8 * x, 0.8 * y, 0.8 * z]),
      velocity: fc.tuple(part, part, part).map(([x, y, z]): Vec3 => [8 * x, 8 * y, 5 * z]),
    });
    fc.assert(
      fc.property(given, ({ body, tempo, ...initial }) => {
        const { maneuver, impact } = flyDown({ body, ...tempo, initial: startFrom(body, initial) });
        expect([maneuver.phase, maneuver.reason]).toEqual(['complete', '']);
        expect(impact).toBeGreaterThan(0.5);
        expect(impact).toBeLessThan(3);
      }),
      { seed: 20_260, numRuns: 80 },
    );
  });
});

describe('the limit of the autopilot: a ship that turns more slowly than it falls', () => {
  const FRIGATE = SHIP_CLASSES.find(({ name }) => name === 'fast_frigate')!;

  /**
   * Metres that a ship falls from rest until its engine holds it: turned from `tilt` to 90° by its controller, whose rate is
   * ω_n / 2 at most, then braked with all of the engine's excess thrust.
   */
  function leastFall(shipClass: ShipClass, bodyName: string, tilt: number): number {
    const { mass, radius } = BODIES.find(({ name }) => name === bodyName)!;
    const gravity = (GRAVITATIONAL_CONSTANT * mass) / (radius * radius);
    const seconds = (((tilt - 90) / 180) * Math.PI) / (shipClass.attitudeNaturalFrequency / 2);
    const reserve = shipClass.mainEngineThrust / (shipClass.dryMass + 0.6 * shipClass.fuelCapacity) - gravity;
    return 0.5 * gravity * seconds ** 2 * (1 + gravity / reserve);
  }

  it('is not reached by the frigate on its side over the Moon, Mars and Phobos', () => {
    for (const body of ['Luna', 'Mars', 'Phobos'])
      for (const tempo of TEMPI) {
        const { maneuver, impact } = flyDown({
          body,
          ...tempo,
          shipClass: FRIGATE,
          initial: { tilt: 90, leanTo: 70 },
        });
        expect([maneuver.phase, maneuver.reason]).toEqual(['complete', '']);
        expect(impact).toBeLessThan(2.2);
      }
  });

  it('is passed by the frigate upside down over Earth: the maneuver fails with its reason', () => {
    expect(leastFall(FRIGATE, 'Earth', 180)).toBeGreaterThan(200);
    for (const tempo of TEMPI) {
      const { maneuver } = flyDown({ body: 'Earth', ...tempo, shipClass: FRIGATE, initial: { tilt: 180 } });
      expect([maneuver.phase, maneuver.reason]).toEqual(['failed', 'crashed on Earth']);
    }
  });

  it('can be passed by a lander without its control delay: it starts its engine too late', () => {
    expect(leastFall(LANDER_CLASS, 'Earth', 180)).toBeLessThan(200);
    const initial = { height: 500, tilt: 170, leanTo: 200, heading: 40 };
    const worst = { body: 'Earth', tickRate: 1, delay: 1, initial };
    expect(flyDown(worst).impact).toBeLessThan(2.2);
    expect(flyDown({ ...worst, ignoresDelay: true }).impact).toBeGreaterThan(10);
  });
});
