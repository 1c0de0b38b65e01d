import { isNearlyAtRest, readLoad } from './forces';
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
  SURFACE_STATE,
  TIPPED,
} from '../state/layout';
import { moveWithGround, readTilt, spinWithGround } from './pose';
import {
  AXES,
  COS_SLOPE,
  COS_TILT,
  DT,
  end,
  FROM,
  IMPACT,
  NORMAL,
  NORMAL_SPEED,
  PENETRATION,
  GROUND_SPIN,
  quantities,
  SLOPE,
  start,
  type Step,
  SURFACE_NORMAL,
  TANGENTIAL_SPEED_SQUARED,
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
export function makeTransition(step: Step): number {
  const q = quantities;
  const state = q[SURFACE_STATE]!;
  const touching = end[PENETRATION]! > 0;
  if (state === FLYING && !touching) return NO_EVENT;
  readImpact();
  if (touching && q[IMPACT]! > step.settings[CRASH_SPEED]!) return crash();
  if (state === FLYING) return q[IMPACT]! > 0 ? touch(step) : NO_EVENT;
  if (leavesGround()) {
    q[SURFACE_STATE] = FLYING;
    q[IMPACT_SPEED] = 0;
    return NO_EVENT;
  }
  readTilt();
  const cos = q[COS_TILT]!;
  if (state === TIPPED) return cos > step.settings[COS_TIPPED_ANGLE]! && isRighting() ? right() : NO_EVENT;
  if (!touching) return NO_EVENT;
  if (cos < step.settings[COS_TIPPED_ANGLE]!) return tip();
  return cos > step.settings[COS_SETTLE_TILT]! && isSettled(step) ? land() : NO_EVENT;
}

/**
 * IMPACT = closing speed of ship and ground, m/s: the larger of −v_s and the rate of penetration. They agree on level ground. Only the
 * rate of penetration includes ground that rises ahead of a fast ship, so that a ship that flies into a hill crashes.
 */
function readImpact(): void {
  const q = quantities;
  const falling = -end[NORMAL_SPEED]!;
  const closing = ((end[PENETRATION]! - start[PENETRATION]!) * end[COS_SLOPE]!) / q[DT]!;
  q[IMPACT] = falling > closing ? falling : closing;
}

/** Whether the ship rises off the ground, or the ground falls away under it. */
function leavesGround(): boolean {
  const penetration = end[PENETRATION]!;
  return (penetration <= 0 && end[NORMAL_SPEED]! > 0) || penetration < -LET_GO_HEIGHT;
}

function touch(step: Step): number {
  const q = quantities;
  q[SURFACE_STATE] = CONTACT;
  q[IMPACT_SPEED] = q[IMPACT]!;
  if (step.settings[IS_ALIGNED] === 1) alignWithSurface();
  return EVENT_CONTACT;
}

function alignWithSurface(): void {
  const q = quantities;
  spinWithGround();
  q[FROM] = q[AXES + 2]!;
  q[FROM + 1] = q[AXES + 5]!;
  q[FROM + 2] = q[AXES + 8]!;
  q[TO] = end[SURFACE_NORMAL]!;
  q[TO + 1] = end[SURFACE_NORMAL + 1]!;
  q[TO + 2] = end[SURFACE_NORMAL + 2]!;
  shortestRotation();
  rotateAttitude();
}

/** An outcome, not a surface state: the rest of the ship's state is kept, and the ship is no longer simulated. */
function crash(): number {
  const q = quantities;
  q[CRASHED] = 1;
  q[SURFACE_STATE] = FLYING;
  return EVENT_DESTROYED;
}

function tip(): number {
  const q = quantities;
  q[SURFACE_STATE] = TIPPED;
  return EVENT_TIPPED;
}

/** w_rel · (s × up) < 0: the ship turns back towards upright. */
function isRighting(): boolean {
  const q = quantities;
  const sx = end[SURFACE_NORMAL]!;
  const sy = end[SURFACE_NORMAL + 1]!;
  const sz = end[SURFACE_NORMAL + 2]!;
  const wx = q[ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const wy = q[ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const wz = q[ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  const x = sy * q[AXES + 8]! - sz * q[AXES + 5]!;
  const y = sz * q[AXES + 2]! - sx * q[AXES + 8]!;
  const z = sx * q[AXES + 5]! - sy * q[AXES + 2]!;
  return wx * x + wy * y + wz * z < 0;
}

function right(): number {
  const q = quantities;
  q[SURFACE_STATE] = CONTACT;
  q[IMPACT_SPEED] = 0;
  return EVENT_RIGHTED;
}

/** Whether spin, normal speed (spring energy included) and slide are below the settle limits, and the ground holds the ship. */
function isSettled(step: Step): boolean {
  const q = quantities;
  const mostSpin = step.settings[SETTLE_ANGULAR_VEL]!;
  const mostSpeed = step.settings[SETTLE_LINEAR_VEL]!;
  if (!(end[TANGENTIAL_SPEED_SQUARED]! < mostSpeed * mostSpeed)) return false;
  const wx = q[ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const wy = q[ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const wz = q[ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  if (!(wx * wx + wy * wy + wz * wz < mostSpin * mostSpin)) return false;
  readLoad(end);
  return isNearlyAtRest(end, step) && isHeldByGround(step);
}

/** Whether static friction holds the ship on the slope, and its weight acts within its footprint. */
function isHeldByGround(step: Step): boolean {
  const q = quantities;
  const slope = Math.sqrt(
    end[SLOPE]! * end[SLOPE]! + end[SLOPE + 1]! * end[SLOPE + 1]! + end[SLOPE + 2]! * end[SLOPE + 2]!,
  );
  if (!(slope <= step.settings[FRICTION_STATIC]! * end[COS_SLOPE]!)) return false;
  const nx = end[NORMAL]!;
  const ny = end[NORMAL + 1]!;
  const nz = end[NORMAL + 2]!;
  const upX = q[AXES + 2]!;
  const upY = q[AXES + 5]!;
  const upZ = q[AXES + 8]!;
  const x = ny * upZ - nz * upY;
  const y = nz * upX - nx * upZ;
  const z = nx * upY - ny * upX;
  const offset = q[GROUND_CONTACT_OFFSET]!;
  const level = nx * upX + ny * upY + nz * upZ;
  return offset * Math.sqrt(x * x + y * y + z * z) <= step.shipClass[LEG_RADIUS]! * level;
}

function land(): number {
  const q = quantities;
  q[SURFACE_STATE] = LANDED;
  moveWithGround();
  spinWithGround();
  return EVENT_LANDED;
}
