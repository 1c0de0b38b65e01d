import { describe, expect, it } from 'vitest';
import {
  type Body,
  BODY_STRIDE,
  type BodyMotion,
  type Controls,
  DEFAULT_SETTINGS,
  loadBody,
  loadControls,
  loadTiming,
  NEUTRAL_CONTROLS,
  readShip,
  SHIP_STRIDE,
  type ShipRecord,
  spawnShip,
  writeBodyMotion,
  writeShip,
} from '../../../src/dynamics';
import { NO_NUMBERS, reasonOf } from './hostile';
import { bodyNamed, createTrial, type Trial } from '../provingGround';

describe('a body', () => {
  const MOON = bodyNamed('Luna');

  it.each([...NO_NUMBERS, 0, -1])('refuses mass and radius %s and names the field', (value) => {
    expect(reasonOf(loadBody({ ...MOON, mass: value } as Body))).toMatch(/^body Luna: mass: /);
    expect(reasonOf(loadBody({ ...MOON, radius: value } as Body))).toMatch(/^body Luna: radius: /);
  });

  it.each([
    ['mass', '> 0', Number.MIN_VALUE, 1e40, 'kg'],
    ['radius', '≥ 0.001', 1e-3, 1e18, 'm'],
  ])('accepts a %s %s from %d to %d and names it when out of range', (name, low, least, most, unit) => {
    for (const value of [least, most])
      expect(reasonOf(loadBody({ ...MOON, [name]: value }))).toBe('accepted');
    const refusal = (value: number) => reasonOf(loadBody({ ...MOON, [name]: value }));
    expect(refusal(0)).toBe(`body Luna: ${name}: expected ${low} ${unit}, got 0`);
    for (const value of [most * 1.001, Number.MAX_VALUE])
      expect(refusal(value)).toBe(`body Luna: ${name}: expected ≤ ${most} ${unit}, got ${value}`);
  });

  it.each([
    ['position', 1e18, 'm'],
    ['velocity', 1e9, 'm/s'],
    ['angularVelocity', 1e6, 'rad/s'],
  ])('accepts a %s of up to %d either way and names it when out of range', (field, most, unit) => {
    const given = (part: number) =>
      writeBodyMotion(new Float64Array(BODY_STRIDE), 0, { ...MOON, [field]: [0, part, 0] });
    expect([given(most), given(-most)]).toEqual([null, null]);
    for (const part of [1.001 * most, -1.001 * most, -Number.MAX_VALUE]) {
      const range = part > 0 ? `≤ ${most}` : `≥ ${-most}`;
      expect(given(part)).toBe(`${field}[1]: expected ${range} ${unit}, got ${part}`);
    }
  });

  it('accepts an attitude of length 1 within 1e-3', () => {
    const given = (w: number) =>
      writeBodyMotion(new Float64Array(BODY_STRIDE), 0, { ...MOON, attitude: [0, 0, 0, w] });
    expect([1, 1.0009, 0.9991, -1].map(given)).toEqual([null, null, null, null]);
    for (const w of [0, 1.0011, 0.9989, 1e200])
      expect(given(w)).toMatch(/^attitude: expected length 1 within 0.001, got /);
  });

  it('refuses an empty name', () => {
    expect(reasonOf(loadBody({ ...MOON, name: '' }))).toBe('name: expected a non-empty string');
  });

  it.each(['position', 'velocity', 'attitude', 'angularVelocity'] as const)(
    'keeps its last motion when %s is refused',
    (field) => {
      const rows = new Float64Array(BODY_STRIDE);
      expect(writeBodyMotion(rows, 0, MOON)).toBeNull();
      const before = Array.from(rows);
      for (const value of NO_NUMBERS) {
        const motion = { ...MOON, [field]: MOON[field].map((part, k) => (k === 2 ? value : part)) };
        expect(writeBodyMotion(rows, 0, motion as BodyMotion)).toContain(
          `${field}[2]: expected a finite number`,
        );
      }
      expect(writeBodyMotion(rows, 0, { ...MOON, [field]: [1, 2] })).toContain(`${field}: `);
      expect(Array.from(rows)).toEqual(before);
    },
  );
});

describe('a ship', () => {
  const { world, ships }: Trial = createTrial({});
  const good = readShip(ships, 0, world);

  function refusal(given: Partial<Record<keyof ShipRecord, unknown>>): string | null {
    const rows = new Float64Array(SHIP_STRIDE);
    rows.set(ships);
    const reason = writeShip(rows, 0, { ...good, ...given } as ShipRecord, world);
    if (reason !== null) expect(Array.from(rows)).toEqual(Array.from(ships));
    expect(spawnShip(new Float64Array(SHIP_STRIDE), 0, { ...good, ...given } as ShipRecord, world)).toBe(
      reason,
    );
    return reason;
  }

  it('survives a round trip through a row', () => {
    expect(refusal({})).toBeNull();
    expect(readShip(ships, 0, world)).toEqual(good);
  });

  it.each(['relativePosition', 'relativeVelocity', 'attitude', 'angularVelocity'] as const)(
    'keeps its row when %s is refused, and names the field',
    (field) => {
      for (const value of NO_NUMBERS) {
        const parts = good[field].map((part, k) => (k === 1 ? value : part));
        expect(refusal({ [field]: parts })).toContain(`${field}[1]: expected a finite number`);
      }
      expect(refusal({ [field]: [1] })).toContain(`${field}: expected`);
      expect(refusal({ [field]: null })).toContain(`${field}: expected`);
    },
  );

  it.each<[keyof ShipRecord, unknown]>([
    ['relativePosition', [0, 0, 0]],
    ['relativePosition', [0.5, 0.5, 0.5]],
    ['attitude', [0, 0, 0, 0]],
    ['attitude', [0, 0, 0, 2]],
    ['fuel', -1],
    ['fuel', NaN],
    ['contactImpactSpeed', -1],
    ['contactImpactSpeed', Infinity],
    ['shipClass', 'other'],
    ['referenceBody', 'Vulcan'],
    ['surfaceContactState', 'hovering'],
    ['fuel', 1.001e15],
    ['contactImpactSpeed', 1.001e9],
  ])('is refused with %s %j, by name', (field, value) => {
    expect(refusal({ [field]: value })).toMatch(new RegExp(`^${field}: `));
  });
});

describe('a distant ship', () => {
  const { world, ships }: Trial = createTrial({});
  const good = readShip(ships, 0, world);

  it.each([
    ['relativePosition', 1e18, 'm'],
    ['relativeVelocity', 1e9, 'm/s'],
    ['angularVelocity', 1e6, 'rad/s'],
  ])('accepts a %s of up to %d either way and names it when out of range', (field, most, unit) => {
    const given = (part: number) =>
      writeShip(new Float64Array(SHIP_STRIDE), 0, { ...good, [field]: [part, 0, 0] }, world);
    expect([given(most), given(-most)]).toEqual([null, null]);
    for (const part of [1.001 * most, -1.001 * most, Number.MAX_VALUE]) {
      const range = part > 0 ? `≤ ${most}` : `≥ ${-most}`;
      expect(given(part)).toBe(`${field}[0]: expected ${range} ${unit}, got ${part}`);
    }
  });
});

describe('timing', () => {
  it.each([...NO_NUMBERS, 0, -1, 0.0999, 100.001])(
    'refuses a tick rate or time scale of %s and names it',
    (value) => {
      expect(reasonOf(loadTiming(value as number, 1, DEFAULT_SETTINGS))).toMatch(/^tickRate: expected/);
      expect(reasonOf(loadTiming(1, value as number, DEFAULT_SETTINGS))).toMatch(/^timeScale: expected/);
    },
  );
});

describe('controls', () => {
  function refusal(given: Partial<Record<keyof Controls, unknown>>): string {
    return reasonOf(loadControls({ ...NEUTRAL_CONTROLS, ...given } as Controls));
  }

  it.each(NO_NUMBERS)('refuse %s on entry and name the field', (value) => {
    expect(refusal({ thrustLevel: value })).toMatch(/^thrustLevel: /);
    expect(refusal({ translationInput: [0, value, 0] })).toMatch(/^translationInput\[1\]: /);
    expect(refusal({ rotationInput: [0, 0, value] })).toMatch(/^rotationInput\[2\]: /);
    expect(refusal({ targetAttitude: [value, 0, 0, 1] })).toMatch(/^targetAttitude\[0\]: /);
  });

  it.each<[keyof Controls, unknown]>([
    ['translationInput', [0, 0]],
    ['rotationInput', null],
    ['targetAttitude', [0, 0, 0]],
    ['targetAttitude', [0, 0, 0, 0]],
    ['targetAttitude', [1e-9, 0, 0, 0]],
    ['attitudeHold', 1],
    ['attitudeHold', undefined],
    ['attitudeMode', 3],
  ])('refuse %s = %j and name it', (field, value) => {
    expect(refusal({ [field]: value })).toMatch(new RegExp(`^${field}: `));
  });
});
