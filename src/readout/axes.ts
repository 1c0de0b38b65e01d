/**
 * Turning vectors between ICRF and body axes. Quaternions (x, y, z, w), unit; `out` may be `v`. Results are written, not returned: a
 * double that a function returns is boxed wherever the engine does not inline the call, sixty times a second.
 */

/** out = q v q⁻¹: body axes → ICRF. */
export function toInertial(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, 1, v);
}

/** out = q⁻¹ v q: ICRF → body axes. */
export function toBodyAxes(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, -1, v);
}

/** out[at] = a · b */
export function writeDot(out: Float64Array, at: number, a: Float64Array, b: Float64Array): void {
  out[at] = a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
}

/** out = a × b; `out` is neither. */
export function cross(out: Float64Array, a: Float64Array, b: Float64Array): void {
  out[0] = a[1]! * b[2]! - a[2]! * b[1]!;
  out[1] = a[2]! * b[0]! - a[0]! * b[2]!;
  out[2] = a[0]! * b[1]! - a[1]! * b[0]!;
}

/** v + 2 w (p × v) + 2 p × (p × v), with p the vector part and w the scalar part times `sense`. */
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
