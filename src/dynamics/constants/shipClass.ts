import { ok, type Result, type Mat3, notFinite, notFiniteTuple, err, type Vec3 } from '../result';
import { inverse, largest, noTensor, scalarInertias } from './inertia';
import {
  anyOutside,
  FORCE,
  FUEL_MASS,
  INERTIA_RATIO,
  ISP,
  LEVER,
  NATURAL_FREQUENCY,
  outside,
  SHIP_LENGTH,
  SHIP_MASS,
  TANKS,
  TORQUE,
  WHEEL_CAPACITY,
} from './limits';

/** A ship class under the game's names. SI units, body axes: +Z is the thrust axis and "up". */
export interface ShipClass {
  readonly name: string;
  /** kg */
  readonly dryMass: number;
  /** kg */
  readonly fuelCapacity: number;
  /** kg m², body axes, with full tanks; symmetric, positive definite, not assumed diagonal. */
  readonly inertiaTensor: Mat3;
  /** h: height of the centre of mass above the feet, m, ≥ 0; a ship's state may carry its own. */
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
  /** Lever arm by which RCS torque becomes force, m. */
  readonly rcsLever: number;
  /** s */
  readonly rcsIsp: number;
  /** N m about body x, y, z; burns no fuel. */
  readonly reactionWheelTorque: Vec3;
  /** N m s about body x, y, z; null: the wheels are never full. */
  readonly reactionWheelCapacity: Vec3 | null;
  /** ω_n of the attitude controller, rad/s; it is critically damped. */
  readonly attitudeNaturalFrequency: number;
  /** Inertia with dry tanks divided by inertia with full tanks; null: proportional to mass. */
  readonly dryInertiaRatio: number | null;
}

/** A checked class and its constants, computed once. */
export interface LoadedShipClass extends ShipClass {
  /** kg: dry mass + fuel capacity. */
  readonly fullMass: number;
  /** kg m², row by row, with full tanks. @internal */
  readonly inertia: Float64Array;
  /** Its inverse, row by row. @internal */
  readonly inverseInertia: Float64Array;
  /** Factor on the tensor: inertiaAtDry + inertiaPerFuel · fuel. @internal */
  readonly inertiaAtDry: number;
  /** 1/kg @internal */
  readonly inertiaPerFuel: number;
  /** J: the least moment of inertia against tilting, with full tanks, kg m²; used for leg support. @internal */
  readonly supportInertia: number;
  /** J': a lower bound of the least moment of inertia, with full tanks, kg m²; used for foot scrub. @internal */
  readonly scrubInertia: number;
  /** ω_n², s⁻². @internal */
  readonly attitudeStiffness: number;
  /** 2 ω_n, s⁻¹. @internal */
  readonly attitudeDamping: number;
  /** N m s about body x, y, z; Infinity: never full. @internal */
  readonly wheelCapacity: Vec3;
  /** kg/s per newton of main engine thrust. */
  readonly mainEngineFlow: number;
  /** kg/s per newton of RCS force. @internal */
  readonly rcsFlow: number;
  /** RCS force per newton metre of torque, 1/m. @internal */
  readonly forcePerTorque: number;
  /** Values that a substep reads; columns in constantRows.ts. */
  readonly constants: Float64Array;
}

/** Standard gravity, m/s²: converts specific impulse in seconds to exhaust velocity. */
export const STANDARD_GRAVITY = 9.80665;

/** The class with derived constants, or an error that names the invalid field and its range. */
export function loadShipClass(given: ShipClass): Result<LoadedShipClass> {
  const reason = faultOfShipClass(given);
  return reason === null ? ok(deriveShipClass(given)) : err(reason);
}

/** The first invalid field of a class, and its range; null if there is none. */
export function faultOfShipClass(given: ShipClass): string | null {
  const reason = malformed(given) ?? outOfRange(given);
  return reason === null ? null : `ship class ${given.name}: ${reason}`;
}

/** A class known to be valid, with derived constants. */
export function deriveShipClass(given: ShipClass): LoadedShipClass {
  const fullMass = given.dryMass + given.fuelCapacity;
  const inertia = Float64Array.from(given.inertiaTensor.flat());
  const inverseInertia = inverse(inertia);
  const { attitudeNaturalFrequency } = given;
  const burnsMain = given.mainEngineThrust > 0;
  const turnsByRcs = largest(given.rcsTorque) > 0;
  const burnsRcs = turnsByRcs || largest(given.rcsThrust) > 0;
  const loaded = {
    ...given,
    fullMass,
    inertia,
    inverseInertia,
    ...inertiaByFuel(given, fullMass),
    ...scalarInertias(inverseInertia),
    attitudeStiffness: attitudeNaturalFrequency * attitudeNaturalFrequency,
    attitudeDamping: 2 * attitudeNaturalFrequency,
    wheelCapacity: given.reactionWheelCapacity ?? NEVER_FULL,
    mainEngineFlow: burnsMain ? 1 / (given.mainEngineIsp * STANDARD_GRAVITY) : 0,
    rcsFlow: burnsRcs ? 1 / (given.rcsIsp * STANDARD_GRAVITY) : 0,
    forcePerTorque: turnsByRcs ? 1 / given.rcsLever : 0,
  };
  return Object.freeze({ ...loaded, constants: constantsOf(loaded) });
}

/** Row of a class, in the order of constantRows.ts. */
function constantsOf(c: Omit<LoadedShipClass, 'constants'>): Float64Array {
  return Float64Array.of(
    ...[c.dryMass, c.legRadius, c.inertiaAtDry, c.inertiaPerFuel, c.supportInertia, c.scrubInertia],
    ...[c.attitudeStiffness, c.attitudeDamping],
    ...[c.mainEngineThrust, c.mainEngineFlow, c.rcsFlow, c.forcePerTorque],
    ...[...c.rcsThrust, ...c.rcsTorque, ...c.reactionWheelTorque, ...c.wheelCapacity],
    ...[...c.inertia, ...c.inverseInertia],
  );
}

const NEVER_FULL: Vec3 = [Infinity, Infinity, Infinity];

/** Inertia is linear in fuel: by dryInertiaRatio; without one, or without tanks, proportional to mass. */
function inertiaByFuel(
  { dryMass, fuelCapacity, dryInertiaRatio }: ShipClass,
  fullMass: number,
): Pick<LoadedShipClass, 'inertiaAtDry' | 'inertiaPerFuel'> {
  if (dryInertiaRatio === null || fuelCapacity === 0)
    return { inertiaAtDry: dryMass / fullMass, inertiaPerFuel: 1 / fullMass };
  return { inertiaAtDry: dryInertiaRatio, inertiaPerFuel: (1 - dryInertiaRatio) / fuelCapacity };
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
  'attitudeNaturalFrequency',
] as const;
const TRIPLES = ['rcsThrust', 'rcsTorque', 'reactionWheelTorque'] as const;

function malformed(c: ShipClass): string | null {
  if (typeof c.name !== 'string' || c.name === '') return 'name: expected a non-empty string';
  for (const field of SCALARS) {
    const reason = notFinite(field, c[field]);
    if (reason !== null) return reason;
  }
  for (const field of TRIPLES) {
    const reason = notFiniteTuple(field, c[field], 3);
    if (reason !== null) return reason;
  }
  if (c.dryInertiaRatio !== null) {
    const reason = notFinite('dryInertiaRatio', c.dryInertiaRatio);
    if (reason !== null) return reason;
  }
  if (c.reactionWheelCapacity !== null) {
    const reason = notFiniteTuple('reactionWheelCapacity', c.reactionWheelCapacity, 3);
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
  const turnsByRcs = largest(c.rcsTorque) > 0;
  const burnsRcs = turnsByRcs || largest(c.rcsThrust) > 0;
  return (
    outside('dryMass', c.dryMass, SHIP_MASS) ??
    outside('fuelCapacity', c.fuelCapacity, FUEL_MASS) ??
    outside('groundContactOffset', c.groundContactOffset, SHIP_LENGTH) ??
    (c.fuelCapacity !== 0 ? outside('fuelCapacity', c.fuelCapacity, TANKS) : null) ??
    outside('legRadius', c.legRadius, LEVER) ??
    outside('mainEngineThrust', c.mainEngineThrust, FORCE) ??
    anyOutside('rcsThrust', c.rcsThrust, FORCE) ??
    anyOutside('rcsTorque', c.rcsTorque, TORQUE) ??
    anyOutside('reactionWheelTorque', c.reactionWheelTorque, TORQUE) ??
    (c.reactionWheelCapacity === null
      ? null
      : anyOutside('reactionWheelCapacity', c.reactionWheelCapacity, WHEEL_CAPACITY)) ??
    outside('attitudeNaturalFrequency', c.attitudeNaturalFrequency, NATURAL_FREQUENCY) ??
    (c.dryInertiaRatio === null ? null : outside('dryInertiaRatio', c.dryInertiaRatio, INERTIA_RATIO)) ??
    // Checked only where they divide something.
    (c.mainEngineThrust > 0 ? outside('mainEngineIsp', c.mainEngineIsp, ISP) : null) ??
    (turnsByRcs ? outside('rcsLever', c.rcsLever, LEVER) : null) ??
    (burnsRcs ? outside('rcsIsp', c.rcsIsp, ISP) : null) ??
    noTensor(c.inertiaTensor)
  );
}
