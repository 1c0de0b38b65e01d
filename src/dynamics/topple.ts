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
  INDEX,
} from './quantities';

/** s⁻² and s⁻¹ per unit of inertia: the rotational twin of the spring-damper, critical. */
const SUPPORT_STIFFNESS = 100;
const SUPPORT_DAMPING = 20;
const SCRUB_DAMPING = 20;

/**
 * Step 6: the ground's moments on a ship whose feet are in it, then spin and attitude by semi-implicit Euler; leaves `up` current.
 * All in body axes, where up is z. One function: its passes, named in comments, cost 30 ns more as functions of their own.
 */
export function turnByTorques(step: Step): void {
  const { ships, bodies, shipClass } = step;
  const bodyAt = step.bodyAt & INDEX;
  const at = step.at & INDEX;
  const dt = q[DT]!;
  const ratio = q[MASS_RATIO]!;
  const xx = q[AXES]!;
  const xy = q[AXES + 1]!;
  const xz = q[AXES + 2]!;
  const yx = q[AXES + 3]!;
  const yy = q[AXES + 4]!;
  const yz = q[AXES + 5]!;
  const zx = q[AXES + 6]!;
  const zy = q[AXES + 7]!;
  const zz = q[AXES + 8]!;
  let wx = ships[at + ANGULAR_VELOCITY]!;
  let wy = ships[at + ANGULAR_VELOCITY + 1]!;
  let wz = ships[at + ANGULAR_VELOCITY + 2]!;
  let tx = q[TORQUE]!;
  let ty = q[TORQUE + 1]!;
  let tz = q[TORQUE + 2]!;
  const state = ships[at + SURFACE_STATE]!;

  if (state !== FLYING && q[START + PENETRATION]! > 0) {
    const nx = q[START + NORMAL]!;
    const ny = q[START + NORMAL + 1]!;
    const nz = q[START + NORMAL + 2]!;
    const bnx = xx * nx + yx * ny + zx * nz;
    const bny = xy * nx + yy * ny + zy * nz;
    const bnz = xz * nx + yz * ny + zz * nz;
    const rx = wx - bodies[bodyAt + BODY_ANGULAR_VELOCITY]!;
    const ry = wy - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 1]!;
    const rz = wz - bodies[bodyAt + BODY_ANGULAR_VELOCITY + 2]!;
    const bwx = xx * rx + yx * ry + zx * rz;
    const bwy = xy * rx + yy * ry + zy * rz;
    const bwz = xz * rx + yz * ry + zz * rz;
    const yaw = bwx * bnx + bwy * bny + bwz * bnz;
    const inertia = shipClass.inertia;
    const i0 = inertia[0]!;
    const i1 = inertia[1]!;
    const i2 = inertia[2]!;
    const i3 = inertia[3]!;
    const i4 = inertia[4]!;
    const i5 = inertia[5]!;
    const i6 = inertia[6]!;
    const i7 = inertia[7]!;
    const i8 = inertia[8]!;

    // Gravity about the feet, held h (n × up) with n × up = (n_y, −n_x, 0): only as far as the feet carry the ship.
    const held = q[NORMAL_FORCE]! < q[WEIGHT]! ? q[NORMAL_FORCE]! : q[WEIGHT]!;
    const toppling = held * shipClass.groundContactOffset;
    const reach = held * shipClass.legRadius;

    // Support: I (−100 (n × up) − 20 w_tilt), saturating where the centre of pressure reaches the footprint's edge.
    const ax = -SUPPORT_STIFFNESS * bny - SUPPORT_DAMPING * (bwx - yaw * bnx);
    const ay = SUPPORT_STIFFNESS * bnx - SUPPORT_DAMPING * (bwy - yaw * bny);
    const az = -SUPPORT_DAMPING * (bwz - yaw * bnz);
    let sx = (i0 * ax + i1 * ay + i2 * az) * ratio;
    let sy = (i3 * ax + i4 * ay + i5 * az) * ratio;
    let sz = (i6 * ax + i7 * ay + i8 * az) * ratio;
    const mostSupport = bnz > 0 ? reach * bnz : 0;
    const support = sx * sx + sy * sy + sz * sz;
    if (support > mostSupport * mostSupport) {
      const down = mostSupport / Math.sqrt(support);
      sx *= down;
      sy *= down;
      sz *= down;
    }

    // Scrub: I (−20 s), s the yaw about n, and for a tipped hull its roll about up as well.
    const roll = state === TIPPED ? bwz : 0;
    const cx = -SCRUB_DAMPING * (yaw * bnx);
    const cy = -SCRUB_DAMPING * (yaw * bny);
    const cz = -SCRUB_DAMPING * (yaw * bnz + roll);
    let kx = (i0 * cx + i1 * cy + i2 * cz) * ratio;
    let ky = (i3 * cx + i4 * cy + i5 * cz) * ratio;
    let kz = (i6 * cx + i7 * cy + i8 * cz) * ratio;
    const mostScrub = step.world.settings.contactFrictionKinetic * reach;
    const scrub = kx * kx + ky * ky + kz * kz;
    if (scrub > mostScrub * mostScrub) {
      const down = mostScrub / Math.sqrt(scrub);
      kx *= down;
      ky *= down;
      kz *= down;
    }

    tx = tx + toppling * bny + sx + kx;
    ty = ty - toppling * bnx + sy + ky;
    tz = tz + sz + kz;
  }

  // Spin: w += q.rotate(I⁻¹ torque) dt.
  if (tx !== 0 || ty !== 0 || tz !== 0) {
    const inverse = shipClass.inverseInertia;
    const scaled = dt / ratio;
    const bx = (inverse[0]! * tx + inverse[1]! * ty + inverse[2]! * tz) * scaled;
    const by = (inverse[3]! * tx + inverse[4]! * ty + inverse[5]! * tz) * scaled;
    const bz = (inverse[6]! * tx + inverse[7]! * ty + inverse[8]! * tz) * scaled;
    wx += xx * bx + xy * by + xz * bz;
    wy += yx * bx + yy * by + yz * bz;
    wz += zx * bx + zy * by + zz * bz;
    ships[at + ANGULAR_VELOCITY] = wx;
    ships[at + ANGULAR_VELOCITY + 1] = wy;
    ships[at + ANGULAR_VELOCITY + 2] = wz;
  }

  // Attitude: q = normalize(q + ½ dt (w, 0) q); no sine, no cosine.
  const half = 0.5 * dt;
  const hx = wx * half;
  const hy = wy * half;
  const hz = wz * half;
  const qx = ships[at + ATTITUDE]!;
  const qy = ships[at + ATTITUDE + 1]!;
  const qz = ships[at + ATTITUDE + 2]!;
  const qw = ships[at + ATTITUDE + 3]!;
  const mx = qx + (hx * qw + hy * qz - hz * qy);
  const my = qy + (hy * qw + hz * qx - hx * qz);
  const mz = qz + (hz * qw + hx * qy - hy * qx);
  const mw = qw - (hx * qx + hy * qy + hz * qz);
  const perLength = 1 / Math.sqrt(mx * mx + my * my + mz * mz + mw * mw);
  const x = mx * perLength;
  const y = my * perLength;
  const z = mz * perLength;
  const w = mw * perLength;
  ships[at + ATTITUDE] = x;
  ships[at + ATTITUDE + 1] = y;
  ships[at + ATTITUDE + 2] = z;
  ships[at + ATTITUDE + 3] = w;

  // up of the new attitude.
  const x2 = x + x;
  const y2 = y + y;
  q[AXES + 2] = x * (z + z) + w * y2;
  q[AXES + 5] = y * (z + z) - w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}
