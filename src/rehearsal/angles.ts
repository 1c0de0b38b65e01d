import { polynomialCosine, polynomialSine, RADIANS_PER_DEGREE } from '../dynamics';

/**
 * Sine and cosine of an angle in degrees from + − × ÷ alone: Math.sin has other bits in other engines, and a scenario must begin
 * with the same bits everywhere. Within 1e-15 for |degrees| ≤ 3600.
 */
export function sineOfDegrees(degrees: number): number {
  const turned = degrees - 360 * Math.floor(degrees / 360);
  if (turned >= 180) return -sineOfDegrees(turned - 180);
  if (turned > 90) return sineOfDegrees(180 - turned);
  return turned <= 45
    ? polynomialSine(turned * RADIANS_PER_DEGREE)
    : polynomialCosine((90 - turned) * RADIANS_PER_DEGREE);
}

export function cosineOfDegrees(degrees: number): number {
  return sineOfDegrees(degrees + 90);
}
