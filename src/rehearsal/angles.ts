/**
 * Sine and cosine of an angle in degrees from + − × ÷ alone: Math.sin has other bits in other engines, and a scenario must begin
 * with the same bits everywhere. Within 1e-15 for |degrees| ≤ 3600.
 */
export function sineOfDegrees(degrees: number): number {
  const turned = degrees - 360 * Math.floor(degrees / 360);
  if (turned >= 180) return -sineOfDegrees(turned - 180);
  if (turned > 90) return sineOfDegrees(180 - turned);
  return turned <= 45 ? sine(turned * RADIANS_PER_DEGREE) : cosine((90 - turned) * RADIANS_PER_DEGREE);
}

export function cosineOfDegrees(degrees: number): number {
  return sineOfDegrees(degrees + 90);
}

const RADIANS_PER_DEGREE = 3.141592653589793 / 180;

/** Taylor, for 0 ≤ x ≤ π/4: the first term left out is below 1e-17. */
function cosine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / ((2 * k - 1) * (2 * k));
  return 1 - sum;
}

function sine(x: number): number {
  const s = x * x;
  let sum = 0;
  for (let k = 9; k >= 1; k--) sum = ((1 - sum) * s) / (2 * k * (2 * k + 1));
  return x * (1 - sum);
}
