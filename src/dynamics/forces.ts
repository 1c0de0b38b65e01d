import {
  BODY_ANGULAR_VELOCITY,
  FLYING,
  IMPACT_SPEED,
  POSITION,
  SURFACE_STATE,
  TIPPED,
  VELOCITY,
} from './layout';
import {
  DEPTH,
  DT,
  LIFT,
  MASS,
  NORMAL,
  NORMAL_FORCE,
  PENETRATION,
  quantity as q,
  RADIAL_SPEED,
  START,
  type Step,
  TANGENTIAL_SPEED,
  TANGENTIAL_VELOCITY,
  THRUST,
  WEIGHT,
  INDEX,
} from './quantities';

/** k / m, s⁻²: the contact spring (DYNAMICS, Normal force). */
export const STIFFNESS = 100;

/** Whether vertical speed, √(v_radial² + 100 (penetration − DEPTH)²), the spring's stored energy counted in, and slide are small. */
export function isNearlyAtRest(surface: number, step: Step): boolean {
  const limit = step.world.settings.contactSettleLinearVel;
  const radial = q[surface + RADIAL_SPEED]!;
  const sunk = q[surface + PENETRATION]! - q[DEPTH]!;
  return (
    radial * radial + STIFFNESS * (sunk * sunk) < limit * limit && q[surface + TANGENTIAL_SPEED]! < limit
  );
}

/** Step 3: the depth it would rest at, and whether the ground holds a tipped ship where it stands. */
export function isPinned(step: Step): boolean {
  const { ships } = step;
  const at = step.at & INDEX;
  const state = ships[at + SURFACE_STATE]!;
  if (state === FLYING) return false;
  const load = q[WEIGHT]! - q[LIFT]!;
  q[DEPTH] = load > 0 ? load / (STIFFNESS * q[MASS]!) : 0;
  if (state !== TIPPED || !(q[START + PENETRATION]! > 0) || !isNearlyAtRest(START, step)) return false;
  const lift = q[LIFT]!;
  const px = q[THRUST]! - lift * q[START + NORMAL]!;
  const py = q[THRUST + 1]! - lift * q[START + NORMAL + 1]!;
  const pz = q[THRUST + 2]! - lift * q[START + NORMAL + 2]!;
  return (
    Math.sqrt(px * px + py * py + pz * pz) <=
    step.world.settings.contactFrictionStatic * (load > 0 ? load : 0)
  );
}

/** Step 4: F_n. Spring and damper of a ship in the ground; what is left of the weight where it is pinned. */
export function normalForce(step: Step, pinned: boolean): void {
  const { ships } = step;
  const at = step.at & INDEX;
  if (pinned) {
    const load = q[WEIGHT]! - q[LIFT]!;
    q[NORMAL_FORCE] = load > 0 ? load : 0;
  } else if (ships[at + SURFACE_STATE] !== FLYING && q[START + PENETRATION]! > 0) {
    // c = 2 ζ √(k m) with k = 100 m.
    const damping = settlesWithoutBounce(step) ? 20 : 20 * step.world.settings.contactDampingRatio;
    const force = q[MASS]! * (STIFFNESS * q[START + PENETRATION]! - damping * q[START + RADIAL_SPEED]!);
    q[NORMAL_FORCE] = force > 0 ? force : 0;
  } else {
    q[NORMAL_FORCE] = 0;
  }
}

/** Tipped, or in the contact of a touch not above contact_bounce_speed. Asked of grounded ships. */
function settlesWithoutBounce(step: Step): boolean {
  const { ships } = step;
  const at = step.at & INDEX;
  return (
    ships[at + SURFACE_STATE] === TIPPED ||
    ships[at + IMPACT_SPEED]! <= step.world.settings.contactBounceSpeed
  );
}

/** Step 5: friction, semi-implicit Euler, and no bounce out of a settling contact. */
export function moveByForces(step: Step): void {
  const { ships } = step;
  const at = step.at & INDEX;
  const dt = q[DT]!;
  const mass = q[MASS]!;
  const perMass = dt / mass;
  const force = q[NORMAL_FORCE]!;
  const radial = force - q[WEIGHT]!;
  const speed = q[START + TANGENTIAL_SPEED]!;
  // Size of the friction over ‖v_tangential‖, N s/m. Above 1 cm/s kinetic, and never more than stops the slide in this substep.
  let friction = 0;
  if (force > 0 && speed > 0) {
    const { contactFrictionKinetic, contactFrictionStatic } = step.world.settings;
    const stop = (mass * speed) / dt;
    const kinetic = contactFrictionKinetic * force;
    const holds = speed > 0.01 ? stop < kinetic : stop <= contactFrictionStatic * force;
    friction = (holds ? stop : kinetic) / speed;
  }
  const nx = q[START + NORMAL]!;
  const ny = q[START + NORMAL + 1]!;
  const nz = q[START + NORMAL + 2]!;
  ships[at + VELOCITY] =
    ships[at + VELOCITY]! + (radial * nx - friction * q[START + TANGENTIAL_VELOCITY]! + q[THRUST]!) * perMass;
  ships[at + VELOCITY + 1] =
    ships[at + VELOCITY + 1]! +
    (radial * ny - friction * q[START + TANGENTIAL_VELOCITY + 1]! + q[THRUST + 1]!) * perMass;
  ships[at + VELOCITY + 2] =
    ships[at + VELOCITY + 2]! +
    (radial * nz - friction * q[START + TANGENTIAL_VELOCITY + 2]! + q[THRUST + 2]!) * perMass;
  if (q[START + PENETRATION]! > 0 && ships[at + SURFACE_STATE] !== FLYING) {
    if (q[LIFT]! <= q[WEIGHT]! && settlesWithoutBounce(step)) capRise(step);
  }
  ships[at + POSITION] = ships[at + POSITION]! + ships[at + VELOCITY]! * dt;
  ships[at + POSITION + 1] = ships[at + POSITION + 1]! + ships[at + VELOCITY + 1]! * dt;
  ships[at + POSITION + 2] = ships[at + POSITION + 2]! + ships[at + VELOCITY + 2]! * dt;
}

/** The upward speed of a settling ship ends at the static depth: the excess is taken off along n. */
function capRise(step: Step): void {
  const { ships, bodies } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const nx = q[START + NORMAL]!;
  const ny = q[START + NORMAL + 1]!;
  const nz = q[START + NORMAL + 2]!;
  const ox = bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const oy = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const oz = bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const rx = ships[at + POSITION]!;
  const ry = ships[at + POSITION + 1]!;
  const rz = ships[at + POSITION + 2]!;
  const vx = ships[at + VELOCITY]! - (oy * rz - oz * ry);
  const vy = ships[at + VELOCITY + 1]! - (oz * rx - ox * rz);
  const vz = ships[at + VELOCITY + 2]! - (ox * ry - oy * rx);
  const rise = vx * nx + vy * ny + vz * nz;
  const toRest = (q[START + PENETRATION]! - q[DEPTH]!) / q[DT]!;
  const most = toRest > 0 ? toRest : 0;
  if (!(rise > most)) return;
  const excess = rise - most;
  ships[at + VELOCITY] = ships[at + VELOCITY]! - excess * nx;
  ships[at + VELOCITY + 1] = ships[at + VELOCITY + 1]! - excess * ny;
  ships[at + VELOCITY + 2] = ships[at + VELOCITY + 2]! - excess * nz;
}
