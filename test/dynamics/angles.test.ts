import { describe, expect, it } from 'vitest';
import { cosineOfDegrees, sineOfDegrees } from '../../src/dynamics';

describe('polynomial sine and cosine', () => {
  it('agree with Math.sin and Math.cos within 1e-15, over three turns either way', () => {
    let worst = 0;
    for (let degrees = -1080; degrees <= 1080; degrees += 0.37) {
      const radians = (degrees / 180) * Math.PI;
      // Math.sin of the reduced angle, since degrees · π/180 has an error of an ulp of the unreduced angle.
      const reduced = radians - 2 * Math.PI * Math.floor(radians / (2 * Math.PI));
      worst = Math.max(
        worst,
        Math.abs(sineOfDegrees(degrees) - Math.sin(reduced)) / (1 + Math.abs(radians)),
        Math.abs(cosineOfDegrees(degrees) - Math.cos(reduced)) / (1 + Math.abs(radians)),
      );
    }
    expect(worst).toBeLessThan(1e-15);
  });

  it('are exact at multiples of a quarter turn', () => {
    expect([0, 90, 180, 270, 360].map(sineOfDegrees).map(Math.abs)).toEqual([0, 1, 0, 1, 0]);
    expect([0, 90, 180, 270, 360].map(cosineOfDegrees).map(Math.abs)).toEqual([1, 0, 1, 0, 1]);
    expect(cosineOfDegrees(180)).toBe(-1);
    expect(sineOfDegrees(30)).toBeCloseTo(0.5, 15);
    expect(sineOfDegrees(-30)).toBe(-sineOfDegrees(30));
  });
});
