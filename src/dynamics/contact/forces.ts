import { IMPACT_SPEED, POSITION, SURFACE_STATE, TIPPED, VELOCITY } from '../state/layout';
import {
  ALONG,
  COS_SLOPE,
  DEPTH,
  DT,
  GRAVITY,
  LIFT,
  LOAD,
  MASS,
  NORMAL,
  NORMAL_FORCE,
  NORMAL_SPEED,
  PENETRATION,
  GROUND_SPIN,
  quantities,
  SLOPE,
  start,
  type Step,
  SURFACE_NORMAL,
  TANGENTIAL_SPEED_SQUARED,
  TANGENTIAL_VELOCITY,
  THRUST,
  WEIGHT,
} from './quantities';
import {
  BOUNCE_SPEED,
  DAMPING_RATIO,
  FRICTION_KINETIC,
  FRICTION_STATIC,
  SETTLE_LINEAR_VEL,
} from '../constants/constantRows';

/** k / m of the contact spring, s⁻² (DYNAMICS, Normal force). */
const STIFFNESS = 100;
/** c / m at critical damping, 2 √(k/m), s⁻¹. */
const CRITICAL_DAMPING = 20;
/** Square of the speed, 1 cm/s, above which only kinetic friction acts, m²/s²: static friction must not stop a slide. */
const HELD_SPEED_SQUARED = 1e-4;

/** Fills LOAD and DEPTH, the static penetration under that load, from the gravity at `surface`. */
export function readLoad(surface: Float64Array): void {
  const q = quantities;
  const weight = q[MASS]! * surface[GRAVITY]!;
  const load =
    weight * surface[COS_SLOPE]! -
    (q[THRUST]! * surface[SURFACE_NORMAL]! +
      q[THRUST + 1]! * surface[SURFACE_NORMAL + 1]! +
      q[THRUST + 2]! * surface[SURFACE_NORMAL + 2]!);
  q[LOAD] = load > 0 ? load : 0;
  q[DEPTH] = q[LOAD] / (STIFFNESS * q[MASS]!);
}

/**
 * Whether normal and tangential speed are below the settle limit. The normal speed includes the spring's stored energy:
 * √(v_s² + 100 (penetration c_s − DEPTH)²).
 */
export function isNearlyAtRest(surface: Float64Array, step: Step): boolean {
  const q = quantities;
  const limit = step.settings[SETTLE_LINEAR_VEL]!;
  const speed = surface[NORMAL_SPEED]!;
  const sunk = surface[PENETRATION]! * surface[COS_SLOPE]! - q[DEPTH]!;
  return (
    speed * speed + STIFFNESS * (sunk * sunk) < limit * limit &&
    surface[TANGENTIAL_SPEED_SQUARED]! < limit * limit
  );
}

/**
 * Steps 3 and 4 for a penetrating ship: fills LOAD, DEPTH, ALONG and NORMAL_FORCE (spring and damper).
 * @returns whether static friction pins a tipped ship in place; NORMAL_FORCE is then LOAD
 */
export function press(step: Step): boolean {
  const q = quantities;
  const { settings } = step;
  readLoad(start);
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const off = q[THRUST]! * sx + q[THRUST + 1]! * sy + q[THRUST + 2]! * sz;
  const ax = q[WEIGHT]! * start[SLOPE]! - (q[THRUST]! - off * sx);
  const ay = q[WEIGHT]! * start[SLOPE + 1]! - (q[THRUST + 1]! - off * sy);
  const az = q[WEIGHT]! * start[SLOPE + 2]! - (q[THRUST + 2]! - off * sz);
  q[ALONG] = ax;
  q[ALONG + 1] = ay;
  q[ALONG + 2] = az;
  const isTipped = q[SURFACE_STATE] === TIPPED;
  const mostAlong = settings[FRICTION_STATIC]! * q[LOAD]!;
  if (isTipped && isNearlyAtRest(start, step) && ax * ax + ay * ay + az * az <= mostAlong * mostAlong) {
    q[NORMAL_FORCE] = q[LOAD]!;
    return true;
  }
  // c = 2 ζ √(k m) with k = 100 m.
  const ratio = settlesWithoutBounce(step) ? 1 : settings[DAMPING_RATIO]!;
  const sunk = start[PENETRATION]! * start[COS_SLOPE]!;
  const force = q[MASS]! * (STIFFNESS * sunk - CRITICAL_DAMPING * ratio * start[NORMAL_SPEED]!);
  q[NORMAL_FORCE] = force > 0 ? force : 0;
  return false;
}

/** Whether a grounded ship is tipped, or in a contact whose impact speed was at most contact_bounce_speed. */
function settlesWithoutBounce(step: Step): boolean {
  const q = quantities;
  return q[SURFACE_STATE] === TIPPED || q[IMPACT_SPEED]! <= step.settings[BOUNCE_SPEED]!;
}

/**
 * Step 5 on the ground: friction, semi-implicit Euler, and the limit on rebound from a settling contact. One function, so that
 * intermediate values stay in registers.
 */
export function moveOnGround(step: Step): void {
  const q = quantities;
  const dt = q[DT]!;
  const force = q[NORMAL_FORCE]!;
  const weight = q[WEIGHT]!;
  const perMass = dt / q[MASS]!;
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  let ux = q[VELOCITY]!;
  let uy = q[VELOCITY + 1]!;
  let uz = q[VELOCITY + 2]!;
  let fx = 0;
  let fy = 0;
  let fz = 0;
  if (force > 0) {
    // Friction demanded to keep the ship in place: against its slide, thrust, weight on the slope, and the ground's rotation.
    const perSpeed = q[MASS]! / dt;
    const half = 0.5 * q[MASS]!;
    const dx = start[TANGENTIAL_VELOCITY]! * perSpeed - (q[ALONG]! + half * (oy * uz - oz * uy));
    const dy = start[TANGENTIAL_VELOCITY + 1]! * perSpeed - (q[ALONG + 1]! + half * (oz * ux - ox * uz));
    const dz = start[TANGENTIAL_VELOCITY + 2]! * perSpeed - (q[ALONG + 2]! + half * (ox * uy - oy * ux));
    const off = dx * sx + dy * sy + dz * sz;
    fx = dx - off * sx;
    fy = dy - off * sy;
    fz = dz - off * sz;
    const share = frictionShare(fx * fx + fy * fy + fz * fz, force, step.settings);
    fx = -fx * share;
    fy = -fy * share;
    fz = -fz * share;
  }
  ux += (force * sx - weight * start[NORMAL]! + fx + q[THRUST]!) * perMass;
  uy += (force * sy - weight * start[NORMAL + 1]! + fy + q[THRUST + 1]!) * perMass;
  uz += (force * sz - weight * start[NORMAL + 2]! + fz + q[THRUST + 2]!) * perMass;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  if (start[PENETRATION]! > 0 && q[LIFT]! <= weight && settlesWithoutBounce(step)) {
    const rise =
      (ux - (oy * rz - oz * ry)) * sx + (uy - (oz * rx - ox * rz)) * sy + (uz - (ox * ry - oy * rx)) * sz;
    const excess = rise - mostRise();
    if (excess > 0) {
      ux -= excess * sx;
      uy -= excess * sy;
      uz -= excess * sz;
    }
  }
  q[VELOCITY] = ux;
  q[VELOCITY + 1] = uy;
  q[VELOCITY + 2] = uz;
  q[POSITION] = rx + ux * dt;
  q[POSITION + 1] = ry + uy * dt;
  q[POSITION + 2] = rz + uz * dt;
}

/** Share of the demanded friction that acts, 0 … 1: all of it if static friction holds, else limited by kinetic friction. */
function frictionShare(demandSquared: number, force: number, settings: Float64Array): number {
  const held = settings[FRICTION_STATIC]! * force;
  const kinetic = settings[FRICTION_KINETIC]! * force;
  const holds = start[TANGENTIAL_SPEED_SQUARED]! <= HELD_SPEED_SQUARED && demandSquared <= held * held;
  return holds || demandSquared <= kinetic * kinetic ? 1 : kinetic / Math.sqrt(demandSquared);
}

/** Normal speed that reaches the static penetration within the substep, m/s, ≥ 0. */
function mostRise(): number {
  const q = quantities;
  const toRest = (start[PENETRATION]! * start[COS_SLOPE]! - q[DEPTH]!) / q[DT]!;
  return toRest > 0 ? toRest : 0;
}
