import type { Quat, Vec3 } from '../../src/dynamics';

/** Geometry for the tests' measurements: independent of the law, and free to use Math.sin. */

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** a + s b */
export function plus(a: Vec3, b: Vec3, s = 1): Vec3 {
  return [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
}

export function times(a: Vec3, s: number): Vec3 {
  return [a[0] * s, a[1] * s, a[2] * s];
}

export function lengthOf(a: Vec3): number {
  return Math.hypot(...a);
}

export function unit(a: Vec3): Vec3 {
  return times(a, 1 / lengthOf(a));
}

/** Turns by `radians` about a unit axis, right-handed. */
export function turnAbout([x, y, z]: Vec3, radians: number): Quat {
  const s = Math.sin(radians / 2);
  return [x * s, y * s, z * s, Math.cos(radians / 2)];
}

/** First `b`, then `a`. */
export function product([ax, ay, az, aw]: Quat, [bx, by, bz, bw]: Quat): Quat {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

export function conjugate([x, y, z, w]: Quat): Quat {
  return [-x, -y, -z, w];
}

export function rotate(q: Quat, v: Vec3): Vec3 {
  const [x, y, z] = product(product(q, [...v, 0]), conjugate(q));
  return [x, y, z];
}

/** Angle between two attitudes, rad; exact to 1e-16 near 0, where an arccosine is not. */
export function angleBetween(a: Quat, b: Quat): number {
  const [x, y, z, w] = product(a, conjugate(b));
  return 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w));
}
