import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  ATTITUDE_HOLD,
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
  INERTIA_FACTOR,
  NORMAL,
  GROUND_SPIN,
  quantities,
  start,
  type Step,
  TORQUE,
} from '../contact/quantities';
import {
  ATTITUDE_DAMPING,
  ATTITUDE_STIFFNESS,
  INERTIA_TENSOR,
  RCS_TORQUE,
  WHEEL_TORQUE,
} from '../constants/constantRows';

/** TORQUE: what stick or attitude controller asks for, N m, body axes; false where neither asks (DYNAMICS, Actuators). */
export function askTorque(step: Step): boolean {
  const q = quantities;
  if (holdsStick()) {
    askByStick(step);
    return true;
  }
  const mode = effectiveMode();
  // A mode that has nothing to point at on the ground, or is not known, damps rates.
  if (mode === MODE_NONE && q[ATTITUDE_HOLD] !== 1 && q[ATTITUDE_MODE] === MODE_NONE) return false;
  dampRates(step);
  if (mode === MODE_HOLD) steerToTarget(step);
  else if (mode !== MODE_NONE) steerToDirection(step, mode);
  askByCommand(step);
  return true;
}

function holdsStick(): boolean {
  const q = quantities;
  return q[ROTATION_INPUT] !== 0 || q[ROTATION_INPUT + 1] !== 0 || q[ROTATION_INPUT + 2] !== 0;
}

/** A ground-bound ship's velocity has no direction to point at: there the velocity modes are rate damping, as unknown ones are. */
function effectiveMode(): number {
  const q = quantities;
  const mode = q[ATTITUDE_MODE]!;
  if (mode === MODE_UNKNOWN) return MODE_NONE;
  const byVelocity = mode >= MODE_PROGRADE && mode <= MODE_ANTINORMAL;
  return byVelocity && q[SURFACE_STATE] !== FLYING ? MODE_NONE : mode;
}

/** TORQUE = rotation_input × (wheel + RCS torque), RCS only while there is fuel. */
function askByStick(step: Step): void {
  const q = quantities;
  const { shipClass } = step;
  const hasFuel = q[FUEL]! > 0;
  for (let k = 0; k < 3; k++) {
    const wheel = shipClass[WHEEL_TORQUE + k]!;
    q[TORQUE + k] = q[ROTATION_INPUT + k]! * (hasFuel ? wheel + shipClass[RCS_TORQUE + k]! : wheel);
  }
}

/** a = −2 ω_n w_b */
function dampRates(step: Step): void {
  const q = quantities;
  const damping = -step.shipClass[ATTITUDE_DAMPING]!;
  const wx = q[ANGULAR_VELOCITY]!;
  const wy = q[ANGULAR_VELOCITY + 1]!;
  const wz = q[ANGULAR_VELOCITY + 2]!;
  q[ANGULAR_ACCEL_COMMAND] = damping * (q[AXES]! * wx + q[AXES + 3]! * wy + q[AXES + 6]! * wz);
  q[ANGULAR_ACCEL_COMMAND + 1] = damping * (q[AXES + 1]! * wx + q[AXES + 4]! * wy + q[AXES + 7]! * wz);
  q[ANGULAR_ACCEL_COMMAND + 2] = damping * (q[AXES + 2]! * wx + q[AXES + 5]! * wy + q[AXES + 8]! * wz);
}

/** a += ω_n² e, e = ±2 × vector part of target · q⁻¹, turned into body axes. */
function steerToTarget(step: Step): void {
  const q = quantities;
  const stiffness = step.shipClass[ATTITUDE_STIFFNESS]!;
  const qx = q[ATTITUDE]!;
  const qy = q[ATTITUDE + 1]!;
  const qz = q[ATTITUDE + 2]!;
  const qw = q[ATTITUDE + 3]!;
  const tx = q[TARGET_ATTITUDE]!;
  const ty = q[TARGET_ATTITUDE + 1]!;
  const tz = q[TARGET_ATTITUDE + 2]!;
  const tw = q[TARGET_ATTITUDE + 3]!;
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

/** Below this ‖up × d‖ a ship points straight away from d, and no axis is better than another. */
const STRAIGHT_AWAY = 1e-6;

/** a += ω_n² e, e = up × d; in body axes up is z, so e = (−d_y, d_x, 0). */
function steerToDirection(step: Step, mode: number): void {
  const q = quantities;
  if (!pointingDirection(step, mode)) return;
  const px = q[AXIS]!;
  const py = q[AXIS + 1]!;
  const pz = q[AXIS + 2]!;
  const dx = q[AXES]! * px + q[AXES + 3]! * py + q[AXES + 6]! * pz;
  const dy = q[AXES + 1]! * px + q[AXES + 4]! * py + q[AXES + 7]! * pz;
  const dz = q[AXES + 2]! * px + q[AXES + 5]! * py + q[AXES + 8]! * pz;
  let ex = -dy;
  let ey = dx;
  if (dz < 0) {
    // It does not stall when it points straight away: a full unit of error, about x where no axis is better.
    const length = Math.sqrt(ex * ex + ey * ey);
    const straightAway = length <= STRAIGHT_AWAY;
    ex = straightAway ? 1 : ex / length;
    ey = straightAway ? 0 : ey / length;
  }
  const stiffness = step.shipClass[ATTITUDE_STIFFNESS]!;
  q[ANGULAR_ACCEL_COMMAND] = q[ANGULAR_ACCEL_COMMAND]! + stiffness * ex;
  q[ANGULAR_ACCEL_COMMAND + 1] = q[ANGULAR_ACCEL_COMMAND + 1]! + stiffness * ey;
}

/** A velocity below 1 mm/s is round-off, and so is its direction. */
const LEAST_SPEED = 1e-3;
/** So is r × u where u is along r to a part in a million. */
const LEAST_SINE = 1e-6;
/** Below 0.1 m/s over the ground the game keeps its last direction; damping stays near it without remembering. */
const LEAST_SURFACE_SPEED = 0.1;

/** AXIS = the unit direction a pointing mode points at, ICRF; false where it is round-off. */
function pointingDirection(step: Step, mode: number): boolean {
  const q = quantities;
  if (mode === MODE_RADIAL || mode === MODE_ANTIRADIAL) {
    const sign = mode === MODE_RADIAL ? 1 : -1;
    for (let k = 0; k < 3; k++) q[AXIS + k] = sign * start[NORMAL + k]!;
    return true;
  }
  const ux = q[VELOCITY]!;
  const uy = q[VELOCITY + 1]!;
  const uz = q[VELOCITY + 2]!;
  if (mode === MODE_SURFACE_RETROGRADE) return pointAgainstGroundSpeed();
  const speed = Math.sqrt(ux * ux + uy * uy + uz * uz);
  if (speed < LEAST_SPEED) return false;
  const reversed = mode === MODE_RETROGRADE || mode === MODE_ANTINORMAL;
  if (mode === MODE_PROGRADE || mode === MODE_RETROGRADE) {
    pointAlong(ux, uy, uz, reversed ? -1 / speed : 1 / speed);
    return true;
  }
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const x = ry * uz - rz * uy;
  const y = rz * ux - rx * uz;
  const z = rx * uy - ry * ux;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length < LEAST_SINE * start[DISTANCE]! * speed) return false;
  pointAlong(x, y, z, reversed ? -1 / length : 1 / length);
  return true;
}

/** AXIS = unit(−v_rel), v_rel = u − Ω × r. */
function pointAgainstGroundSpeed(): boolean {
  const q = quantities;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const x = q[VELOCITY]! - (oy * rz - oz * ry);
  const y = q[VELOCITY + 1]! - (oz * rx - ox * rz);
  const z = q[VELOCITY + 2]! - (ox * ry - oy * rx);
  const speed = Math.sqrt(x * x + y * y + z * z);
  if (speed < LEAST_SURFACE_SPEED) return false;
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
function askByCommand(step: Step): void {
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
