import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ANGLE,
  BEARING,
  COUNT,
  DELTA_V,
  DISTANCE,
  DURATION,
  FINE_SPEED,
  type Format,
  MASS,
  PERCENT,
  SPEED,
  SPIN,
  TORQUE,
  VERTICAL_SPEED,
} from '../../src/readout';

const shown = (format: Format, value: number) => format.text(format.key(value));

describe('formats', () => {
  it('are the HUD’s own', () => {
    expect(shown(VERTICAL_SPEED, 12.3)).toBe('↓ 12.3 m/s');
    expect(shown(VERTICAL_SPEED, -4.56)).toBe('↑ 4.6 m/s');
    expect(shown(VERTICAL_SPEED, -0.04)).toBe('0.0 m/s');
    expect(shown(DISTANCE, 0.84)).toBe('0.8 m');
    expect(shown(DISTANCE, 123.4)).toBe('123 m');
    expect(shown(DISTANCE, 4321)).toBe('4\u202f321 m');
    expect(shown(DISTANCE, 49_876)).toBe('49.9 km');
    expect(shown(DURATION, 4.25)).toBe('4.3 s');
    expect(shown(DURATION, 125)).toBe('2 min 05 s');
    expect(shown(DURATION, 1e9)).toBe('> 99 min');
    expect(shown(ANGLE, 36.87)).toBe('36.9°');
    expect(shown(SPIN, 0.0094)).toBe('0.009 rad/s');
    expect(shown(FINE_SPEED, 0.499)).toBe('0.50 m/s');
    expect(shown(TORQUE, 78_040)).toBe('78.0 kN m');
    expect(shown(TORQUE, 716_400)).toBe('716 kN m');
    expect(shown(MASS, 39.14)).toBe('39.1 kg');
    expect(shown(MASS, 7200)).toBe('7\u202f200 kg');
    expect(shown(COUNT, 2)).toBe('2');
    expect(shown(PERCENT, 0.424)).toBe('42 %');
    expect(shown(DELTA_V, 1540.4)).toBe('1\u202f540 m/s');
    expect(shown(DELTA_V, -3)).toBe('−3 m/s');
    expect([7.4, 47.5, 359.5].map((degrees) => shown(BEARING, degrees))).toEqual(['007°', '048°', '000°']);
    expect(shown(DURATION, 5999.4)).toBe('99 min 59 s');
    expect(shown(DURATION, 5999.5)).toBe('> 99 min');
  });

  it('print a dash for unknown values', () => {
    const lengths = [VERTICAL_SPEED, SPEED, DISTANCE, DURATION, FINE_SPEED, DELTA_V];
    for (const format of [...lengths, ANGLE, BEARING, SPIN, TORQUE, MASS, PERCENT, COUNT]) {
      expect(shown(format, NaN)).toBe('--');
    }
  });

  it('print the value to within half of the last digit', () => {
    const formats: readonly (readonly [Format, toUnit: number])[] = [
      [VERTICAL_SPEED, 1],
      [SPEED, 1],
      [ANGLE, 1],
      [SPIN, 1],
      [FINE_SPEED, 1],
      [TORQUE, 1000],
      [MASS, 1],
    ];
    fc.assert(
      fc.property(
        fc.constantFrom(...formats),
        fc.double({ min: 0, max: 2e5, noNaN: true }),
        (pair, value) => {
          const [format, toUnit] = pair;
          const digits = shown(format, value).replace(/[^0-9.]/g, '');
          const lastDigit = toUnit / 10 ** (digits.split('.')[1]?.length ?? 0);
          expect(Math.abs(Number(digits) * toUnit - value)).toBeLessThanOrEqual(lastDigit * 0.5001);
        },
      ),
    );
  });

  it('make no "−0.0" of a small negative value', () => {
    for (const format of [VERTICAL_SPEED, SPEED, DISTANCE, ANGLE, FINE_SPEED]) {
      expect(shown(format, -0.001)).not.toContain('−');
    }
  });

  it('have one key per printed text, so that nothing is painted twice', () => {
    expect(DISTANCE.key(49_860)).toBe(DISTANCE.key(49_940));
    expect(DISTANCE.key(432.6)).toBe(DISTANCE.key(433.4));
    expect(DURATION.key(124.6)).toBe(DURATION.key(125.4));
    expect(TORQUE.key(716_400)).toBe(TORQUE.key(715_600));
    // From where the digits become fewer.
    for (const format of [DISTANCE, DURATION, MASS]) expect(format.key(100.3)).toBe(format.key(99.95));
    expect(DISTANCE.key(10_040)).toBe(DISTANCE.key(9999.5));
    expect(TORQUE.key(100_400)).toBe(TORQUE.key(99_950));
  });

  it('have fewer digits from where the last would be the fourth', () => {
    expect([99.94, 99.95, 9999.4, 9999.5].map((metres) => shown(DISTANCE, metres))).toEqual([
      ...['99.9 m', '100 m', '9\u202f999 m', '10.0 km'],
    ]);
    expect([99.94, 99.95].map((seconds) => shown(DURATION, seconds))).toEqual(['99.9 s', '1 min 40 s']);
    expect([99.94, 99.95].map((kg) => shown(MASS, kg))).toEqual(['99.9 kg', '100 kg']);
    expect([99_940, 99_950].map((torque) => shown(TORQUE, torque))).toEqual(['99.9 kN m', '100 kN m']);
  });

  it('never show a gap in a rising value', () => {
    const gaps: string[] = [];
    let last = -1;
    for (let metres = 0; metres < 60_000; metres += 0.37) {
      const key = DISTANCE.key(metres);
      const halfOfLastDigit = metres < 100 ? 0.051 : metres < 10_000 ? 0.51 : 51;
      const isWithin = Math.abs(key / 10 - metres) <= halfOfLastDigit;
      if (key < last || !isWithin) gaps.push(`${metres} m after ${last}: ${key}`);
      last = key;
    }
    expect(gaps).toEqual([]);
  });
});
