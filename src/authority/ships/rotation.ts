import type { Quat, Vec3 } from '../../dynamics';

/** Rotations from + − × ÷ √ alone, so that poses computed with them have the same bits in every engine. Quaternions [x, y, z, w]. */

/** Rotates `v` by the unit quaternion `q`: v + 2w (q×v) + 2 q×(q×v). */
export function rotate([x, y, z, w]: Quat, v: Vec3): Vec3 {
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return [
    v[0] + w * tx + (y * tz - z * ty),
    v[1] + w * ty + (z * tx - x * tz),
    v[2] + w * tz + (x * ty - y * tx),
  ];
}

/** First `b`, then `a`; normalised. */
export function compose(a: Quat, b: Quat): Quat {
  const x = a[3] * b[0] + a[0] * b[3] + (a[1] * b[2] - a[2] * b[1]);
  const y = a[3] * b[1] + a[1] * b[3] + (a[2] * b[0] - a[0] * b[2]);
  const z = a[3] * b[2] + a[2] * b[3] + (a[0] * b[1] - a[1] * b[0]);
  const w = a[3] * b[3] - (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  return [x / length, y / length, z / length, w / length];
}

/** The inverse of a unit quaternion. */
export function inverse([x, y, z, w]: Quat): Quat {
  return [-x, -y, -z, w];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
