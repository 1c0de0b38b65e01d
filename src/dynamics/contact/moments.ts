import { ANGULAR_VELOCITY, GROUND_CONTACT_OFFSET, SURFACE_STATE, TIPPED } from '../state/layout';
import {
  AXES,
  COS_SLOPE,
  INERTIA_FACTOR,
  NORMAL,
  NORMAL_FORCE,
  GROUND_SPIN,
  quantities,
  start,
  type Step,
  SURFACE_NORMAL,
  TORQUE,
  WEIGHT,
} from './quantities';
import { FRICTION_KINETIC, LEG_RADIUS, SCRUB_INERTIA, SUPPORT_INERTIA } from '../constants/constantRows';

/** Per unit of inertia, s⁻² and s⁻¹: critically damped, like the contact spring. */
const SUPPORT_STIFFNESS = 100;
const SUPPORT_DAMPING = 20;
const SCRUB_DAMPING = 20;

/**
 * Step 6 for a penetrating ship: adds the moments of gravity about the feet, leg support and foot scrub to TORQUE. They are summed in
 * ICRF axes with scalar moments of inertia, then rotated into body axes once.
 */
export function addGroundMoments(step: Step): void {
  const q = quantities;
  const { settings, shipClass } = step;
  const factor = q[INERTIA_FACTOR]!;
  const upX = q[AXES + 2]!;
  const upY = q[AXES + 5]!;
  const upZ = q[AXES + 8]!;
  const nx = start[NORMAL]!;
  const ny = start[NORMAL + 1]!;
  const nz = start[NORMAL + 2]!;
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const rx = q[ANGULAR_VELOCITY]! - q[GROUND_SPIN]!;
  const ry = q[ANGULAR_VELOCITY + 1]! - q[GROUND_SPIN + 1]!;
  const rz = q[ANGULAR_VELOCITY + 2]! - q[GROUND_SPIN + 2]!;
  const yaw = rx * sx + ry * sy + rz * sz;
  const yawX = yaw * sx;
  const yawY = yaw * sy;
  const yawZ = yaw * sz;

  // Normal force, at most the weight's normal component; and the weight that it balances.
  const most = q[WEIGHT]! * start[COS_SLOPE]!;
  const held = q[NORMAL_FORCE]! < most ? q[NORMAL_FORCE]! : most;
  const carried = held / start[COS_SLOPE]!;
  const toppling = carried * q[GROUND_CONTACT_OFFSET]!;

  // Support: J (−100 (s × up) − 20 w_tilt), limited by the weight's lever arm at the footprint's edge.
  const support = shipClass[SUPPORT_INERTIA]! * factor;
  const stiffness = -SUPPORT_STIFFNESS * support;
  const damping = SUPPORT_DAMPING * support;
  let mx = stiffness * (sy * upZ - sz * upY) - damping * (rx - yawX);
  let my = stiffness * (sz * upX - sx * upZ) - damping * (ry - yawY);
  let mz = stiffness * (sx * upY - sy * upX) - damping * (rz - yawZ);
  const level = nx * upX + ny * upY + nz * upZ;
  const mostSupport = level > 0 ? carried * shipClass[LEG_RADIUS]! * level : 0;
  const supportSquared = mx * mx + my * my + mz * mz;
  if (supportSquared > mostSupport * mostSupport) {
    const share = mostSupport / Math.sqrt(supportSquared);
    mx *= share;
    my *= share;
    mz *= share;
  }

  // Scrub: −20 J' x, where x is the yaw rate about s plus, for a tipped hull, the roll rate about up.
  const roll = q[SURFACE_STATE] === TIPPED ? rx * upX + ry * upY + rz * upZ : 0;
  const scrubbing = -SCRUB_DAMPING * (shipClass[SCRUB_INERTIA]! * factor);
  let kx = scrubbing * (yawX + roll * upX);
  let ky = scrubbing * (yawY + roll * upY);
  let kz = scrubbing * (yawZ + roll * upZ);
  const mostScrub = settings[FRICTION_KINETIC]! * held * shipClass[LEG_RADIUS]!;
  const scrubSquared = kx * kx + ky * ky + kz * kz;
  if (scrubSquared > mostScrub * mostScrub) {
    const share = mostScrub / Math.sqrt(scrubSquared);
    kx *= share;
    ky *= share;
    kz *= share;
  }

  // Gravity about the feet: (held / c_s) h (n × up).
  mx = toppling * (ny * upZ - nz * upY) + mx + kx;
  my = toppling * (nz * upX - nx * upZ) + my + ky;
  mz = toppling * (nx * upY - ny * upX) + mz + kz;
  q[TORQUE] = q[TORQUE]! + (q[AXES]! * mx + q[AXES + 3]! * my + q[AXES + 6]! * mz);
  q[TORQUE + 1] = q[TORQUE + 1]! + (q[AXES + 1]! * mx + q[AXES + 4]! * my + q[AXES + 7]! * mz);
  q[TORQUE + 2] = q[TORQUE + 2]! + (q[AXES + 2]! * mx + q[AXES + 5]! * my + q[AXES + 8]! * mz);
}
