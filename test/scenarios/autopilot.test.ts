import { describe, expect, it } from 'vitest';
import { BODIES, flatTerrain, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../src/dynamics';
import { BEGIN_LANDING, continueLanding, type LandingManeuver, type LandingSite } from '../../src/scenarios';
import type { ShipState } from '../../src/wire';
import { flyDown, LANDER_CLASS } from './autopilotFlight';

const MOON = BODIES.find(({ name }) => name === 'Luna')!;
const SITE: LandingSite = { body: MOON, shipClass: LANDER_CLASS, terrainHeight: flatTerrain };

/** 100 m over the Moon's prime meridian, sinking at 5 m/s with the ground below. */
const ABOVE: ShipState = {
  ...NEUTRAL_CONTROLS,
  shipId: 'one',
  playerId: 'ann',
  name: 'One',
  shipClass: LANDER_CLASS.name,
  position: [MOON.position[0], MOON.position[1], MOON.position[2] + 1737504.56],
  velocity: [MOON.velocity[0] + 2.6617e-6 * 1737504.56, MOON.velocity[1], MOON.velocity[2] - 5],
  attitude: [0, 0, 0, 1],
  angularVelocity: [0, 0, 0],
  fuel: 4000,
  mass: 12000,
  landedBodyName: '',
  surfaceContactState: '',
  contactImpactSpeed: 0,
  referenceBody: 'Luna',
  relativePosition: [0, 0, 1737504.56],
  relativeVelocity: [2.6617e-6 * 1737504.56, 0, -5],
  wheelMomentum: [0, 0, 0],
  groundContactOffset: null,
  crashed: false,
};

function next(ship: Partial<ShipState>, before = BEGIN_LANDING, site = SITE): LandingManeuver {
  const checked = continueLanding(before, { ...ABOVE, ...ship }, site);
  if (!checked.ok) throw new Error(checked.reason);
  return checked.value;
}

function refusal(ship: Partial<ShipState>, site = SITE): string {
  const checked = continueLanding(BEGIN_LANDING, { ...ABOVE, ...ship }, site);
  return checked.ok ? '' : checked.reason;
}

describe('the landing autopilot, in an authority from 200 m', () => {
  const bodies = ['Luna', 'Earth', 'Mars', 'Phobos'];
  const classes = ['planetary_lander', 'fast_frigate'].map((name) =>
    SHIP_CLASSES.find((known) => known.name === name)!,
  );

  // Measured: touches between 0.9 and 1.8 m/s; the design requires less than 3. Without and with a tick between state and controls.
  it.each(bodies.flatMap((body) => [1, 10, 50].map((tickRate) => [body, tickRate] as const)))(
    'lands softly on %s at %d Hz',
    (body, tickRate) => {
      for (const delay of [0, 1]) {
        for (const shipClass of classes) {
          const { maneuver, phases, ship, impact, touches } = flyDown({ body, tickRate, delay, shipClass });
          expect([maneuver.phase, maneuver.reason]).toEqual(['complete', '']);
          expect(phases.at(0)).toBe('descent');
          expect(ship.surfaceContactState).toBe('landed');
          expect(maneuver.controls).toEqual(NEUTRAL_CONTROLS);
          expect(touches).toBe(1);
          expect(impact).toBeGreaterThan(0.5);
          expect(impact).toBeLessThan(2);
        }
      }
    },
  );

  it.each(['Luna', 'Earth', 'Mars'])('nulls drift, spin and tilt on the way down on %s', (body) => {
    const initial = { velocity: [10, -5, -8], tilt: 40, spin: [0.2, 0.1, 0] } as const;
    const { maneuver, impact, ship } = flyDown({ body, tickRate: 10, initial });
    expect(maneuver.phase).toBe('complete');
    expect(impact).toBeLessThan(2);
    expect(ship.surfaceContactState).toBe('landed');
  });

  it('lands on hills', () => {
    const { maneuver, impact } = flyDown({ body: 'Luna', tickRate: 10, terrain: 'hills' });
    expect(maneuver.phase).toBe('complete');
    expect(impact).toBeLessThan(2.5);
  });

  it('lands from ICRF alone when the server sends no relative state', () => {
    const { maneuver, ship } = flyDown({ body: 'Luna', tickRate: 10, legacy: true });
    expect(ship.relativePosition).toBeNull();
    expect(maneuver.phase).toBe('complete');
  });

  it('fails with a reason when the ship topples', () => {
    const initial = { height: 0.2, velocity: [0, 0, -1], tilt: 60 } as const;
    const settings = { touchdownAttitude: 'kept' } as const;
    const shipClass = { ...LANDER_CLASS, rcsTorque: [0, 0, 0] } as const;
    const tipped = flyDown({ body: 'Luna', tickRate: 10, initial, settings, shipClass });
    expect(tipped.phases).toEqual(['descent', 'touchdown', 'failed']);
    expect(tipped.maneuver.reason).toBe('tipped over on Luna');
    expect(tipped.ship.surfaceContactState).toBe('tipped');
  });

  it('fails with a reason when it approaches too fast, and when the engine is too weak', () => {
    const crash = flyDown({ body: 'Luna', tickRate: 10, initial: { velocity: [0, 0, -150] } });
    expect([crash.maneuver.phase, crash.maneuver.reason]).toEqual(['failed', 'crashed on Luna']);
    const hauler = SHIP_CLASSES.find(({ name }) => name === 'cargo_hauler')!;
    const weak = flyDown({ body: 'Earth', tickRate: 10, shipClass: hauler });
    expect(weak.maneuver.reason).toMatch(/^mainEngineThrust: 400000 N cannot hold a weight of \d+ N$/);
  });
});

describe('the landing maneuver', () => {
  it('pushes against a drift in proportion, and at most with all that the thrusters have', () => {
    const [wx, wy] = MOON.angularVelocity;
    const [, , distance] = ABOVE.relativePosition!;
    const sideways = (drift: number) =>
      next({
        relativeVelocity: [wy * distance + drift, -wx * distance - drift, -5],
      }).controls.translationInput.slice(0, 2);
    const [thrust] = LANDER_CLASS.rcsThrust;
    // Half of the drift per second, by 12 t.
    const gentle = (0.5 * 12_000 * 0.01) / thrust;
    expect(sideways(0.01)).toEqual([expect.closeTo(-gentle, 9), expect.closeTo(gentle, 9)]);
    expect(sideways(50)).toEqual([-1, 1]);
    expect(sideways(-50)).toEqual([1, -1]);
  });

  const descending = next({});

  it('treats contact as touchdown: engine off, rates damped', () => {
    expect(descending.phase).toBe('descent');
    expect(next({ relativeVelocity: [4.62, 0, -14] }).controls.thrustLevel).toBeGreaterThan(0);
    const touchdown = next({ surfaceContactState: 'contact', landedBodyName: 'Luna' }, descending);
    expect(touchdown).toEqual({
      phase: 'touchdown',
      reason: '',
      controls: { ...NEUTRAL_CONTROLS, attitudeHold: true },
    });
  });

  it('completes on landed', () => {
    const landed = next({ surfaceContactState: 'landed' }, next({ surfaceContactState: 'contact' }));
    expect(landed).toEqual({ phase: 'complete', reason: '', controls: NEUTRAL_CONTROLS });
  });

  it('fails with the impact speed on a touch hard enough to bounce', () => {
    const contact = { surfaceContactState: 'contact', landedBodyName: 'Luna' };
    expect(next({ ...contact, contactImpactSpeed: 10 }).phase).toBe('touchdown');
    const hit = next({ ...contact, contactImpactSpeed: 33.14 });
    expect([hit.phase, hit.reason]).toEqual(['failed', 'hit Luna at 33.1 m/s']);
    expect(
      next({ ...contact, contactImpactSpeed: 33.14 }, BEGIN_LANDING, { ...SITE, bounceSpeed: 40 }).phase,
    ).toBe('touchdown');
  });

  it('fails with a reason on tipped and on crashed', () => {
    expect(next({ surfaceContactState: 'tipped' }, descending)).toMatchObject({
      phase: 'failed',
      reason: 'tipped over on Luna',
      controls: { thrustLevel: 0 },
    });
    expect(next({ crashed: true }, descending)).toMatchObject({ phase: 'failed', reason: 'crashed on Luna' });
  });

  it('stays in its final phase, whatever the ship does', () => {
    const complete = next({ surfaceContactState: 'landed' });
    const failed = next({ surfaceContactState: 'tipped' });
    for (const state of ['', 'contact', 'landed', 'tipped'] as const) {
      expect(next({ surfaceContactState: state }, complete)).toBe(complete);
      expect(next({ surfaceContactState: state }, failed)).toBe(failed);
    }
  });

  it('leaves a low hop alone and flies a high bounce', () => {
    const touchdown = next({ surfaceContactState: 'contact' });
    expect(next({ relativePosition: [0, 0, 1737406.5] }, touchdown).phase).toBe('touchdown');
    expect(next({ relativePosition: [0, 0, 1737504.5] }, touchdown).phase).toBe('descent');
  });

  it('is pure: the same state gives the same result, and arguments are not changed', () => {
    const frozen = Object.freeze({ ...ABOVE });
    const [once, again] = [
      continueLanding(descending, frozen, SITE),
      continueLanding(descending, frozen, SITE),
    ];
    expect(again).toEqual(once);
    expect(descending).toEqual(next({}));
  });

  it.each<[string, Partial<ShipState>]>([
    ['relativePosition', { relativePosition: [Number.NaN, 0, 0] }],
    ['relativePosition', { relativePosition: [0, 0, 0] }],
    ['relativePosition', { relativePosition: [0, 0, Infinity] }],
    ['relativePosition', { relativePosition: null, position: [Number.NaN, 0, 0] }],
    ['relativeVelocity', { relativeVelocity: [0, Number.NaN, 0] }],
    ['relativeVelocity', { relativeVelocity: null, velocity: [0, 0, -Infinity] }],
    ['attitude', { attitude: [0, Number.NaN, 0, 1] }],
    ['angularVelocity', { angularVelocity: [Infinity, 0, 0] }],
    ['mass', { mass: Number.NaN }],
    ['mass', { mass: 0 }],
  ])('refuses an invalid %s by name', (field, ship) => {
    expect(refusal(ship)).toMatch(new RegExp(`^${field}: `));
  });

  it('refuses an invalid delay', () => {
    for (const delay of [Number.NaN, Infinity, -0.1])
      expect(refusal({}, { ...SITE, delay })).toMatch(/^delay: /);
  });

  it('refuses an invalid target', () => {
    expect(refusal({}, { ...SITE, target: [0, Number.NaN, 0] })).toMatch(/^target: /);
  });

  it('refuses terrain without a height', () => {
    expect(refusal({}, { ...SITE, terrainHeight: () => Number.NaN })).toMatch(/^terrainHeight: /);
  });
});
