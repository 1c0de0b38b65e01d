import { describe, expect, it } from 'vitest';
import { BODIES, flatTerrain, NEUTRAL_CONTROLS, type Vec3 } from '../../src/dynamics';
import { brakeDrift, type LandingSite } from '../../src/scenarios';
import type { ShipState } from '../../src/wire';
import { LANDER_CLASS } from './autopilotFlight';

/** A moon that does not turn. */
const MOON = { ...BODIES.find(({ name }) => name === 'Luna')!, angularVelocity: [0, 0, 0] as Vec3 };
const SITE: LandingSite = { body: MOON, shipClass: LANDER_CLASS, terrainHeight: flatTerrain };
const GROUND = MOON.radius + LANDER_CLASS.groundContactOffset;

/** 600 m up, 40 m/s to the east, sinking at 5 m/s, with its thrust to the west. */
const FAST = {
  ...NEUTRAL_CONTROLS,
  attitude: [0, -Math.SQRT1_2, 0, Math.SQRT1_2],
  angularVelocity: [0, 0, 0],
  mass: 12000,
  relativePosition: [0, 0, GROUND + 600],
  relativeVelocity: [40, 0, -5],
} as unknown as ShipState;

describe('braking a fast drift', () => {
  /** The thrust level; null for the vertical descent. */
  const brake = (change: Partial<ShipState>, isBraking = false, thrust = LANDER_CLASS.mainEngineThrust) => {
    const site = { ...SITE, shipClass: { ...LANDER_CLASS, mainEngineThrust: thrust } };
    const braking = brakeDrift(isBraking, { ...FAST, ...change }, site);
    return braking.ok ? (braking.value?.thrustLevel ?? null) : braking.reason;
  };
  const brakes = (change: Partial<ShipState>, isBraking: boolean) => brake(change, isBraking) !== null;

  it('burns at 3 m/s² beyond gravity once it points against the motion, and only turns before', () => {
    expect(brake({})).toBeCloseTo((12000 * (3 + 1.6233)) / LANDER_CLASS.mainEngineThrust, 3);
    expect(brake({ attitude: [0, 0, 0, 1] })).toBe(0);
    expect(brakeDrift(false, FAST, SITE)).toMatchObject({ value: { attitudeMode: 'surface_retrograde' } });
    expect(brake({}, false, 24000)).toBe(1);
  });

  it('begins above 8 m/s, and ends at 2 m/s', () => {
    const at = (speed: number) => ({ relativeVelocity: [speed, 0, -5] as Vec3 });
    expect([brakes(at(7.9), false), brakes(at(8.1), false)]).toEqual([false, true]);
    expect([brakes(at(1.9), true), brakes(at(2.1), true)]).toEqual([false, true]);
  });

  it('begins with the height that it takes, and ends 50 m above the ground', () => {
    const at = (height: number) => ({ relativePosition: [0, 0, GROUND + height] as Vec3 });
    // 5 s of gravity while it turns; 5 m/s for the braking and 5 s before and after it.
    const taken = 50 + 5 * 1.6233 * 5 + 5 * (40 / 3 + 10);
    expect([brakes(at(taken - 1), false), brakes(at(taken + 1), false)]).toEqual([false, true]);
    expect([brakes(at(49), true), brakes(at(51), true)]).toEqual([false, true]);
  });

  it('is left to the descent where the engine cannot hold the ship, and refuses a state by name', () => {
    expect(brake({}, false, 19000)).toBeNull();
    expect(brake({ mass: NaN })).toBe('mass: expected a finite number > 0 kg');
  });
});
