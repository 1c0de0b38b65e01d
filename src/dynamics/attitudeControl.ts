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
  MODE_NORMAL,
  MODE_PROGRADE,
  MODE_RADIAL,
  MODE_RETROGRADE,
  POSITION,
  ROTATION_INPUT,
  SURFACE_STATE,
  TARGET_ATTITUDE,
  VELOCITY,
} from './layout';
import {
  AVAILABLE,
  AXES,
  AXIS,
  MASS_RATIO,
  NORMAL,
  quantity as q,
  RCS_TORQUE_SUM,
  START,
  type Step,
  TORQUE,
  WISH,
  INDEX,
} from './quantities';

/** The torque that stick or attitude control asks for, as far as wheels and RCS can give it (DYNAMICS, Actuators). */
export function controlAttitude(step: Step): void {
  const { ships } = step;
  const at = step.at & INDEX;
  const stickX = ships[at + ROTATION_INPUT]!;
  const stickY = ships[at + ROTATION_INPUT + 1]!;
  const stickZ = ships[at + ROTATION_INPUT + 2]!;
  const mode = groundedMode(ships, at);
  const damps = mode !== MODE_NONE || ships[at + ATTITUDE_HOLD] === 1 || ships[at + ATTITUDE_MODE] !== mode;
  if (stickX !== 0 || stickY !== 0 || stickZ !== 0) {
    readAvailable(step);
    for (let k = 0; k < 3; k++) q[TORQUE + k] = ships[at + ROTATION_INPUT + k]! * q[AVAILABLE + k]!;
  } else if (damps) {
    dampRates(ships, at);
    if (mode === MODE_HOLD) steerToTarget(ships, at);
    else if (mode !== MODE_NONE) steerToDirection(ships, at, mode);
    readAvailable(step);
    wishToTorque(step);
  } else {
    return;
  }
  for (let k = 0; k < 3; k++) {
    const torque = q[TORQUE + k]!;
    const byRcs = (torque < 0 ? -torque : torque) - step.shipClass.reactionWheelTorque[k]!;
    if (byRcs > 0) q[RCS_TORQUE_SUM] = q[RCS_TORQUE_SUM]! + byRcs;
  }
}

/** A ground-bound ship's velocity has no direction to point at: there the velocity modes are rate damping. */
function groundedMode(ships: Float64Array, at: number): number {
  const mode = ships[at + ATTITUDE_MODE]!;
  const byVelocity = mode >= MODE_PROGRADE && mode <= MODE_ANTINORMAL;
  return byVelocity && ships[at + SURFACE_STATE] !== FLYING ? MODE_NONE : mode;
}

/** AVAILABLE: wheels, and RCS only while there is fuel. */
function readAvailable(step: Step): void {
  const hasFuel = step.ships[step.at + FUEL]! > 0;
  for (let k = 0; k < 3; k++) {
    const wheel = step.shipClass.reactionWheelTorque[k]!;
    q[AVAILABLE + k] = hasFuel ? wheel + step.shipClass.rcsTorque[k]! : wheel;
  }
}

/** a = −4 w_b */
function dampRates(ships: Float64Array, at: number): void {
  const wx = ships[at + ANGULAR_VELOCITY]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]!;
  q[WISH] = -4 * (q[AXES]! * wx + q[AXES + 3]! * wy + q[AXES + 6]! * wz);
  q[WISH + 1] = -4 * (q[AXES + 1]! * wx + q[AXES + 4]! * wy + q[AXES + 7]! * wz);
  q[WISH + 2] = -4 * (q[AXES + 2]! * wx + q[AXES + 5]! * wy + q[AXES + 8]! * wz);
}

/** a += 4 e, e = ±2 × vector part of target · q⁻¹, turned into body axes. */
function steerToTarget(ships: Float64Array, at: number): void {
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
  q[WISH] = q[WISH]! + 4 * (q[AXES]! * ex + q[AXES + 3]! * ey + q[AXES + 6]! * ez);
  q[WISH + 1] = q[WISH + 1]! + 4 * (q[AXES + 1]! * ex + q[AXES + 4]! * ey + q[AXES + 7]! * ez);
  q[WISH + 2] = q[WISH + 2]! + 4 * (q[AXES + 2]! * ex + q[AXES + 5]! * ey + q[AXES + 8]! * ez);
}

/** a += 4 e, e = up × d; in body axes up is z, so e = (−d_y, d_x, 0). */
function steerToDirection(ships: Float64Array, at: number, mode: number): void {
  if (!pointingDirection(ships, at, mode)) return;
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
    const straightAway = length <= 1e-6;
    ex = straightAway ? 1 : ex / length;
    ey = straightAway ? 0 : ey / length;
  }
  q[WISH] = q[WISH]! + 4 * ex;
  q[WISH + 1] = q[WISH + 1]! + 4 * ey;
}

/** AXIS = the unit direction a pointing mode points at, ICRF; false where it has none (a zero vector). */
function pointingDirection(ships: Float64Array, at: number, mode: number): boolean {
  let x = ships[at + VELOCITY]!;
  let y = ships[at + VELOCITY + 1]!;
  let z = ships[at + VELOCITY + 2]!;
  if (mode === MODE_NORMAL || mode === MODE_ANTINORMAL) {
    const rx = ships[at + POSITION]!;
    const ry = ships[at + POSITION + 1]!;
    const rz = ships[at + POSITION + 2]!;
    const ux = x;
    const uy = y;
    const uz = z;
    x = ry * uz - rz * uy;
    y = rz * ux - rx * uz;
    z = rx * uy - ry * ux;
  } else if (mode === MODE_RADIAL || mode === MODE_ANTIRADIAL) {
    x = q[START + NORMAL]!;
    y = q[START + NORMAL + 1]!;
    z = q[START + NORMAL + 2]!;
  }
  const length = Math.sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return false;
  const reversed = mode === MODE_RETROGRADE || mode === MODE_ANTINORMAL || mode === MODE_ANTIRADIAL;
  const perLength = reversed ? -1 / length : 1 / length;
  q[AXIS] = x * perLength;
  q[AXIS + 1] = y * perLength;
  q[AXIS + 2] = z * perLength;
  return true;
}

/** torque = I a, each axis clamped to what is available. */
function wishToTorque(step: Step): void {
  const inertia = step.shipClass.inertia;
  const ratio = q[MASS_RATIO]!;
  for (let k = 0; k < 3; k++) {
    const asked =
      ratio *
      (inertia[3 * k]! * q[WISH]! + inertia[3 * k + 1]! * q[WISH + 1]! + inertia[3 * k + 2]! * q[WISH + 2]!);
    const most = q[AVAILABLE + k]!;
    q[TORQUE + k] = asked > most ? most : asked < -most ? -most : asked;
  }
}
