import type { Mat3, Vec3 } from '../result';
import { INERTIA, outside } from './limits';

/** Inertia tensors: kg m², body axes, with full tanks. */

/** Largest asymmetry of a tensor divided by its mean moment; not 0, since recordings contain rounded values. */
const SYMMETRIC_WITHIN = 3e-9;

/** Minimum determinant of an inertia tensor divided by the cube of its mean moment: 1 for a ball, 3.4 / k for a rod of moments k, k, 1. */
const MIN_ROUNDNESS = 1e-6;

/** Maximum of J divided by J'. A larger ratio lets the legs' support spin a needle-shaped hull about its own axis. */
const MAX_SUPPORT = 4;

/** J and J' (DYNAMICS, Angular), from K = I⁻¹. */
export function scalarInertias(k: Float64Array): { supportInertia: number; scrubInertia: number } {
  const row = (i: number) => Math.abs(k[i]!) + Math.abs(k[i + 1]!) + Math.abs(k[i + 2]!);
  const scrubInertia = 1 / Math.max(row(0), row(3), row(6));
  const mean = (k[0]! + k[4]!) / 2;
  const half = (k[0]! - k[4]!) / 2;
  const tilting = 1 / (mean + Math.sqrt(half * half + k[1]! * k[1]!));
  return { supportInertia: Math.min(tilting, MAX_SUPPORT * scrubInertia), scrubInertia };
}

/**
 * Why a tensor is invalid, or null. Checks diagonal, symmetry, Sylvester's criterion, and that the moments differ by less than a factor
 * of about a million: otherwise the ground's impulse on a tipped hull (DYNAMICS, Tipped) accelerates its spin without bound. Moments
 * that no mass can have, one above the sum of the other two, are accepted, since the dynamics do not depend on them.
 */
export function noTensor([a, b, c]: Mat3): string | null {
  for (const [i, moment] of [a[0], b[1], c[2]].entries()) {
    const field = `inertiaTensor[${i}][${i}]`;
    if (!(moment > 0)) return `${field}: expected > 0, as a positive definite tensor has, got ${moment}`;
    const reason = outside(field, moment, INERTIA);
    if (reason !== null) return reason;
  }
  const mean = (a[0] + b[1] + c[2]) / 3;
  const skew = largest([a[1] - b[0], a[2] - c[0], b[2] - c[1]].map(Math.abs) as unknown as Vec3);
  if (!(skew <= SYMMETRIC_WITHIN * mean))
    return `inertiaTensor: expected a symmetric tensor, got elements that differ by ${skew} kg m²`;
  const minor = a[0] * b[1] - a[1] * b[0];
  const determinant =
    a[0] * (b[1] * c[2] - b[2] * c[1]) -
    a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
  if (!(minor > 0 && determinant > 0)) return 'inertiaTensor: expected a positive definite tensor';
  const roundness = determinant / (mean * mean * mean);
  if (roundness >= MIN_ROUNDNESS) return null;
  return `inertiaTensor: expected a determinant of at least ${MIN_ROUNDNESS} of its mean moment cubed, got ${roundness}`;
}

/** Adjugate over determinant, row by row. */
export function inverse(m: Float64Array): Float64Array {
  const [a, b, c, d, e, f, g, h, i] = m as unknown as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const ca = e * i - f * h;
  const cb = f * g - d * i;
  const cc = d * h - e * g;
  const determinant = a * ca + b * cb + c * cc;
  return Float64Array.of(
    ca / determinant,
    (c * h - b * i) / determinant,
    (b * f - c * e) / determinant,
    cb / determinant,
    (a * i - c * g) / determinant,
    (c * d - a * f) / determinant,
    cc / determinant,
    (b * g - a * h) / determinant,
    (a * e - b * d) / determinant,
  );
}

export function largest([x, y, z]: Vec3): number {
  return Math.max(x, y, z);
}
