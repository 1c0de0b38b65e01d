import { IMPACT_SPEED, POSITION, SURFACE_STATE, TIPPED, VELOCITY } from '../state/layout';
import {
  ALONG,
  COS_SLOPE,
  DEPTH,
  DT,
  FRICTION,
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

/** k / m, s⁻²: the contact spring (DYNAMICS, Normal force). */
const STIFFNESS = 100;
/** c / m of critical damping, s⁻¹: 2 √(k/m). */
const CRITICAL_DAMPING = 20;
/** Static friction holds below 1 cm/s, m²/s²: a slide, however slow, is not stopped dead by the stronger of the two frictions. */
const HELD_SPEED_SQUARED = 1e-4;

/** LOAD, what presses into the ground, and DEPTH, where the spring rests under it; by the gravity at `surface`. */
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

/** ALONG: what pushes along the ground, weight on a slope less thrust. */
function readAlong(): void {
  const q = quantities;
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const off = q[THRUST]! * sx + q[THRUST + 1]! * sy + q[THRUST + 2]! * sz;
  q[ALONG] = q[WEIGHT]! * start[SLOPE]! - (q[THRUST]! - off * sx);
  q[ALONG + 1] = q[WEIGHT]! * start[SLOPE + 1]! - (q[THRUST + 1]! - off * sy);
  q[ALONG + 2] = q[WEIGHT]! * start[SLOPE + 2]! - (q[THRUST + 2]! - off * sz);
}

/** Whether vertical speed, √(v_s² + 100 (penetration c_s − DEPTH)²), the spring's stored energy counted in, and slide are small. */
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

/** Step 3, of a ship in the ground: its load, the depth it would rest at, and whether the ground holds it where it lies tipped. */
export function isPinned(step: Step): boolean {
  const q = quantities;
  readLoad(start);
  readAlong();
  if (q[SURFACE_STATE] !== TIPPED || !isNearlyAtRest(start, step)) return false;
  const most = step.settings[FRICTION_STATIC]! * q[LOAD]!;
  return q[ALONG]! * q[ALONG]! + q[ALONG + 1]! * q[ALONG + 1]! + q[ALONG + 2]! * q[ALONG + 2]! <= most * most;
}

/** Step 4, of a ship in the ground: F_n, spring and damper; the load where it is pinned. */
export function pressNormal(step: Step, pinned: boolean): void {
  const q = quantities;
  if (pinned) {
    q[NORMAL_FORCE] = q[LOAD]!;
    return;
  }
  // c = 2 ζ √(k m) with k = 100 m.
  const damping = settlesWithoutBounce(step)
    ? CRITICAL_DAMPING
    : CRITICAL_DAMPING * step.settings[DAMPING_RATIO]!;
  const sunk = start[PENETRATION]! * start[COS_SLOPE]!;
  const force = q[MASS]! * (STIFFNESS * sunk - damping * start[NORMAL_SPEED]!);
  q[NORMAL_FORCE] = force > 0 ? force : 0;
}

/** Tipped, or in the contact of a touch not above contact_bounce_speed. Asked of grounded ships. */
function settlesWithoutBounce(step: Step): boolean {
  const q = quantities;
  return q[SURFACE_STATE] === TIPPED || q[IMPACT_SPEED]! <= step.settings[BOUNCE_SPEED]!;
}

/** FRICTION: holds against slide, push, slope and the ground's own turning, or is kinetic and never more than ends the slide. */
function rub(step: Step): void {
  const q = quantities;
  const { settings } = step;
  const force = q[NORMAL_FORCE]!;
  const mass = q[MASS]!;
  const perSpeed = mass / q[DT]!;
  const half = 0.5 * mass;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const ux = q[VELOCITY]!;
  const uy = q[VELOCITY + 1]!;
  const uz = q[VELOCITY + 2]!;
  let dx = start[TANGENTIAL_VELOCITY]! * perSpeed - (q[ALONG]! + half * (oy * uz - oz * uy));
  let dy = start[TANGENTIAL_VELOCITY + 1]! * perSpeed - (q[ALONG + 1]! + half * (oz * ux - ox * uz));
  let dz = start[TANGENTIAL_VELOCITY + 2]! * perSpeed - (q[ALONG + 2]! + half * (ox * uy - oy * ux));
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const off = dx * sx + dy * sy + dz * sz;
  dx -= off * sx;
  dy -= off * sy;
  dz -= off * sz;
  const demand = dx * dx + dy * dy + dz * dz;
  const held = settings[FRICTION_STATIC]! * force;
  const kinetic = settings[FRICTION_KINETIC]! * force;
  const holds = start[TANGENTIAL_SPEED_SQUARED]! <= HELD_SPEED_SQUARED && demand <= held * held;
  const share = holds || demand <= kinetic * kinetic ? 1 : kinetic / Math.sqrt(demand);
  q[FRICTION] = -dx * share;
  q[FRICTION + 1] = -dy * share;
  q[FRICTION + 2] = -dz * share;
}

/** Step 5 on the ground: friction, semi-implicit Euler, and no bounce out of a settling contact. */
export function moveOnGround(step: Step): void {
  const q = quantities;
  const dt = q[DT]!;
  const perMass = dt / q[MASS]!;
  const force = q[NORMAL_FORCE]!;
  const weight = q[WEIGHT]!;
  if (force > 0) rub(step);
  else q[FRICTION] = q[FRICTION + 1] = q[FRICTION + 2] = 0;
  q[VELOCITY] =
    q[VELOCITY]! +
    (force * start[SURFACE_NORMAL]! - weight * start[NORMAL]! + q[FRICTION]! + q[THRUST]!) * perMass;
  q[VELOCITY + 1] =
    q[VELOCITY + 1]! +
    (force * start[SURFACE_NORMAL + 1]! - weight * start[NORMAL + 1]! + q[FRICTION + 1]! + q[THRUST + 1]!) *
      perMass;
  q[VELOCITY + 2] =
    q[VELOCITY + 2]! +
    (force * start[SURFACE_NORMAL + 2]! - weight * start[NORMAL + 2]! + q[FRICTION + 2]! + q[THRUST + 2]!) *
      perMass;
  if (start[PENETRATION]! > 0 && q[LIFT]! <= weight && settlesWithoutBounce(step)) capRise();
  q[POSITION] = q[POSITION]! + q[VELOCITY] * dt;
  q[POSITION + 1] = q[POSITION + 1]! + q[VELOCITY + 1]! * dt;
  q[POSITION + 2] = q[POSITION + 2]! + q[VELOCITY + 2]! * dt;
}

/** The speed off the ground of a settling ship ends at the static depth: the excess is taken off along s. */
function capRise(): void {
  const q = quantities;
  const sx = start[SURFACE_NORMAL]!;
  const sy = start[SURFACE_NORMAL + 1]!;
  const sz = start[SURFACE_NORMAL + 2]!;
  const ox = q[GROUND_SPIN]!;
  const oy = q[GROUND_SPIN + 1]!;
  const oz = q[GROUND_SPIN + 2]!;
  const rx = q[POSITION]!;
  const ry = q[POSITION + 1]!;
  const rz = q[POSITION + 2]!;
  const vx = q[VELOCITY]! - (oy * rz - oz * ry);
  const vy = q[VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = q[VELOCITY + 2]! - (ox * ry - oy * rx);
  const rise = vx * sx + vy * sy + vz * sz;
  const toRest = (start[PENETRATION]! * start[COS_SLOPE]! - q[DEPTH]!) / q[DT]!;
  const most = toRest > 0 ? toRest : 0;
  if (!(rise > most)) return;
  const excess = rise - most;
  q[VELOCITY] = q[VELOCITY]! - excess * sx;
  q[VELOCITY + 1] = q[VELOCITY + 1]! - excess * sy;
  q[VELOCITY + 2] = q[VELOCITY + 2]! - excess * sz;
}
