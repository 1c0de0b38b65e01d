import { ok, type Result, notFinite, notFiniteTuple, type Quat, err, type Vec3 } from '../result';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_AXES,
  BODY_END_ATTITUDE,
  BODY_END_AXES,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_TURN,
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
  if (typeof given.name !== 'string' || given.name === '') return err('body name: expected a string');
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
  rows.set(motion.position, at + BODY_POSITION);
  rows.set(motion.velocity, at + BODY_VELOCITY);
  rows.set(motion.attitude, at + BODY_ATTITUDE);
  rows.set(motion.angularVelocity, at + BODY_ANGULAR_VELOCITY);
  rows.set(motion.attitude, at + BODY_END_ATTITUDE);
  writeAxes(rows, at + BODY_AXES, at + BODY_ATTITUDE);
  writeAxes(rows, at + BODY_END_AXES, at + BODY_ATTITUDE);
  return null;
}

export function readBodyMotion(rows: Float64Array, at: number): BodyMotion {
  const tuple = (from: number, length: number) => Array.from(rows.subarray(at + from, at + from + length));
  return {
    position: tuple(BODY_POSITION, 3) as unknown as Vec3,
    velocity: tuple(BODY_VELOCITY, 3) as unknown as Vec3,
    attitude: tuple(BODY_ATTITUDE, 4) as unknown as Quat,
    angularVelocity: tuple(BODY_ANGULAR_VELOCITY, 3) as unknown as Vec3,
  };
}

/**
 * Step 7, once per substep, before the ships: each body's attitude at the substep's end, normalize(q + ½ dt (Ω, 0) q), and the rotation
 * of ground-bound ships, normalize(Ω dt/2, 1).
 */
export function turnBodies(rows: Float64Array, count: number, dt: number): void {
  const half = 0.5 * dt;
  for (let i = 0; i < count; i++) {
    const at = (i * BODY_STRIDE) & SMI_MASK;
    const tx = rows[at + BODY_ANGULAR_VELOCITY]! * half;
    const ty = rows[at + BODY_ANGULAR_VELOCITY + 1]! * half;
    const tz = rows[at + BODY_ANGULAR_VELOCITY + 2]! * half;
    const perTurn = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz + 1);
    rows[at + BODY_TURN] = tx * perTurn;
    rows[at + BODY_TURN + 1] = ty * perTurn;
    rows[at + BODY_TURN + 2] = tz * perTurn;
    rows[at + BODY_TURN + 3] = perTurn;

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
    writeAxes(rows, at + BODY_END_AXES, at + BODY_END_ATTITUDE);
  }
}

/** After the ships: makes the attitude at the substep's end the next one's start. */
export function settleBodies(rows: Float64Array, count: number): void {
  for (let i = 0; i < count; i++) {
    const at = (i * BODY_STRIDE) & SMI_MASK;
    // Attitude and axes are adjacent columns. Unrolled, since a loop takes twice as long.
    rows[at + BODY_ATTITUDE] = rows[at + BODY_END_ATTITUDE]!;
    rows[at + BODY_ATTITUDE + 1] = rows[at + BODY_END_ATTITUDE + 1]!;
    rows[at + BODY_ATTITUDE + 2] = rows[at + BODY_END_ATTITUDE + 2]!;
    rows[at + BODY_ATTITUDE + 3] = rows[at + BODY_END_ATTITUDE + 3]!;
    rows[at + BODY_ATTITUDE + 4] = rows[at + BODY_END_ATTITUDE + 4]!;
    rows[at + BODY_ATTITUDE + 5] = rows[at + BODY_END_ATTITUDE + 5]!;
    rows[at + BODY_ATTITUDE + 6] = rows[at + BODY_END_ATTITUDE + 6]!;
    rows[at + BODY_ATTITUDE + 7] = rows[at + BODY_END_ATTITUDE + 7]!;
    rows[at + BODY_ATTITUDE + 8] = rows[at + BODY_END_ATTITUDE + 8]!;
    rows[at + BODY_ATTITUDE + 9] = rows[at + BODY_END_ATTITUDE + 9]!;
    rows[at + BODY_ATTITUDE + 10] = rows[at + BODY_END_ATTITUDE + 10]!;
    rows[at + BODY_ATTITUDE + 11] = rows[at + BODY_END_ATTITUDE + 11]!;
    rows[at + BODY_ATTITUDE + 12] = rows[at + BODY_END_ATTITUDE + 12]!;
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

/** Writes the rotation matrix, row by row, of the unit quaternion at `from`; both in `rows`. */
function writeAxes(rows: Float64Array, to: number, from: number): void {
  const x = rows[from]!;
  const y = rows[from + 1]!;
  const z = rows[from + 2]!;
  const w = rows[from + 3]!;
  const x2 = x + x;
  const y2 = y + y;
  const z2 = z + z;
  rows[to] = 1 - (y * y2 + z * z2);
  rows[to + 1] = x * y2 - w * z2;
  rows[to + 2] = x * z2 + w * y2;
  rows[to + 3] = x * y2 + w * z2;
  rows[to + 4] = 1 - (x * x2 + z * z2);
  rows[to + 5] = y * z2 - w * x2;
  rows[to + 6] = x * z2 - w * y2;
  rows[to + 7] = y * z2 + w * x2;
  rows[to + 8] = 1 - (x * x2 + y * y2);
}
