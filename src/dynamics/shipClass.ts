import { accepted, type Checked, type Mat3, notFinite, notFiniteTuple, refused, type Vec3 } from './checked';

/** A ship class under the game's names. SI units, body axes: +Z is the thrust axis and "up". */
export interface ShipClass {
  readonly name: string;
  /** kg */
  readonly dryMass: number;
  /** kg */
  readonly fuelCapacity: number;
  /** kg m², body axes, at full mass; symmetric, positive definite, not assumed diagonal. */
  readonly inertiaTensor: Mat3;
  /** h: height of the centre of mass above the feet, m. */
  readonly groundContactOffset: number;
  /** Radius of the landing-leg footprint, m. */
  readonly legRadius: number;
  /** N */
  readonly mainEngineThrust: number;
  /** s */
  readonly mainEngineIsp: number;
  /** N along body x, y, z. */
  readonly rcsThrust: Vec3;
  /** N m about body x, y, z. */
  readonly rcsTorque: Vec3;
  /** Arm that turns RCS torque into force, m. */
  readonly rcsLever: number;
  /** s */
  readonly rcsIsp: number;
  /** N m about body x, y, z; burns no fuel. */
  readonly reactionWheelTorque: Vec3;
}

/** A checked class and its constants, computed once. */
export interface LoadedShipClass extends ShipClass {
  /** kg: dry mass + fuel capacity. */
  readonly fullMass: number;
  /** kg m², row by row, at full mass. */
  readonly inertia: Float64Array;
  /** Its inverse, row by row. */
  readonly inverseInertia: Float64Array;
  /** kg/s a newton of main engine thrust. */
  readonly mainEngineFlow: number;
  /** kg/s a newton of RCS force. */
  readonly rcsFlow: number;
  /** RCS force a newton metre of torque, 1/m. */
  readonly forcePerTorque: number;
}

/** Standard gravity, m/s²: turns a specific impulse in seconds into an exhaust velocity. */
export const STANDARD_GRAVITY = 9.80665;

/** The class with its constants, or a reason that names the field and its range. */
export function loadShipClass(given: ShipClass): Checked<LoadedShipClass> {
  const reason = malformed(given) ?? outOfRange(given);
  if (reason !== null) return refused(`ship class ${given.name}: ${reason}`);
  const fullMass = given.dryMass + given.fuelCapacity;
  const inertia = Float64Array.from(given.inertiaTensor.flat());
  const burnsMain = given.mainEngineThrust > 0;
  const turnsByRcs = largest(given.rcsTorque) > 0;
  const burnsRcs = turnsByRcs || largest(given.rcsThrust) > 0;
  return accepted(
    Object.freeze({
      ...given,
      fullMass,
      inertia,
      inverseInertia: inverse(inertia),
      mainEngineFlow: burnsMain ? 1 / (given.mainEngineIsp * STANDARD_GRAVITY) : 0,
      rcsFlow: burnsRcs ? 1 / (given.rcsIsp * STANDARD_GRAVITY) : 0,
      forcePerTorque: turnsByRcs ? 1 / given.rcsLever : 0,
    }),
  );
}

const SCALARS = [
  'dryMass',
  'fuelCapacity',
  'groundContactOffset',
  'legRadius',
  'mainEngineThrust',
  'mainEngineIsp',
  'rcsLever',
  'rcsIsp',
] as const;
const TRIPLES = ['rcsThrust', 'rcsTorque', 'reactionWheelTorque'] as const;

function malformed(c: ShipClass): string | null {
  if (typeof c.name !== 'string' || c.name === '') return 'name: expected a text';
  for (const field of SCALARS) {
    const reason = notFinite(field, c[field]);
    if (reason !== null) return reason;
  }
  for (const field of TRIPLES) {
    const reason = notFiniteTuple(field, c[field], 3);
    if (reason !== null) return reason;
  }
  const rows: readonly unknown[] = Array.isArray(c.inertiaTensor) ? c.inertiaTensor : [];
  if (rows.length !== 3) return 'inertiaTensor: expected 3 rows of 3 numbers';
  for (let row = 0; row < 3; row++) {
    const reason = notFiniteTuple(`inertiaTensor[${String(row)}]`, rows[row], 3);
    if (reason !== null) return reason;
  }
  return null;
}

function outOfRange(c: ShipClass): string | null {
  if (!(c.dryMass > 0)) return `dryMass: expected > 0 kg, got ${String(c.dryMass)}`;
  if (!(c.fuelCapacity >= 0)) return `fuelCapacity: expected ≥ 0 kg, got ${String(c.fuelCapacity)}`;
  if (!(c.groundContactOffset > 0))
    return `groundContactOffset: expected > 0 m, got ${String(c.groundContactOffset)}`;
  if (!(c.legRadius > 0)) return `legRadius: expected > 0 m, got ${String(c.legRadius)}`;
  if (!(c.mainEngineThrust >= 0))
    return `mainEngineThrust: expected ≥ 0 N, got ${String(c.mainEngineThrust)}`;
  for (const field of TRIPLES) {
    if (!(smallest(c[field]) >= 0)) return `${field}: expected ≥ 0, got ${c[field].join(', ')}`;
  }
  if (c.mainEngineThrust > 0 && !(c.mainEngineIsp > 0))
    return `mainEngineIsp: expected > 0 s, got ${String(c.mainEngineIsp)}`;
  const turnsByRcs = largest(c.rcsTorque) > 0;
  if (turnsByRcs && !(c.rcsLever > 0)) return `rcsLever: expected > 0 m, got ${String(c.rcsLever)}`;
  if ((turnsByRcs || largest(c.rcsThrust) > 0) && !(c.rcsIsp > 0))
    return `rcsIsp: expected > 0 s, got ${String(c.rcsIsp)}`;
  return notPositiveDefinite(c.inertiaTensor);
}

/** Sylvester's criterion, on a tensor that must be symmetric to a part in 10⁹ (recordings print rounded values). */
function notPositiveDefinite([a, b, c]: Mat3): string | null {
  const scale = 1e-9 * (a[0] + b[1] + c[2]);
  const skew = largest([a[1] - b[0], a[2] - c[0], b[2] - c[1]].map(Math.abs) as unknown as Vec3);
  if (!(skew <= scale)) return 'inertiaTensor: expected a symmetric tensor';
  const minor = a[0] * b[1] - a[1] * b[0];
  const determinant =
    a[0] * (b[1] * c[2] - b[2] * c[1]) -
    a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
  const definite = a[0] > 0 && minor > 0 && determinant > 1e-12 * a[0] * b[1] * c[2];
  return definite ? null : 'inertiaTensor: expected a positive definite tensor';
}

/** Adjugate over determinant, row by row. */
function inverse(m: Float64Array): Float64Array {
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

function largest([x, y, z]: Vec3): number {
  return Math.max(x, y, z);
}

function smallest([x, y, z]: Vec3): number {
  return Math.min(x, y, z);
}
