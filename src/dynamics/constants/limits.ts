import type { Quat } from '../result';

/**
 * Ranges of all numbers in the dynamics: far beyond any ship, yet so far within the range of doubles that no square, product or
 * quotient of a substep overflows in any combination (DYNAMICS, Ranges).
 */
export interface Range {
  readonly least: number;
  /** `least` itself is out of range. */
  readonly isOpen?: boolean;
  readonly most: number;
  readonly unit: string;
}

/** From a gram to a small moon; the dynamics neglect the gravity of ships. */
export const SHIP_MASS: Range = { least: 1e-3, most: 1e15, unit: 'kg' };
export const FUEL_MASS: Range = { least: 0, most: SHIP_MASS.most, unit: 'kg' };
/** Fuel capacity above 0: from a milligram. */
export const TANKS: Range = { least: 1e-6, most: SHIP_MASS.most, unit: 'kg' };
/** A ship's lengths: up to 1,000 km. */
export const SHIP_LENGTH: Range = { least: 0, most: 1e6, unit: 'm' };
/** A length used as a divisor: from a millimetre. */
export const LEVER: Range = { least: 1e-3, most: SHIP_LENGTH.most, unit: 'm' };
/** Diagonal of the inertia tensor: from a gram at a millimetre to the largest mass at the largest distance. */
export const INERTIA: Range = { least: 1e-9, most: 1e27, unit: 'kg m²' };
export const FORCE: Range = { least: 0, most: 1e15, unit: 'N' };
export const TORQUE: Range = { least: 0, most: 1e15, unit: 'N m' };
/** ω_n of the attitude controller: its damping is stable at the longest substep up to this. */
export const NATURAL_FREQUENCY: Range = { least: 0, isOpen: true, most: 5, unit: 'rad/s' };
/** Dry inertia divided by full inertia. The minimum, far below any ship's, keeps quotients finite. */
export const INERTIA_RATIO: Range = { least: 1e-6, most: 1, unit: '' };
/** Capacity of reaction wheels. */
export const WHEEL_CAPACITY: Range = { least: 0, most: 1e15, unit: 'N m s' };
/** Momentum of reaction wheels, including wheels without a capacity. */
export const WHEEL_MOMENTUM_RANGE: Range = { least: -1e25, most: 1e25, unit: 'N m s' };
/** Up to the speed of light over standard gravity, rounded up. */
export const ISP: Range = { least: 1e-3, most: 1e8, unit: 's' };

/** Up to a billion suns. */
export const BODY_MASS: Range = { least: 0, isOpen: true, most: 1e40, unit: 'kg' };
/** From a pebble to 100 light years, like PLACE. */
export const BODY_RADIUS: Range = { least: 1e-3, most: 1e18, unit: 'm' };
/** Each component, of ships and bodies. */
export const PLACE: Range = { least: -1e18, most: 1e18, unit: 'm' };
/** Each component: three times the speed of light. */
export const VELOCITY_RANGE: Range = { least: -1e9, most: 1e9, unit: 'm/s' };
/** Each component. */
export const SPIN: Range = { least: -1e6, most: 1e6, unit: 'rad/s' };
export const SPEED: Range = { least: 0, most: VELOCITY_RANGE.most, unit: 'm/s' };
export const SPIN_SPEED: Range = { least: 0, most: SPIN.most, unit: 'rad/s' };

/** Largest deviation of an attitude's length from 1; servers send rounded quaternions. */
const UNIT_WITHIN = 1e-3;

/** Why a finite number is out of a range, or null. */
export function outside(field: string, value: number, range: Range): string | null {
  const { least, most, isOpen = false } = range;
  if (value > most) return `${field}: expected ≤ ${most}${inUnit(range)}, got ${value}`;
  if (value > least || (value === least && !isOpen)) return null;
  return `${field}: expected ${isOpen ? '>' : '≥'} ${least}${inUnit(range)}, got ${value}`;
}

function inUnit({ unit }: Range): string {
  return unit === '' ? '' : ` ${unit}`;
}

/** Why one of several finite numbers is out of a range, or null. */
export function anyOutside(field: string, values: readonly number[], range: Range): string | null {
  const { least, most } = range;
  for (let i = 0; i < values.length; i++) {
    // Checked here first, since a double passed to `outside` would be boxed.
    if (values[i]! > least && values[i]! <= most) continue;
    const reason = outside(`${field}[${i}]`, values[i]!, range);
    if (reason !== null) return reason;
  }
  return null;
}

/** Why four finite numbers are not an attitude, or null. */
export function notUnit(field: string, attitude: Quat): string | null {
  const x = attitude[0];
  const y = attitude[1];
  const z = attitude[2];
  const w = attitude[3];
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  if (Math.abs(length - 1) <= UNIT_WITHIN) return null;
  return `${field}: expected length 1 within ${UNIT_WITHIN}, got ${length}`;
}
