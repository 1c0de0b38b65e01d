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
import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_END_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
} from '../state/layout';
import { anyOutside, BODY_MASS, PLACE, BODY_RADIUS, notUnit, outside, SPIN, VELOCITY_RANGE } from './limits';
import { SMI_MASK } from '../state/smiMask';

/** Constants of a body. */
export interface Body {
  /** Unique in its world. */
  readonly name: string;
  /** kg */
  readonly mass: number;
  /** m */
  readonly radius: number;
}

/** Pose and motion of a body. */
export interface BodyMotion {
  /** m, ICRF. */
  readonly position: Vec3;
  /** m/s, ICRF. */
  readonly velocity: Vec3;
  /** Rotates body axes (Y pole, Z prime meridian, X 90° E) into ICRF. */
  readonly attitude: Quat;
  /** rad/s, ICRF axes. */
  readonly angularVelocity: Vec3;
}

export interface LoadedBody extends Body {
  /** G · mass, m³/s². */
  readonly gravityParameter: number;
}

/** m³ kg⁻¹ s⁻² */
export const GRAVITATIONAL_CONSTANT = 6.6743e-11;

/** The body with derived constants, or an error that names the invalid field. */
export function loadBody(given: Body): Result<LoadedBody> {
  if (typeof given.name !== 'string' || given.name === '') return err('name: expected a non-empty string');
  const reason =
    notFinite('mass', given.mass) ??
    notFinite('radius', given.radius) ??
    outside('mass', given.mass, BODY_MASS) ??
    outside('radius', given.radius, BODY_RADIUS);
  if (reason !== null) return err(`body ${given.name}: ${reason}`);
  const { name, mass, radius } = given;
  return ok(Object.freeze({ name, mass, radius, gravityParameter: GRAVITATIONAL_CONSTANT * mass }));
}

/** Writes a motion into a body's row. Returns null, or a reason that names the invalid field; then the row is unchanged. */
export function writeBodyMotion(rows: Float64Array, at: number, motion: BodyMotion): string | null {
  const reason =
    notFiniteTuple('position', motion.position, 3) ??
    notFiniteTuple('velocity', motion.velocity, 3) ??
    notFiniteTuple('attitude', motion.attitude, 4) ??
    notFiniteTuple('angularVelocity', motion.angularVelocity, 3) ??
    anyOutside('position', motion.position, PLACE) ??
    anyOutside('velocity', motion.velocity, VELOCITY_RANGE) ??
    notUnit('attitude', motion.attitude) ??
    anyOutside('angularVelocity', motion.angularVelocity, SPIN);
  if (reason !== null) return reason;
  setBodyMotion(rows, at, motion);
  return null;
}

/** The same for a motion that has been checked. */
export function setBodyMotion(rows: Float64Array, at: number, motion: BodyMotion): void {
  rows.set(motion.position, at + BODY_POSITION);
  rows.set(motion.velocity, at + BODY_VELOCITY);
  rows.set(motion.attitude, at + BODY_ATTITUDE);
  rows.set(motion.angularVelocity, at + BODY_ANGULAR_VELOCITY);
  rows.set(motion.attitude, at + BODY_END_ATTITUDE);
}

export function readBodyMotion(rows: Float64Array, at: number): BodyMotion {
  return {
    position: readVec3(rows, at + BODY_POSITION),
    velocity: readVec3(rows, at + BODY_VELOCITY),
    attitude: readQuat(rows, at + BODY_ATTITUDE),
    angularVelocity: readVec3(rows, at + BODY_ANGULAR_VELOCITY),
  };
}

/** Step 7, once per substep, before the ships: each body's attitude at the substep's end, normalize(q + ½ dt (Ω, 0) q). */
export function turnBodies(rows: Float64Array, count: number, dt: number): void {
  const half = 0.5 * dt;
  for (let i = 0; i < count; i++) {
    const at = (i * BODY_STRIDE) & SMI_MASK;
    const tx = rows[at + BODY_ANGULAR_VELOCITY]! * half;
    const ty = rows[at + BODY_ANGULAR_VELOCITY + 1]! * half;
    const tz = rows[at + BODY_ANGULAR_VELOCITY + 2]! * half;
    const qx = rows[at + BODY_ATTITUDE]!;
    const qy = rows[at + BODY_ATTITUDE + 1]!;
    const qz = rows[at + BODY_ATTITUDE + 2]!;
    const qw = rows[at + BODY_ATTITUDE + 3]!;
    const x = qx + (tx * qw + ty * qz - tz * qy);
    const y = qy + (ty * qw + tz * qx - tx * qz);
    const z = qz + (tz * qw + tx * qy - ty * qx);
    const w = qw - (tx * qx + ty * qy + tz * qz);
    const perLength = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
    rows[at + BODY_END_ATTITUDE] = x * perLength;
    rows[at + BODY_END_ATTITUDE + 1] = y * perLength;
    rows[at + BODY_END_ATTITUDE + 2] = z * perLength;
    rows[at + BODY_END_ATTITUDE + 3] = w * perLength;
  }
}

/** After the ships: makes the attitude at the substep's end the next one's start. */
export function settleBodies(rows: Float64Array, count: number): void {
  for (let i = 0; i < count; i++) {
    const at = (i * BODY_STRIDE) & SMI_MASK;
    // Unrolled, since a loop takes twice as long.
    rows[at + BODY_ATTITUDE] = rows[at + BODY_END_ATTITUDE]!;
    rows[at + BODY_ATTITUDE + 1] = rows[at + BODY_END_ATTITUDE + 1]!;
    rows[at + BODY_ATTITUDE + 2] = rows[at + BODY_END_ATTITUDE + 2]!;
    rows[at + BODY_ATTITUDE + 3] = rows[at + BODY_END_ATTITUDE + 3]!;
  }
}

/** Once per tick: moves each body by its velocity for `seconds` game seconds. */
export function moveBodies(rows: Float64Array, count: number, seconds: number): void {
  for (let i = 0; i < count; i++) {
    const at = i * BODY_STRIDE;
    for (let k = 0; k < 3; k++) {
      rows[at + BODY_POSITION + k] = rows[at + BODY_POSITION + k]! + rows[at + BODY_VELOCITY + k]! * seconds;
    }
  }
}
