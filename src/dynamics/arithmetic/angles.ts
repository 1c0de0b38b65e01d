/**
 * Sine and cosine of an angle in degrees by + − × ÷ only, since the bits of Math.sin and Math.cos differ between engines (DYNAMICS,
 * Arithmetic). Used to convert angle settings to cosines when they are loaded, and for initial attitudes of scenarios. The error is
 * below 1e-15 for |degrees| ≤ 3600.
 */
export function cosineOfDegrees(degrees: number): number {
  const turned = degrees - 360 * Math.floor(degrees / 360);
  const folded = turned > 180 ? 360 - turned : turned;
  return folded > 90 ? -cosineOfQuarter(180 - folded) : cosineOfQuarter(folded);
}

/** Like cosineOfDegrees. Not the cosine of the complement, which would round a small angle. */
export function sineOfDegrees(degrees: number): number {
  const turned = degrees - 360 * Math.floor(degrees / 360);
  if (turned >= 180) return -sineOfDegrees(turned - 180);
  return sineOfQuarter(turned > 90 ? 180 - turned : turned);
}

/** π / 180, the same bits everywhere. */
const RADIANS_PER_DEGREE = 3.141592653589793 / 180;

/** For 0 … 90°. Above 45° the sine of the complement, so that the argument stays below π/4. */
function cosineOfQuarter(degrees: number): number {
  return degrees <= 45
    ? polynomialCosine(degrees * RADIANS_PER_DEGREE)
    : polynomialSine((90 - degrees) * RADIANS_PER_DEGREE);
}

/** Like cosineOfQuarter. */
function sineOfQuarter(degrees: number): number {
  return degrees <= 45
    ? polynomialSine(degrees * RADIANS_PER_DEGREE)
    : polynomialCosine((90 - degrees) * RADIANS_PER_DEGREE);
}

/** Taylor series for 0 ≤ x ≤ π/4; the first omitted term is below 1e-17. */
function polynomialCosine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / ((2 * k - 1) * (2 * k));
  return 1 - sum;
}

/** Like polynomialCosine. */
function polynomialSine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / (2 * k * (2 * k + 1));
  return x * (1 - sum);
}
