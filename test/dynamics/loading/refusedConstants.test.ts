import { describe, expect, it } from 'vitest';
import {
  DEFAULT_SETTINGS,
  loadSettings,
  loadShipClass,
  type Settings,
  type ShipClass,
} from '../../../src/dynamics';
import { NO_NUMBERS, reasonOf } from './hostile';
import { LANDER } from '../provingGround';

describe('settings', () => {
  const NUMBERS = Object.keys(DEFAULT_SETTINGS).filter(
    (name) => name !== 'touchdownAttitude' && name !== 'surfaceNormal',
  );

  it('have the design’s defaults', () => {
    expect(DEFAULT_SETTINGS).toEqual({
      contactCrashSpeed: 50,
      contactBounceSpeed: 10,
      contactSettleTiltDeg: 5,
      contactSettleAngularVel: 0.01,
      contactSettleLinearVel: 0.5,
      contactTippedAngleDeg: 80,
      contactDampingRatio: 0.3,
      contactFrictionStatic: 0.8,
      contactFrictionKinetic: 0.5,
      touchdownAttitude: 'aligned',
      surfaceNormal: 'radial',
      contactLongestSubstep: 0.01,
    });
    expect(loadSettings({}).ok).toBe(true);
  });

  it.each(NUMBERS.flatMap((name) => NO_NUMBERS.map((value) => [name, value] as const)))(
    'refuse %s = %s and name it',
    (name, value) => {
      expect(reasonOf(loadSettings({ [name]: value }))).toMatch(
        new RegExp(`^${name}: expected a finite number`),
      );
    },
  );

  it.each<[keyof Settings, Partial<Settings>, string]>([
    ['contactCrashSpeed', { contactCrashSpeed: 0 }, '> 0 m/s'],
    ['contactBounceSpeed', { contactBounceSpeed: -1 }, '> 0 m/s'],
    ['contactBounceSpeed', { contactBounceSpeed: 50 }, '< contactCrashSpeed (50 m/s)'],
    ['contactSettleAngularVel', { contactSettleAngularVel: 0 }, '> 0 rad/s'],
    ['contactSettleLinearVel', { contactSettleLinearVel: 0 }, '> 0 m/s'],
    ['contactSettleTiltDeg', { contactSettleTiltDeg: 0 }, '> 0°'],
    ['contactSettleTiltDeg', { contactSettleTiltDeg: 80 }, '< contactTippedAngleDeg (80°)'],
    ['contactTippedAngleDeg', { contactTippedAngleDeg: 90 }, '< 90°'],
    ['contactDampingRatio', { contactDampingRatio: 0 }, '> 0 and ≤ 1'],
    ['contactDampingRatio', { contactDampingRatio: 1.001 }, '> 0 and ≤ 1'],
    ['contactFrictionStatic', { contactFrictionStatic: 2.001 }, '≥ 0 and ≤ 2'],
    ['contactFrictionKinetic', { contactFrictionKinetic: -0.001 }, '≥ 0 and ≤ contactFrictionStatic (0.8)'],
    ['contactFrictionKinetic', { contactFrictionKinetic: 0.801 }, '≥ 0 and ≤ contactFrictionStatic (0.8)'],
    ['touchdownAttitude', { touchdownAttitude: 'upright' as 'kept' }, "'aligned' or 'kept'"],
    ['surfaceNormal', { surfaceNormal: 'level' as 'radial' }, "'radial' or 'terrain'"],
    ['contactLongestSubstep', { contactLongestSubstep: 0.0009 }, '0.001 … 0.022 s'],
    ['contactLongestSubstep', { contactLongestSubstep: 0.0221 }, '0.001 … 0.022 s'],
  ])('refuse %s with its range', (name, given, range) => {
    const reason = reasonOf(loadSettings(given));
    expect(reason).toContain(`${name}: expected ${range}`);
  });

  it.each<Partial<Settings>>([
    { contactCrashSpeed: 10.001 },
    { contactDampingRatio: 1 },
    { contactFrictionStatic: 2, contactFrictionKinetic: 2 },
    { contactFrictionStatic: 0, contactFrictionKinetic: 0 },
    { contactTippedAngleDeg: 89.999 },
    { contactSettleTiltDeg: 79.999 },
    { touchdownAttitude: 'kept' },
    { surfaceNormal: 'terrain' },
    { contactLongestSubstep: 0.001 },
    { contactLongestSubstep: 0.022 },
  ])('accept the ends of the ranges: %j', (given) => {
    expect(reasonOf(loadSettings(given))).toBe('accepted');
  });

  it.each([
    ['contactCrashSpeed', 1e9, 'm/s'],
    ['contactSettleLinearVel', 1e9, 'm/s'],
    ['contactSettleAngularVel', 1e6, 'rad/s'],
  ])('accept %s up to %d and refuse more', (name, most, unit) => {
    expect(reasonOf(loadSettings({ [name]: most }))).toBe('accepted');
    for (const value of [most * 1.001, Number.MAX_VALUE])
      expect(reasonOf(loadSettings({ [name]: value }))).toBe(
        `${name}: expected ≤ ${most} ${unit}, got ${value}`,
      );
  });

  it('refuse unknown names', () => {
    expect(reasonOf(loadSettings({ contactSprings: 1 } as Partial<Settings>))).toBe(
      'contactSprings: no such setting',
    );
  });
});

describe('a ship class', () => {
  const SCALARS = ['dryMass', 'fuelCapacity', 'groundContactOffset', 'legRadius'] as const;
  const DRIVES = [
    'mainEngineThrust',
    'mainEngineIsp',
    'rcsLever',
    'rcsIsp',
    'attitudeNaturalFrequency',
  ] as const;
  const TRIPLES = ['rcsThrust', 'rcsTorque', 'reactionWheelTorque', 'reactionWheelCapacity'] as const;

  function refusal(given: Partial<Record<keyof ShipClass, unknown>>): string {
    return reasonOf(loadShipClass({ ...LANDER, ...given } as ShipClass));
  }

  it.each([...SCALARS, ...DRIVES].flatMap((name) => NO_NUMBERS.map((value) => [name, value] as const)))(
    'refuses %s = %s and names it',
    (name, value) => {
      expect(refusal({ [name]: value })).toContain(`lander: ${name}: expected a finite number`);
    },
  );

  it.each(TRIPLES.flatMap((name) => NO_NUMBERS.map((value) => [name, value] as const)))(
    'refuses %s with a %s and names it',
    (name, value) => {
      expect(refusal({ [name]: [1, value, 1] })).toContain(`${name}[1]: expected a finite number`);
      // Without a capacity wheels are never full.
      if (name !== 'reactionWheelCapacity' || value !== null)
        expect(refusal({ [name]: value })).toContain(`${name}: expected 3 numbers`);
      expect(refusal({ [name]: [1, -1, 1] })).toContain(`${name}[1]: expected ≥ 0 N`);
    },
  );

  it.each([
    ['dryMass', '≥ 0.001', 1e-3, 1e15, 'kg'],
    ['fuelCapacity', '≥ 0', 0, 1e15, 'kg'],
    ['groundContactOffset', '≥ 0', 0, 1e6, 'm'],
    ['legRadius', '≥ 0.001', 1e-3, 1e6, 'm'],
    ['mainEngineThrust', '≥ 0', 0, 1e15, 'N'],
    ['mainEngineIsp', '≥ 0.001', 1e-3, 1e8, 's'],
    ['rcsLever', '≥ 0.001', 1e-3, 1e6, 'm'],
    ['rcsIsp', '≥ 0.001', 1e-3, 1e8, 's'],
    ['attitudeNaturalFrequency', '> 0', Number.MIN_VALUE, 5, 'rad/s'],
  ])('accepts a %s %s from %d to %d %s and names it when out of range', (name, ...range) => {
    const [low, least, most, unit] = range;
    const reason = `ship class lander: ${name}: expected`;
    for (const value of [least, most]) expect(refusal({ [name]: value })).toBe('accepted');
    for (const value of [-1, least === 0 ? -1e-9 : 0, ...(least === 1e-3 ? [0.00099] : [])])
      expect(refusal({ [name]: value })).toBe(`${reason} ${low} ${unit}, got ${value}`);
    for (const value of [most * 1.001, Number.MAX_VALUE])
      expect(refusal({ [name]: value })).toBe(`${reason} ≤ ${most} ${unit}, got ${value}`);
  });

  it('accepts a dryInertiaRatio up to 1, or none, and names it when out of range', () => {
    for (const value of [null, 1e-6, 0.5, 1]) expect(refusal({ dryInertiaRatio: value })).toBe('accepted');
    const reason = 'ship class lander: dryInertiaRatio: expected';
    for (const value of [-1, 0])
      expect(refusal({ dryInertiaRatio: value })).toBe(`${reason} ≥ 0.000001, got ${value}`);
    expect(refusal({ dryInertiaRatio: 1.001 })).toBe(`${reason} ≤ 1, got 1.001`);
    expect(refusal({ dryInertiaRatio: NaN })).toContain(`${reason} a finite number`);
  });

  it('accepts infinite wheel capacity and a tank of at least a milligram', () => {
    expect(refusal({ reactionWheelCapacity: null })).toBe('accepted');
    expect(refusal({ fuelCapacity: 1e-6 })).toBe('accepted');
    expect(refusal({ fuelCapacity: 1e-7 })).toContain('fuelCapacity: expected ≥ 0.000001 kg');
  });

  it.each([
    ['rcsThrust', 'N'],
    ['rcsTorque', 'N m'],
    ['reactionWheelTorque', 'N m'],
    ['reactionWheelCapacity', 'N m s'],
  ])('accepts %s up to 1e15 about each axis', (name, unit) => {
    expect(refusal({ [name]: [1e15, 0, 1e15] })).toBe('accepted');
    expect(refusal({ [name]: [0, 0, 1.1e15] })).toContain(
      `${name}[2]: expected ≤ 1000000000000000 ${unit}, got`,
    );
  });

  it('needs isp and lever only for the drives it has', () => {
    const without = { mainEngineThrust: 0, mainEngineIsp: 0, rcsThrust: [0, 0, 0], rcsTorque: [0, 0, 0] };
    expect(refusal({ ...without, rcsLever: 0, rcsIsp: 0 })).toBe('accepted');
    expect(refusal({ ...without, rcsThrust: [0, 0, 1], rcsIsp: 0 })).toContain('rcsIsp: ');
    expect(refusal({ ...without, rcsTorque: [0, 1, 0], rcsLever: 0 })).toContain('rcsLever: ');
  });
});
