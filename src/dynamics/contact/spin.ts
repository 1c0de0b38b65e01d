import { ANGULAR_VELOCITY, ATTITUDE, GROUND_CONTACT_OFFSET, SURFACE_STATE, TIPPED } from '../state/layout';
import {
  AXES,
  COS_SLOPE,
  DT,
  GROUND_SPIN,
  INERTIA_FACTOR,
  NORMAL,
  NORMAL_FORCE,
  quantities,
  step,
  SURFACE_NORMAL,
  TORQUE,
  WEIGHT,
  SMI_MASK,
} from './quantities';
import {
  FRICTION_KINETIC,
  INVERSE_INERTIA,
  LEG_RADIUS,
  SCRUB_INERTIA,
  SUPPORT_INERTIA,
} from '../constants/constantRows';

/** Per unit of inertia, s⁻² and s⁻¹: critically damped, like the contact spring. */
const SUPPORT_STIFFNESS = 100;
const SUPPORT_DAMPING = 20;
const SCRUB_DAMPING = 20;

/**
 * Step 6: angular velocity and attitude by semi-implicit Euler, without sine or cosine; updates `up`.
 * @param inGround whether the ground's moments act in addition to TORQUE: gravity about the feet, leg support and foot scrub. They are summed in
 *   ICRF axes with scalar moments of inertia, then rotated into body axes once.
 */
// eslint-disable-next-line max-lines-per-function -- A substep takes a tenth less time if intermediate values stay in registers.
export function turnByTorque(inGround: boolean): void {
  const q = quantities;
  const { ships, settings, shipClass } = step;
  const at = step.at & SMI_MASK;
  const qx = ships[at + ATTITUDE]!;
  const qy = ships[at + ATTITUDE + 1]!;
  const qz = ships[at + ATTITUDE + 2]!;
  const qw = ships[at + ATTITUDE + 3]!;
  let wx = ships[at + ANGULAR_VELOCITY]!;
  let wy = ships[at + ANGULAR_VELOCITY + 1]!;
  let wz = ships[at + ANGULAR_VELOCITY + 2]!;
  if (inGround || q[TORQUE] !== 0 || q[TORQUE + 1] !== 0 || q[TORQUE + 2] !== 0) {
    const qx2 = qx + qx;
    const qy2 = qy + qy;
    const qz2 = qz + qz;
    const upX = qx * qz2 + qw * qy2;
    const upY = qy * qz2 - qw * qx2;
    const upZ = 1 - (qx * qx2 + qy * qy2);
    let gx = 0;
    let gy = 0;
    let gz = 0;
    if (inGround) {
      const sx = q[SURFACE_NORMAL]!;
      const sy = q[SURFACE_NORMAL + 1]!;
      const sz = q[SURFACE_NORMAL + 2]!;
      const rx = wx - q[GROUND_SPIN]!;
      const ry = wy - q[GROUND_SPIN + 1]!;
      const rz = wz - q[GROUND_SPIN + 2]!;
      const yaw = rx * sx + ry * sy + rz * sz;
      const yawX = yaw * sx;
      const yawY = yaw * sy;
      const yawZ = yaw * sz;

      // Normal force, at most the weight's normal component; and the weight that it balances.
      const most = q[WEIGHT]! * q[COS_SLOPE]!;
      const held = q[NORMAL_FORCE]! < most ? q[NORMAL_FORCE]! : most;
      const carried = held / q[COS_SLOPE]!;

      // Support: J (−100 (s × up) − 20 w_tilt), limited by the weight's lever arm at the footprint's edge.
      const support = shipClass[SUPPORT_INERTIA]! * q[INERTIA_FACTOR]!;
      const stiffness = -SUPPORT_STIFFNESS * support;
      const damping = SUPPORT_DAMPING * support;
      let mx = stiffness * (sy * upZ - sz * upY) - damping * (rx - yawX);
      let my = stiffness * (sz * upX - sx * upZ) - damping * (ry - yawY);
      let mz = stiffness * (sx * upY - sy * upX) - damping * (rz - yawZ);
      const nx = q[NORMAL]!;
      const ny = q[NORMAL + 1]!;
      const nz = q[NORMAL + 2]!;
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
      const roll = ships[at + SURFACE_STATE] === TIPPED ? rx * upX + ry * upY + rz * upZ : 0;
      const scrubbing = -SCRUB_DAMPING * (shipClass[SCRUB_INERTIA]! * q[INERTIA_FACTOR]!);
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
      const toppling = carried * ships[at + GROUND_CONTACT_OFFSET]!;
      gx = toppling * (ny * upZ - nz * upY) + mx + kx;
      gy = toppling * (nz * upX - nx * upZ) + my + ky;
      gz = toppling * (nx * upY - ny * upX) + mz + kz;
    }
    // Torque in body axes, through the rotation matrix of the attitude at the start; its third column is `up`.
    const xx = 1 - (qy * qy2 + qz * qz2);
    const xy = qx * qy2 - qw * qz2;
    const yx = qx * qy2 + qw * qz2;
    const yy = 1 - (qx * qx2 + qz * qz2);
    const zx = qx * qz2 - qw * qy2;
    const zy = qy * qz2 + qw * qx2;
    let tx = q[TORQUE]!;
    let ty = q[TORQUE + 1]!;
    let tz = q[TORQUE + 2]!;
    if (inGround) {
      tx += xx * gx + yx * gy + zx * gz;
      ty += xy * gx + yy * gy + zy * gz;
      tz += upX * gx + upY * gy + upZ * gz;
    }
    if (tx !== 0 || ty !== 0 || tz !== 0) {
      // w += q.rotate(I⁻¹ torque) dt
      const k = INVERSE_INERTIA;
      const scaled = q[DT]! / q[INERTIA_FACTOR]!;
      const bx = (shipClass[k]! * tx + shipClass[k + 1]! * ty + shipClass[k + 2]! * tz) * scaled;
      const by = (shipClass[k + 3]! * tx + shipClass[k + 4]! * ty + shipClass[k + 5]! * tz) * scaled;
      const bz = (shipClass[k + 6]! * tx + shipClass[k + 7]! * ty + shipClass[k + 8]! * tz) * scaled;
      wx += xx * bx + xy * by + upX * bz;
      wy += yx * bx + yy * by + upY * bz;
      wz += zx * bx + zy * by + upZ * bz;
      ships[at + ANGULAR_VELOCITY] = wx;
      ships[at + ANGULAR_VELOCITY + 1] = wy;
      ships[at + ANGULAR_VELOCITY + 2] = wz;
    }
  }

  // q = normalize(q + ½ dt (w, 0) q)
  const half = 0.5 * q[DT]!;
  const hx = wx * half;
  const hy = wy * half;
  const hz = wz * half;
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

  // `up` of the new attitude.
  const x2 = x + x;
  const y2 = y + y;
  q[AXES + 2] = x * (z + z) + w * y2;
  q[AXES + 5] = y * (z + z) - w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}
