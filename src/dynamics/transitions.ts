import { isNearlyAtRest, STIFFNESS } from './forces';
import {
  ANGULAR_VELOCITY,
  BODY_ANGULAR_VELOCITY,
  CONTACT,
  CRASHED,
  EVENT_CONTACT,
  EVENT_CRASHED,
  EVENT_LANDED,
  EVENT_RIGHTED,
  EVENT_TIPPED,
  FLYING,
  FUEL,
  IMPACT_SPEED,
  LANDED,
  NO_EVENT,
  SURFACE_STATE,
  TIPPED,
} from './layout';
import {
  AXES,
  COS_TILT,
  DEPTH,
  DT,
  END,
  FROM,
  GRAVITY,
  IMPACT,
  LIFT,
  NORMAL,
  PENETRATION,
  quantity as q,
  RADIAL_SPEED,
  START,
  type Step,
  TO,
  INDEX,
} from './quantities';
import { rotateAttitude, shortestRotation } from './rotations';
import { moveWithGround, readTilt, spinWithGround } from './surface';

/** Step 9: the first transition that applies to the state at the substep's end, at most one. Returns the event. */
export function makeTransition(step: Step): number {
  const { ships } = step;
  const at = step.at & INDEX;
  const state = ships[at + SURFACE_STATE]!;
  const touching = q[END + PENETRATION]! > 0;
  if (state === FLYING && !touching) return NO_EVENT;
  readImpact();
  if (touching && q[IMPACT]! > step.world.settings.contactCrashSpeed) return crash(step);
  if (state === FLYING) return q[IMPACT]! > 0 ? touch(step) : NO_EVENT;
  if (leavesGround()) {
    ships[at + SURFACE_STATE] = FLYING;
    ships[at + IMPACT_SPEED] = 0;
    return NO_EVENT;
  }
  readTilt();
  const cos = q[COS_TILT]!;
  if (state === TIPPED)
    return cos > step.world.settings.cosTippedAngle && isRighting(step) ? right(step) : NO_EVENT;
  if (!touching) return NO_EVENT;
  if (cos < step.world.settings.cosTippedAngle) return tip(step);
  return cos > step.world.settings.cosSettleTilt && isSettled(step) ? land(step) : NO_EVENT;
}

/**
 * IMPACT: speed at which ship and ground close, m/s. On level ground the two agree; where ground rises ahead of a fast ship
 * only the second sees it, and a ship that flies into a hill crashes instead of being flung out of it.
 */
function readImpact(): void {
  const falling = -q[END + RADIAL_SPEED]!;
  const closing = (q[END + PENETRATION]! - q[START + PENETRATION]!) / q[DT]!;
  q[IMPACT] = falling > closing ? falling : closing;
}

/** Let go of upward, or the ground fell away by 10 cm. */
function leavesGround(): boolean {
  const penetration = q[END + PENETRATION]!;
  return (penetration <= 0 && q[END + RADIAL_SPEED]! > 0) || penetration < -0.1;
}

function touch(step: Step): number {
  step.ships[step.at + SURFACE_STATE] = CONTACT;
  step.ships[step.at + IMPACT_SPEED] = q[IMPACT]!;
  if (step.world.settings.touchdownAttitude === 'aligned') alignWithSurface(step);
  return EVENT_CONTACT;
}

function alignWithSurface(step: Step): void {
  spinWithGround(step);
  q[FROM] = q[AXES + 2]!;
  q[FROM + 1] = q[AXES + 5]!;
  q[FROM + 2] = q[AXES + 8]!;
  q[TO] = q[END + NORMAL]!;
  q[TO + 1] = q[END + NORMAL + 1]!;
  q[TO + 2] = q[END + NORMAL + 2]!;
  shortestRotation();
  rotateAttitude(step.ships, step.at);
}

/** A result, not a state: the rest of the ship's state stays as it was, and it is out of the simulation. */
function crash(step: Step): number {
  const { ships } = step;
  const at = step.at & INDEX;
  ships[at + CRASHED] = 1;
  ships[at + SURFACE_STATE] = FLYING;
  return EVENT_CRASHED;
}

function tip(step: Step): number {
  step.ships[step.at + SURFACE_STATE] = TIPPED;
  return EVENT_TIPPED;
}

/** w_rel · (n × up) < 0: it turns back towards upright. */
function isRighting(step: Step): boolean {
  const { ships, bodies } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const nx = q[END + NORMAL]!;
  const ny = q[END + NORMAL + 1]!;
  const nz = q[END + NORMAL + 2]!;
  const wx = ships[at + ANGULAR_VELOCITY]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const x = ny * q[AXES + 8]! - nz * q[AXES + 5]!;
  const y = nz * q[AXES + 2]! - nx * q[AXES + 8]!;
  const z = nx * q[AXES + 5]! - ny * q[AXES + 2]!;
  return wx * x + wy * y + wz * z < 0;
}

function right(step: Step): number {
  step.ships[step.at + SURFACE_STATE] = CONTACT;
  step.ships[step.at + IMPACT_SPEED] = 0;
  return EVENT_RIGHTED;
}

/** Spin, vertical speed (the spring's energy counted in) and slide below the settle limits. */
function isSettled(step: Step): boolean {
  const { ships, bodies, shipClass } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const { contactSettleAngularVel } = step.world.settings;
  const wx = ships[at + ANGULAR_VELOCITY]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const wy = ships[at + ANGULAR_VELOCITY + 1]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const wz = ships[at + ANGULAR_VELOCITY + 2]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  if (!(wx * wx + wy * wy + wz * wz < contactSettleAngularVel * contactSettleAngularVel)) return false;
  const mass = shipClass.dryMass + ships[at + FUEL]!;
  const load = mass * q[END + GRAVITY]! - q[LIFT]!;
  q[DEPTH] = load > 0 ? load / (STIFFNESS * mass) : 0;
  return isNearlyAtRest(END, step);
}

function land(step: Step): number {
  step.ships[step.at + SURFACE_STATE] = LANDED;
  moveWithGround(step);
  spinWithGround(step);
  return EVENT_LANDED;
}
