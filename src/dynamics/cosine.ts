/**
 * cos(degrees), 0 … 90°, from a polynomial of our own: Math.cos has other bits in other engines (DYNAMICS, Arithmetic).
 * Run once, when the configuration is loaded. Above 45° it is the sine of the complement, so the argument stays below π/4,
 * where the Taylor terms kept leave less than 1e-17.
 */
export function cosineOfDegrees(degrees: number): number {
  return degrees <= 45
    ? polynomialCosine(degrees * RADIANS_PER_DEGREE)
    : polynomialSine((90 - degrees) * RADIANS_PER_DEGREE);
}

/** To the last bit the same everywhere. */
export const RADIANS_PER_DEGREE = 3.141592653589793 / 180;

/** Taylor, for 0 ≤ x ≤ π/4: the first term left out is below 1e-17. */
export function polynomialCosine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / ((2 * k - 1) * (2 * k));
  return 1 - sum;
}

/** As polynomialCosine. */
export function polynomialSine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / (2 * k * (2 * k + 1));
  return x * (1 - sum);
}
