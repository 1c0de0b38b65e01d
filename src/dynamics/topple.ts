import { ANGULAR_VELOCITY, ATTITUDE, BODY_ANGULAR_VELOCITY, FLYING, SURFACE_STATE, TIPPED } from './layout';
import {
  AXES,
  DT,
  MASS_RATIO,
  NORMAL,
  NORMAL_FORCE,
  PENETRATION,
  quantity as q,
  START,
  type Step,
  TORQUE,
  WEIGHT,
} from './quantities';

/** s⁻² and s⁻¹ per unit of inertia: the rotational twin of the spring-damper, critical. */
const SUPPORT_STIFFNESS = 100;
const SUPPORT_DAMPING = 20;
const SCRUB_DAMPING = 20;

/** Step 6: the ground's moments on a ship whose feet are in it, then spin and attitude by semi-implicit Euler. */
export function turnByTorques(step: Step): void {
  const { ships, at } = step;
  if (ships[at + SURFACE_STATE] !== FLYING && q[START + PENETRATION]! > 0) addGroundTorques(step);
  const dt = q[DT]!;
  const tx = q[TORQUE]!;
  const ty = q[TORQUE + 1]!;
  const tz = q[TORQUE + 2]!;
  let wx = ships[at + ANGULAR_VELOCITY]!;
  let wy = ships[at + ANGULAR_VELOCITY + 1]!;
  let wz = ships[at + ANGULAR_VELOCITY + 2]!;
  if (tx !== 0 || ty !== 0 || tz !== 0) {
    const inverse = step.shipClass.inverseInertia;
    const scaled = dt / q[MASS_RATIO]!;
    const bx = (inverse[0]! * tx + inverse[1]! * ty + inverse[2]! * tz) * scaled;
    const by = (inverse[3]! * tx + inverse[4]! * ty + inverse[5]! * tz) * scaled;
    const bz = (inverse[6]! * tx + inverse[7]! * ty + inverse[8]! * tz) * scaled;
    wx += q[AXES]! * bx + q[AXES + 1]! * by + q[AXES + 2]! * bz;
    wy += q[AXES + 3]! * bx + q[AXES + 4]! * by + q[AXES + 5]! * bz;
    wz += q[AXES + 6]! * bx + q[AXES + 7]! * by + q[AXES + 8]! * bz;
    ships[at + ANGULAR_VELOCITY] = wx;
    ships[at + ANGULAR_VELOCITY + 1] = wy;
    ships[at + ANGULAR_VELOCITY + 2] = wz;
  }

  // q = normalize(q + ½ dt (w, 0) q): no sine, no cosine.
  const half = 0.5 * dt;
  const hx = wx * half;
  const hy = wy * half;
  const hz = wz * half;
  const qx = ships[at + ATTITUDE]!;
  const qy = ships[at + ATTITUDE + 1]!;
  const qz = ships[at + ATTITUDE + 2]!;
  const qw = ships[at + ATTITUDE + 3]!;
  const x = qx + (hx * qw + hy * qz - hz * qy);
  const y = qy + (hy * qw + hz * qx - hx * qz);
  const z = qz + (hz * qw + hx * qy - hy * qx);
  const w = qw - (hx * qx + hy * qy + hz * qz);
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  ships[at + ATTITUDE] = x * perLength;
  ships[at + ATTITUDE + 1] = y * perLength;
  ships[at + ATTITUDE + 2] = z * perLength;
  ships[at + ATTITUDE + 3] = w * perLength;
}

/** Gravity about the feet, the legs' support and the feet's scrub, all in body axes, where up is z. */
function addGroundTorques(step: Step): void {
  const { ships, at, bodies, bodyAt, shipClass } = step;
  const nx = q[START + NORMAL]!;
  const ny = q[START + NORMAL + 1]!;
  const nz = q[START + NORMAL + 2]!;
  const bnx = q[AXES]! * nx + q[AXES + 3]! * ny + q[AXES + 6]! * nz;
  const bny = q[AXES + 1]! * nx + q[AXES + 4]! * ny + q[AXES + 7]! * nz;
  const bnz = q[AXES + 2]! * nx + q[AXES + 5]! * ny + q[AXES + 8]! * nz;
  const rx = ships[at + ANGULAR_VELOCITY]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
  const ry = ships[at + ANGULAR_VELOCITY + 1]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
  const rz = ships[at + ANGULAR_VELOCITY + 2]! - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
  const wx = q[AXES]! * rx + q[AXES + 3]! * ry + q[AXES + 6]! * rz;
  const wy = q[AXES + 1]! * rx + q[AXES + 4]! * ry + q[AXES + 7]! * rz;
  const wz = q[AXES + 2]! * rx + q[AXES + 5]! * ry + q[AXES + 8]! * rz;
  const yaw = wx * bnx + wy * bny + wz * bnz;

  // An impact's surplus turns nothing: gravity acts only as far as the feet carry the ship.
  const held = q[NORMAL_FORCE]! < q[WEIGHT]! ? q[NORMAL_FORCE]! : q[WEIGHT]!;
  // Gravity about the feet: held h (n × up), n × up = (n_y, −n_x, 0).
  const toppling = held * shipClass.groundContactOffset;
  const reach = held * shipClass.legRadius;
  const inertia = shipClass.inertia;
  const ratio = q[MASS_RATIO]!;

  // Support: I (−100 (n × up) − 20 w_tilt), saturating where the centre of pressure reaches the footprint's edge.
  const ax = -SUPPORT_STIFFNESS * bny - SUPPORT_DAMPING * (wx - yaw * bnx);
  const ay = SUPPORT_STIFFNESS * bnx - SUPPORT_DAMPING * (wy - yaw * bny);
  const az = -SUPPORT_DAMPING * (wz - yaw * bnz);
  let sx = (inertia[0]! * ax + inertia[1]! * ay + inertia[2]! * az) * ratio;
  let sy = (inertia[3]! * ax + inertia[4]! * ay + inertia[5]! * az) * ratio;
  let sz = (inertia[6]! * ax + inertia[7]! * ay + inertia[8]! * az) * ratio;
  const mostSupport = bnz > 0 ? reach * bnz : 0;
  const support = sx * sx + sy * sy + sz * sz;
  if (support > mostSupport * mostSupport) {
    const down = mostSupport / Math.sqrt(support);
    sx *= down;
    sy *= down;
    sz *= down;
  }

  // Scrub: I (−20 s), s the yaw about n, and for a tipped hull its roll about up as well.
  const roll = ships[at + SURFACE_STATE] === TIPPED ? wz : 0;
  const cx = -SCRUB_DAMPING * (yaw * bnx);
  const cy = -SCRUB_DAMPING * (yaw * bny);
  const cz = -SCRUB_DAMPING * (yaw * bnz + roll);
  let kx = (inertia[0]! * cx + inertia[1]! * cy + inertia[2]! * cz) * ratio;
  let ky = (inertia[3]! * cx + inertia[4]! * cy + inertia[5]! * cz) * ratio;
  let kz = (inertia[6]! * cx + inertia[7]! * cy + inertia[8]! * cz) * ratio;
  const mostScrub = step.world.settings.contactFrictionKinetic * reach;
  const scrub = kx * kx + ky * ky + kz * kz;
  if (scrub > mostScrub * mostScrub) {
    const down = mostScrub / Math.sqrt(scrub);
    kx *= down;
    ky *= down;
    kz *= down;
  }

  q[TORQUE] = q[TORQUE]! + toppling * bny + sx + kx;
  q[TORQUE + 1] = q[TORQUE + 1]! - toppling * bnx + sy + ky;
  q[TORQUE + 2] = q[TORQUE + 2]! + sz + kz;
}
