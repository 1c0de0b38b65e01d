/**
 * Rotations of doubles in place: vectors [x, y, z], quaternions [x, y, z, w], out first, out may be an argument.
 * For comparing, easing and drawing; the exact ones are in dynamics.
 */

/** Scratch that is handed to the functions below. */
export const vector = (): Float64Array => new Float64Array(3);
export const quaternion = (): Float64Array => Float64Array.of(0, 0, 0, 1);

/** out = rows[at …] */
export function take(out: Float64Array, rows: Float64Array, at: number): void {
  for (let k = 0; k < out.length; k++) out[k] = rows[at + k]!;
}

/** rows[at …] = value */
export function put(rows: Float64Array, at: number, value: Float64Array): void {
  for (let k = 0; k < value.length; k++) rows[at + k] = value[k]!;
}

/** out = q v q⁻¹ */
export function rotate(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, 1, v);
}

/** out = q⁻¹ v q */
export function rotateBack(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, -1, v);
}

/** Rotates by q, or by its inverse if `sense` is −1: an integer, since a double would be boxed for the call. */
function turn(out: Float64Array, q: Float64Array, sense: 1 | -1, v: Float64Array): void {
  const qx = q[0]!;
  const qy = q[1]!;
  const qz = q[2]!;
  const qw = sense * q[3]!;
  const x = v[0]!;
  const y = v[1]!;
  const z = v[2]!;
  const tx = 2 * (qy * z - qz * y);
  const ty = 2 * (qz * x - qx * z);
  const tz = 2 * (qx * y - qy * x);
  out[0] = x + qw * tx + (qy * tz - qz * ty);
  out[1] = y + qw * ty + (qz * tx - qx * tz);
  out[2] = z + qw * tz + (qx * ty - qy * tx);
}

/** out += share v */
export function add(out: Float64Array, v: Float64Array, share: number): void {
  for (let k = 0; k < v.length; k++) out[k] = out[k]! + share * v[k]!;
}

/** a · b */
export function dot(a: Float64Array, b: Float64Array): number {
  return a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
}

/** out = a × b; `out` is neither. */
export function cross(out: Float64Array, a: Float64Array, b: Float64Array): void {
  out[0] = a[1]! * b[2]! - a[2]! * b[1]!;
  out[1] = a[2]! * b[0]! - a[0]! * b[2]!;
  out[2] = a[0]! * b[1]! - a[1]! * b[0]!;
}

/** out = a b: first b, then a. */
export function compose(out: Float64Array, a: Float64Array, b: Float64Array): void {
  multiply(out, a, 1, b, 1);
}

/** out = a⁻¹ b: b in a's axes. */
export function relativeRotation(out: Float64Array, a: Float64Array, b: Float64Array): void {
  multiply(out, a, -1, b, 1);
}

/** out = a b⁻¹: the rotation from b to a, in the axes in which both are given. */
export function rotationBetween(out: Float64Array, a: Float64Array, b: Float64Array): void {
  multiply(out, a, 1, b, -1);
}

/** The product of two rotations or their inverses, for which the sense is −1. */
function multiply(out: Float64Array, a: Float64Array, senseA: 1 | -1, b: Float64Array, senseB: 1 | -1): void {
  const ax = senseA * a[0]!;
  const ay = senseA * a[1]!;
  const az = senseA * a[2]!;
  const aw = a[3]!;
  const bx = senseB * b[0]!;
  const by = senseB * b[1]!;
  const bz = senseB * b[2]!;
  const bw = b[3]!;
  out[0] = aw * bx + ax * bw + ay * bz - az * by;
  out[1] = aw * by + ay * bw + az * bx - ax * bz;
  out[2] = aw * bz + az * bw + ax * by - ay * bx;
  out[3] = aw * bw - ax * bx - ay * by - az * bz;
}

export function normalize(q: Float64Array): void {
  const perLength = 1 / Math.sqrt(q[0]! * q[0]! + q[1]! * q[1]! + q[2]! * q[2]! + q[3]! * q[3]!);
  for (let k = 0; k < 4; k++) q[k] = q[k]! * perLength;
}

/** How far, 0 … 1: in a record, since a double as an argument is boxed unless the call is inlined. */
export interface Share {
  readonly alpha: number;
}

/** out = the attitude `alpha` of the short way from a to b. Normalised lerp: within 1e-8 of the arc below 0.01 rad. */
export function blend(out: Float64Array, a: Float64Array, b: Float64Array, { alpha }: Share): void {
  const dot = a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]! + a[3]! * b[3]!;
  const toB = dot < 0 ? -alpha : alpha;
  const toA = 1 - alpha;
  for (let k = 0; k < 4; k++) out[k] = a[k]! * toA + b[k]! * toB;
  normalize(out);
}

/** q = the rotation by |v| rad about v. */
export function fromRotationVector(q: Float64Array, v: Float64Array): void {
  const angle = lengthOf(v);
  const scale = angle < 1e-6 ? 0.5 : Math.sin(angle / 2) / angle;
  for (let k = 0; k < 3; k++) q[k] = v[k]! * scale;
  q[3] = Math.cos(angle / 2);
}

/** v = the rotation vector, at most π long, of unit q. */
export function toRotationVector(v: Float64Array, q: Float64Array): void {
  const sine = lengthOf(q);
  const sign = q[3]! < 0 ? -1 : 1;
  const scale = sine < 1e-9 ? 2 : angleOf(q) / sine;
  for (let k = 0; k < 3; k++) v[k] = q[k]! * scale * sign;
}

/** The angle of unit q, rad, 0 … π. */
export function angleOf(q: Float64Array): number {
  return 2 * Math.atan2(lengthOf(q), Math.abs(q[3]!));
}

/** Of a quaternion, the length of its vector part. */
export function lengthOf(v: Float64Array): number {
  return Math.sqrt(dot(v, v));
}

/** out[0] = |v|. For what each ship needs in each frame: the double that lengthOf returns is boxed unless both calls are inlined. */
export function measure(out: Float64Array, v: Float64Array): void {
  out[0] = Math.sqrt(v[0]! * v[0]! + v[1]! * v[1]! + v[2]! * v[2]!);
}
