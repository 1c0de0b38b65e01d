import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  ATTITUDE_MODE,
  FLYING,
  FUEL,
  MODE_ANTINORMAL,
  MODE_ANTIRADIAL,
  MODE_HOLD,
  MODE_NONE,
  MODE_PROGRADE,
  MODE_RADIAL,
  MODE_RETROGRADE,
  MODE_SURFACE_RETROGRADE,
  MODE_UNKNOWN,
  POSITION,
  ROTATION_INPUT,
  SURFACE_STATE,
  TARGET_ATTITUDE,
  VELOCITY,
} from '../state/layout';
import {
  ANGULAR_ACCEL_COMMAND,
  AXES,
  AXIS,
  DISTANCE,
  GROUND_SPIN,
  INERTIA_FACTOR,
  NORMAL,
  quantities,
  step,
  TORQUE,
} from '../contact/quantities';
import {
  ATTITUDE_DAMPING,
  ATTITUDE_STIFFNESS,
  INERTIA_TENSOR,
  RCS_TORQUE,
  WHEEL_TORQUE,
} from '../constants/constantRows';

/** Fills TORQUE with the torque commanded by the stick, else by the attitude controller, N m, body axes (DYNAMICS, Actuators). */
export function commandTorque(): void {
  if (holdsStick()) {
    commandByStick();
    return;
  }
  const mode = effectiveMode();
  dampRates();
  if (mode === MODE_HOLD) steerToTarget();
  else if (mode !== MODE_NONE) steerToDirection(mode);
  commandByController();
}

function holdsStick(): boolean {
  const { ships, at } = step;
  return (
    ships[at + ROTATION_INPUT] !== 0 ||
    ships[at + ROTATION_INPUT + 1] !== 0 ||
    ships[at + ROTATION_INPUT + 2] !== 0
  );
}

/** MODE_NONE, rate damping alone, for unknown modes, and for velocity modes on the ground, where the velocity has no direction to point at. */
function effectiveMode(): number {
  const { ships, at } = step;
  const mode = ships[at + ATTITUDE_MODE]!;
  if (mode === MODE_UNKNOWN) return MODE_NONE;
  const byVelocity = mode >= MODE_PROGRADE && mode <= MODE_ANTINORMAL;
  return byVelocity && ships[at + SURFACE_STATE] !== FLYING ? MODE_NONE : mode;
}

/** TORQUE = rotation_input × (wheel + RCS torque), RCS only while there is fuel. */
function commandByStick(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const hasFuel = ships[at + FUEL]! > 0;
  for (let k = 0; k < 3; k++) {
    const wheel = shipClass[WHEEL_TORQUE + k]!;
    q[TORQUE + k] = ships[at + ROTATION_INPUT + k]! * (hasFuel ? wheel + shipClass[RCS_TORQUE + k]! : wheel);
  }
}

/** a = −2 ω_n w_b */
function dampRates(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const damping = -shipClass[ATTITUDE_DAMPING]!;
  const wx = ships[at + ANGULAR_VELOCITY]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]!;
  q[ANGULAR_ACCEL_COMMAND] = damping * (q[AXES]! * wx + q[AXES + 3]! * wy + q[AXES + 6]! * wz);
  q[ANGULAR_ACCEL_COMMAND + 1] = damping * (q[AXES + 1]! * wx + q[AXES + 4]! * wy + q[AXES + 7]! * wz);
  q[ANGULAR_ACCEL_COMMAND + 2] = damping * (q[AXES + 2]! * wx + q[AXES + 5]! * wy + q[AXES + 8]! * wz);
}

/** a += ω_n² e, where e is ±2 × the vector part of target · q⁻¹, rotated into body axes. */
function steerToTarget(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const stiffness = shipClass[ATTITUDE_STIFFNESS]!;
  const qx = ships[at + ATTITUDE]!;
  const qy = ships[at + ATTITUDE + 1]!;
  const qz = ships[at + ATTITUDE + 2]!;
  const qw = ships[at + ATTITUDE + 3]!;
  const tx = ships[at + TARGET_ATTITUDE]!;
  const ty = ships[at + TARGET_ATTITUDE + 1]!;
  const tz = ships[at + TARGET_ATTITUDE + 2]!;
  const tw = ships[at + TARGET_ATTITUDE + 3]!;
  const sign = tw * qw + tx * qx + ty * qy + tz * qz >= 0 ? 2 : -2;
  const ex = sign * (tx * qw - tw * qx - ty * qz + tz * qy);
  const ey = sign * (ty * qw - tw * qy - tz * qx + tx * qz);
  const ez = sign * (tz * qw - tw * qz - tx * qy + ty * qx);
  q[ANGULAR_ACCEL_COMMAND] =
    q[ANGULAR_ACCEL_COMMAND]! + stiffness * (q[AXES]! * ex + q[AXES + 3]! * ey + q[AXES + 6]! * ez);
  q[ANGULAR_ACCEL_COMMAND + 1] =
    q[ANGULAR_ACCEL_COMMAND + 1]! + stiffness * (q[AXES + 1]! * ex + q[AXES + 4]! * ey + q[AXES + 7]! * ez);
  q[ANGULAR_ACCEL_COMMAND + 2] =
    q[ANGULAR_ACCEL_COMMAND + 2]! + stiffness * (q[AXES + 2]! * ex + q[AXES + 5]! * ey + q[AXES + 8]! * ez);
}

/** ‖up × d‖ up to which a ship points directly away from d and any axis is equally good. */
const STRAIGHT_AWAY = 1e-6;

/** a += ω_n² e, e = up × d; in body axes up is z, so e = (−d_y, d_x, 0). */
function steerToDirection(mode: number): void {
  const q = quantities;
  if (!pointingDirection(mode)) return;
  const px = q[AXIS]!;
  const py = q[AXIS + 1]!;
  const pz = q[AXIS + 2]!;
  const dx = q[AXES]! * px + q[AXES + 3]! * py + q[AXES + 6]! * pz;
  const dy = q[AXES + 1]! * px + q[AXES + 4]! * py + q[AXES + 7]! * pz;
  const dz = q[AXES + 2]! * px + q[AXES + 5]! * py + q[AXES + 8]! * pz;
  let ex = -dy;
  let ey = dx;
  if (dz < 0) {
    // The error is 1 beyond 90°, so that control does not stall when the ship points directly away; about x there.
    const length = Math.sqrt(ex * ex + ey * ey);
    const straightAway = length <= STRAIGHT_AWAY;
    ex = straightAway ? 1 : ex / length;
    ey = straightAway ? 0 : ey / length;
  }
  const stiffness = step.shipClass[ATTITUDE_STIFFNESS]!;
  q[ANGULAR_ACCEL_COMMAND] = q[ANGULAR_ACCEL_COMMAND]! + stiffness * ex;
  q[ANGULAR_ACCEL_COMMAND + 1] = q[ANGULAR_ACCEL_COMMAND + 1]! + stiffness * ey;
}

/** Speed below which the direction of the velocity is rounding error, m/s. */
const MIN_SPEED = 1e-3;
/** ‖r × u‖ / (‖r‖ ‖u‖) below which the direction of r × u is rounding error. */
const MIN_SINE = 1e-6;
/** Ground speed below which the game keeps its last direction, m/s. Here rates are damped, which needs no memory and stays close to it. */
const MIN_SURFACE_SPEED = 0.1;

/** AXIS = unit direction that a pointing mode points at, ICRF; false if it would be rounding error. */
function pointingDirection(mode: number): boolean {
  const q = quantities;
  const { ships, at } = step;
  if (mode === MODE_RADIAL || mode === MODE_ANTIRADIAL) {
    const sign = mode === MODE_RADIAL ? 1 : -1;
    for (let k = 0; k < 3; k++) q[AXIS + k] = sign * q[NORMAL + k]!;
    return true;
  }
  const ux = ships[at + VELOCITY]!;
  const uy = ships[at + VELOCITY + 1]!;
  const uz = ships[at + VELOCITY + 2]!;
  if (mode === MODE_SURFACE_RETROGRADE) return pointAgainstGroundSpeed();
  const speed = Math.sqrt(ux * ux + uy * uy + uz * uz);
  if (speed < MIN_SPEED) return false;
  const reversed = mode === MODE_RETROGRADE || mode === MODE_ANTINORMAL;
  if (mode === MODE_PROGRADE || mode === MODE_RETROGRADE) {
    pointAlong(ux, uy, uz, reversed ? -1 / speed : 1 / speed);
    return true;
  }
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const x = ry * uz - rz * uy;
  const y = rz * ux - rx * uz;
  const z = rx * uy - ry * ux;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length < MIN_SINE * q[DISTANCE]! * speed) return false;
  pointAlong(x, y, z, reversed ? -1 / length : 1 / length);
  return true;
}

/** AXIS = unit(−v_rel), v_rel = u − Ω × r. */
function pointAgainstGroundSpeed(): boolean {
  const q = quantities;
  const { ships, at } = step;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const x = ships[at + VELOCITY]! - (oy * rz - oz * ry);
  const y = ships[at + VELOCITY + 1]! - (oz * rx - ox * rz);
  const z = ships[at + VELOCITY + 2]! - (ox * ry - oy * rx);
  const speed = Math.sqrt(x * x + y * y + z * z);
  if (speed < MIN_SURFACE_SPEED) return false;
  pointAlong(x, y, z, -1 / speed);
  return true;
}

function pointAlong(x: number, y: number, z: number, scale: number): void {
  const q = quantities;
  q[AXIS] = x * scale;
  q[AXIS + 1] = y * scale;
  q[AXIS + 2] = z * scale;
}

/** TORQUE = I a. */
function commandByController(): void {
  const q = quantities;
  const { shipClass } = step;
  const factor = q[INERTIA_FACTOR]!;
  const ax = q[ANGULAR_ACCEL_COMMAND]!;
  const ay = q[ANGULAR_ACCEL_COMMAND + 1]!;
  const az = q[ANGULAR_ACCEL_COMMAND + 2]!;
  q[TORQUE] =
    factor *
    (shipClass[INERTIA_TENSOR]! * ax +
      shipClass[INERTIA_TENSOR + 1]! * ay +
      shipClass[INERTIA_TENSOR + 2]! * az);
  q[TORQUE + 1] =
    factor *
    (shipClass[INERTIA_TENSOR + 3]! * ax +
      shipClass[INERTIA_TENSOR + 4]! * ay +
      shipClass[INERTIA_TENSOR + 5]! * az);
  q[TORQUE + 2] =
    factor *
    (shipClass[INERTIA_TENSOR + 6]! * ax +
      shipClass[INERTIA_TENSOR + 7]! * ay +
      shipClass[INERTIA_TENSOR + 8]! * az);
}
