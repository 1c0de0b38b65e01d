import {
  ok,
  type Result,
  notFinite,
  notFiniteTuple,
  type Quat,
  err,
  readQuat,
  readVec3,
  type Vec3,
} from '../result';
import { NEUTRAL_CONTROLS, writeControls } from './controls';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CRASHED,
  FLYING,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  POSITION,
  REFERENCE_BODY,
  SHIP_CLASS,
  SURFACE_STATE,
  SURFACE_STATES,
  type SurfaceState,
  VELOCITY,
  WHEEL_MOMENTUM,
} from './layout';
import {
  anyOutside,
  FUEL_MASS,
  notUnit,
  outside,
  PLACE,
  SHIP_LENGTH,
  SPEED,
  SPIN,
  VELOCITY_RANGE,
  WHEEL_MOMENTUM_RANGE,
} from '../constants/limits';
import type { World } from '../constants/world';

/** A ship's simulated state as a plain record; units and frames as in layout.ts. */
export interface ShipRecord {
  readonly shipClass: string;
  readonly referenceBody: string;
  /** Relative to the reference body, ICRF axes, m. */
  readonly relativePosition: Vec3;
  /** m/s */
  readonly relativeVelocity: Vec3;
  readonly attitude: Quat;
  /** rad/s, ICRF */
  readonly angularVelocity: Vec3;
  /** kg */
  readonly fuel: number;
  /** Momentum stored in the reaction wheels, N m s, body axes. */
  readonly wheelMomentum: Vec3;
  /** h: height of the centre of mass above the feet, m. */
  readonly groundContactOffset: number;
  readonly surfaceContactState: SurfaceState;
  /** m/s */
  readonly contactImpactSpeed: number;
  readonly crashed: boolean;
}

const AT_REST: Vec3 = [0, 0, 0];

/** A ship's initial state. By default wheelMomentum is 0, and groundContactOffset is the class's. */
export type ShipInit = Omit<ShipRecord, 'wheelMomentum' | 'groundContactOffset'> &
  Partial<Pick<ShipRecord, 'wheelMomentum' | 'groundContactOffset'>>;

/** Writes a ship's state (not its controls). Returns null, or a reason that names the invalid field; then the row is unchanged. */
export function writeShip(ships: Float64Array, at: number, ship: ShipInit, world: World): string | null {
  const checked = checkShip(ship, world);
  if (!checked.ok) return checked.reason;
  const { shipClass, referenceBody } = checked.value;
  ships.set(ship.relativePosition, at + POSITION);
  ships.set(ship.relativeVelocity, at + VELOCITY);
  ships.set(ship.attitude, at + ATTITUDE);
  ships.set(ship.angularVelocity, at + ANGULAR_VELOCITY);
  ships[at + FUEL] = ship.fuel;
  ships.set(ship.wheelMomentum ?? AT_REST, at + WHEEL_MOMENTUM);
  ships[at + GROUND_CONTACT_OFFSET] =
    ship.groundContactOffset ?? world.shipClasses[shipClass]!.groundContactOffset;
  ships[at + IMPACT_SPEED] = ship.contactImpactSpeed;
  ships[at + SURFACE_STATE] = SURFACE_STATES.indexOf(ship.surfaceContactState);
  ships[at + REFERENCE_BODY] = referenceBody;
  ships[at + CRASHED] = ship.crashed ? 1 : 0;
  ships[at + SHIP_CLASS] = shipClass;
  return null;
}

/** Like writeShip, with the controls of a spawn: all neutral. */
export function spawnShip(ships: Float64Array, at: number, ship: ShipInit, world: World): string | null {
  const reason = writeShip(ships, at, ship, world);
  if (reason === null) writeControls(ships, at, NEUTRAL_CONTROLS);
  return reason;
}

export function readShip(ships: Float64Array, at: number, world: World): ShipRecord {
  return {
    shipClass: world.shipClasses[ships[at + SHIP_CLASS]!]!.name,
    referenceBody: world.bodies[ships[at + REFERENCE_BODY]!]!.name,
    relativePosition: readVec3(ships, at + POSITION),
    relativeVelocity: readVec3(ships, at + VELOCITY),
    attitude: readQuat(ships, at + ATTITUDE),
    angularVelocity: readVec3(ships, at + ANGULAR_VELOCITY),
    fuel: ships[at + FUEL]!,
    wheelMomentum: readVec3(ships, at + WHEEL_MOMENTUM),
    groundContactOffset: ships[at + GROUND_CONTACT_OFFSET]!,
    surfaceContactState: SURFACE_STATES[ships[at + SURFACE_STATE]!]!,
    contactImpactSpeed: ships[at + IMPACT_SPEED]!,
    crashed: ships[at + CRASHED] === 1,
  };
}

/** The game's landed_body_name: empty in flight and once crashed. */
export function landedBodyName(ship: ShipRecord): string {
  return ship.surfaceContactState === SURFACE_STATES[FLYING] ? '' : ship.referenceBody;
}

function checkShip(ship: ShipInit, world: World): Result<{ shipClass: number; referenceBody: number }> {
  const malformed =
    notFiniteTuple('relativePosition', ship.relativePosition, 3) ??
    notFiniteTuple('relativeVelocity', ship.relativeVelocity, 3) ??
    notFiniteTuple('attitude', ship.attitude, 4) ??
    notFiniteTuple('angularVelocity', ship.angularVelocity, 3) ??
    notFinite('fuel', ship.fuel) ??
    (ship.wheelMomentum === undefined ? null : notFiniteTuple('wheelMomentum', ship.wheelMomentum, 3)) ??
    (ship.groundContactOffset === undefined
      ? null
      : notFinite('groundContactOffset', ship.groundContactOffset)) ??
    notFinite('contactImpactSpeed', ship.contactImpactSpeed);
  if (malformed !== null) return err(malformed);
  if (typeof ship.crashed !== 'boolean') return err('crashed: expected true or false');
  const shipClass = world.shipClasses.findIndex((c) => c.name === ship.shipClass);
  if (shipClass < 0) return err(`shipClass: no class named ${ship.shipClass}`);
  const referenceBody = world.bodies.findIndex((b) => b.name === ship.referenceBody);
  if (referenceBody < 0) return err(`referenceBody: no body named ${ship.referenceBody}`);
  if (!SURFACE_STATES.includes(ship.surfaceContactState)) return err('surfaceContactState: no such state');
  const [x, y, z] = ship.relativePosition;
  // Within a metre of the body's centre the radial direction and gravity are not usable.
  if (!(x * x + y * y + z * z >= 1)) return err('relativePosition: expected ≥ 1 m from the body’s centre');
  const outOfRange =
    anyOutside('relativePosition', ship.relativePosition, PLACE) ??
    anyOutside('relativeVelocity', ship.relativeVelocity, VELOCITY_RANGE) ??
    notUnit('attitude', ship.attitude) ??
    anyOutside('angularVelocity', ship.angularVelocity, SPIN) ??
    outside('fuel', ship.fuel, FUEL_MASS) ??
    anyOutside('wheelMomentum', ship.wheelMomentum ?? AT_REST, WHEEL_MOMENTUM_RANGE) ??
    outside('groundContactOffset', ship.groundContactOffset ?? 0, SHIP_LENGTH) ??
    outside('contactImpactSpeed', ship.contactImpactSpeed, SPEED);
  if (outOfRange !== null) return err(outOfRange);
  return ok({ shipClass, referenceBody });
}
