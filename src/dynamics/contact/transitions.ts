import { CONTACT_STIFFNESS } from './forces';
import {
  ANGULAR_VELOCITY,
  CONTACT,
  CRASHED,
  EVENT_CONTACT,
  EVENT_DESTROYED,
  EVENT_LANDED,
  EVENT_RIGHTED,
  EVENT_TIPPED,
  FLYING,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  LANDED,
  NO_EVENT,
  POSITION,
  SURFACE_STATE,
  TIPPED,
  VELOCITY,
} from '../state/layout';
import { moveWithGround, spinWithGround } from './pose';
import {
  AXES,
  COS_SLOPE,
  DISTANCE_SQUARED,
  DT,
  FROM,
  GRAVITY_PARAMETER,
  GROUND_SPIN,
  MASS,
  NORMAL,
  NORMAL_SPEED,
  PENETRATION,
  quantities,
  SLOPE,
  SMI_MASK,
  START_PENETRATION,
  step,
  SURFACE_NORMAL,
  THRUST,
  TO,
} from './quantities';
import { rotateAttitude, shortestRotation } from '../arithmetic/rotations';
import {
  COS_SETTLE_TILT,
  COS_TIPPED_ANGLE,
  CRASH_SPEED,
  FRICTION_STATIC,
  IS_ALIGNED,
  LEG_RADIUS,
  SETTLE_ANGULAR_VEL,
  SETTLE_LINEAR_VEL,
} from '../constants/constantRows';

/** Height of the feet above which a grounded ship has left the ground although it does not rise, m. */
const LET_GO_HEIGHT = 0.1;

/** Step 9: makes the first transition that applies at the substep's end, at most one. Returns its event. */
// eslint-disable-next-line max-lines-per-function -- Intermediate values stay in registers.
export function makeTransition(): number {
  const q = quantities;
  const { ships, settings } = step;
  const at = step.at & SMI_MASK;
  const state = ships[at + SURFACE_STATE]!;
  const penetration = q[PENETRATION]!;
  const touching = penetration > 0;
  const sx = q[SURFACE_NORMAL]!;
  const sy = q[SURFACE_NORMAL + 1]!;
  const sz = q[SURFACE_NORMAL + 2]!;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const vx = ships[at + VELOCITY]! - (oy * rz - oz * ry);
  const vy = ships[at + VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = ships[at + VELOCITY + 2]! - (ox * ry - oy * rx);
  const speed = vx * sx + vy * sy + vz * sz;

  // Closing speed of ship and ground: the larger of −v_s and the rate of penetration. They agree on level ground. Only the rate of
  // penetration includes ground that rises ahead of a fast ship, so that a ship that flies into a hill crashes.
  const closing = ((penetration - q[START_PENETRATION]!) * q[COS_SLOPE]!) / q[DT]!;
  const impact = -speed > closing ? -speed : closing;
  if (touching && impact > settings[CRASH_SPEED]!) {
    // An outcome, not a surface state: the rest of the ship's state is kept, and the ship is no longer simulated.
    ships[at + CRASHED] = 1;
    ships[at + SURFACE_STATE] = FLYING;
    return EVENT_DESTROYED;
  }
  if (state === FLYING) {
    if (!(impact > 0)) return NO_EVENT;
    ships[at + SURFACE_STATE] = CONTACT;
    ships[at + IMPACT_SPEED] = impact;
    if (settings[IS_ALIGNED] === 1) alignWithSurface();
    return EVENT_CONTACT;
  }
  // The ship rises off the ground, or the ground falls away under it.
  if ((penetration <= 0 && speed > 0) || penetration < -LET_GO_HEIGHT) {
    ships[at + SURFACE_STATE] = FLYING;
    ships[at + IMPACT_SPEED] = 0;
    return NO_EVENT;
  }
  const cos = sx * q[AXES + 2]! + sy * q[AXES + 5]! + sz * q[AXES + 8]!;
  if (state === TIPPED) {
    if (!(cos > settings[COS_TIPPED_ANGLE]!) || !isRighting()) return NO_EVENT;
    ships[at + SURFACE_STATE] = CONTACT;
    ships[at + IMPACT_SPEED] = 0;
    return EVENT_RIGHTED;
  }
  if (!touching) return NO_EVENT;
  if (cos < settings[COS_TIPPED_ANGLE]!) {
    ships[at + SURFACE_STATE] = TIPPED;
    return EVENT_TIPPED;
  }
  if (!(cos > settings[COS_SETTLE_TILT]!)) return NO_EVENT;
  const tx = vx - speed * sx;
  const ty = vy - speed * sy;
  const tz = vz - speed * sz;
  const slideSquared = tx * tx + ty * ty + tz * tz;
  const maxSpeed = settings[SETTLE_LINEAR_VEL]!;
  if (!(slideSquared < maxSpeed * maxSpeed)) return NO_EVENT;
  q[NORMAL_SPEED] = speed;
  if (!isSettled()) return NO_EVENT;
  ships[at + SURFACE_STATE] = LANDED;
  moveWithGround();
  spinWithGround();
  return EVENT_LANDED;
}

function alignWithSurface(): void {
  const q = quantities;
  spinWithGround();
  q[FROM] = q[AXES + 2]!;
  q[FROM + 1] = q[AXES + 5]!;
  q[FROM + 2] = q[AXES + 8]!;
  q[TO] = q[SURFACE_NORMAL]!;
  q[TO + 1] = q[SURFACE_NORMAL + 1]!;
  q[TO + 2] = q[SURFACE_NORMAL + 2]!;
  shortestRotation();
  rotateAttitude();
}

/** w_rel · (s × up) < 0: the ship turns back towards upright. */
function isRighting(): boolean {
  const q = quantities;
  const { ships, at } = step;
  const sx = q[SURFACE_NORMAL]!;
  const sy = q[SURFACE_NORMAL + 1]!;
  const sz = q[SURFACE_NORMAL + 2]!;
  const wx = ships[at + ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  const x = sy * q[AXES + 8]! - sz * q[AXES + 5]!;
  const y = sz * q[AXES + 2]! - sx * q[AXES + 8]!;
  const z = sx * q[AXES + 5]! - sy * q[AXES + 2]!;
  return wx * x + wy * y + wz * z < 0;
}

/** Whether spin and normal speed are below the settle limits, and the ground holds the ship. */
function isSettled(): boolean {
  const q = quantities;
  const { ships, at } = step;
  const maxSpin = step.settings[SETTLE_ANGULAR_VEL]!;
  const maxSpeed = step.settings[SETTLE_LINEAR_VEL]!;
  const wx = ships[at + ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  if (!(wx * wx + wy * wy + wz * wz < maxSpin * maxSpin)) return false;
  const net =
    q[MASS]! * (q[GRAVITY_PARAMETER]! / q[DISTANCE_SQUARED]!) * q[COS_SLOPE]! -
    (q[THRUST]! * q[SURFACE_NORMAL]! +
      q[THRUST + 1]! * q[SURFACE_NORMAL + 1]! +
      q[THRUST + 2]! * q[SURFACE_NORMAL + 2]!);
  const depth = (net > 0 ? net : 0) / (CONTACT_STIFFNESS * q[MASS]!);
  // The spring's stored energy counts: √(v_s² + 100 (penetration c_s − depth)²).
  const sunk = q[PENETRATION]! * q[COS_SLOPE]! - depth;
  const vertical = q[NORMAL_SPEED]! * q[NORMAL_SPEED]! + CONTACT_STIFFNESS * (sunk * sunk);
  return vertical < maxSpeed * maxSpeed && isHeldByGround();
}

/** Whether static friction holds the ship on the slope, and its weight acts within its footprint. */
function isHeldByGround(): boolean {
  const q = quantities;
  const { ships, at } = step;
  const slope = Math.sqrt(
    q[SLOPE]! * q[SLOPE]! + q[SLOPE + 1]! * q[SLOPE + 1]! + q[SLOPE + 2]! * q[SLOPE + 2]!,
  );
  if (!(slope <= step.settings[FRICTION_STATIC]! * q[COS_SLOPE]!)) return false;
  const nx = q[NORMAL]!;
  const ny = q[NORMAL + 1]!;
  const nz = q[NORMAL + 2]!;
  const upX = q[AXES + 2]!;
  const upY = q[AXES + 5]!;
  const upZ = q[AXES + 8]!;
  const x = ny * upZ - nz * upY;
  const y = nz * upX - nx * upZ;
  const z = nx * upY - ny * upX;
  const offset = ships[at + GROUND_CONTACT_OFFSET]!;
  const level = nx * upX + ny * upY + nz * upZ;
  return offset * Math.sqrt(x * x + y * y + z * z) <= step.shipClass[LEG_RADIUS]! * level;
}
