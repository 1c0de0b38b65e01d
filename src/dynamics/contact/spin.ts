import { ANGULAR_VELOCITY, ATTITUDE } from '../state/layout';
import { AXES, DT, INERTIA_FACTOR, quantities, type Step, TORQUE } from './quantities';
import { INVERSE_INERTIA } from '../constants/constantRows';

/** Step 6: angular velocity and attitude by semi-implicit Euler, without sine or cosine; updates `up`. */
export function turnByTorque(step: Step): void {
  const q = quantities;
  const tx = q[TORQUE]!;
  const ty = q[TORQUE + 1]!;
  const tz = q[TORQUE + 2]!;
  if (tx !== 0 || ty !== 0 || tz !== 0) {
    // w += q.rotate(I⁻¹ torque) dt
    const { shipClass } = step;
    const scaled = q[DT]! / q[INERTIA_FACTOR]!;
    const bx =
      (shipClass[INVERSE_INERTIA]! * tx +
        shipClass[INVERSE_INERTIA + 1]! * ty +
        shipClass[INVERSE_INERTIA + 2]! * tz) *
      scaled;
    const by =
      (shipClass[INVERSE_INERTIA + 3]! * tx +
        shipClass[INVERSE_INERTIA + 4]! * ty +
        shipClass[INVERSE_INERTIA + 5]! * tz) *
      scaled;
    const bz =
      (shipClass[INVERSE_INERTIA + 6]! * tx +
        shipClass[INVERSE_INERTIA + 7]! * ty +
        shipClass[INVERSE_INERTIA + 8]! * tz) *
      scaled;
    q[ANGULAR_VELOCITY] = q[ANGULAR_VELOCITY]! + (q[AXES]! * bx + q[AXES + 1]! * by + q[AXES + 2]! * bz);
    q[ANGULAR_VELOCITY + 1] =
      q[ANGULAR_VELOCITY + 1]! + (q[AXES + 3]! * bx + q[AXES + 4]! * by + q[AXES + 5]! * bz);
    q[ANGULAR_VELOCITY + 2] =
      q[ANGULAR_VELOCITY + 2]! + (q[AXES + 6]! * bx + q[AXES + 7]! * by + q[AXES + 8]! * bz);
  }

  // q = normalize(q + ½ dt (w, 0) q)
  const half = 0.5 * q[DT]!;
  const hx = q[ANGULAR_VELOCITY]! * half;
  const hy = q[ANGULAR_VELOCITY + 1]! * half;
  const hz = q[ANGULAR_VELOCITY + 2]! * half;
  const qx = q[ATTITUDE]!;
  const qy = q[ATTITUDE + 1]!;
  const qz = q[ATTITUDE + 2]!;
  const qw = q[ATTITUDE + 3]!;
  const mx = qx + (hx * qw + hy * qz - hz * qy);
  const my = qy + (hy * qw + hz * qx - hx * qz);
  const mz = qz + (hz * qw + hx * qy - hy * qx);
  const mw = qw - (hx * qx + hy * qy + hz * qz);
  const perLength = 1 / Math.sqrt(mx * mx + my * my + mz * mz + mw * mw);
  const x = mx * perLength;
  const y = my * perLength;
  const z = mz * perLength;
  const w = mw * perLength;
  q[ATTITUDE] = x;
  q[ATTITUDE + 1] = y;
  q[ATTITUDE + 2] = z;
  q[ATTITUDE + 3] = w;

  // `up` of the new attitude.
  const x2 = x + x;
  const y2 = y + y;
  q[AXES + 2] = x * (z + z) + w * y2;
  q[AXES + 5] = y * (z + z) - w * x2;
  q[AXES + 8] = 1 - (x * x2 + y * y2);
}
