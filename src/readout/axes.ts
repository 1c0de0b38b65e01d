/**
 * Turning vectors between ICRF and body axes. Quaternions (x, y, z, w), unit; `out` may be `v`. Results are written, not returned: a
 * double that a function returns is boxed wherever the engine does not inline the call, sixty times a second.
 */

/** out = q v q⁻¹: body axes → ICRF. */
export function toInertial(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, v, 1);
}

/** out = q⁻¹ v q: ICRF → body axes. */
export function toBodyAxes(out: Float64Array, q: Float64Array, v: Float64Array): void {
  turn(out, q, v, -1);
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

/** v + 2 w (p × v) + 2 p × (p × v), with p the vector part times `sense`. */
function turn(out: Float64Array, q: Float64Array, v: Float64Array, sense: 1 | -1): void {
  const px = sense * q[0]!;
  const py = sense * q[1]!;
  const pz = sense * q[2]!;
  const x = v[0]!;
  const y = v[1]!;
  const z = v[2]!;
  const tx = 2 * (py * z - pz * y);
  const ty = 2 * (pz * x - px * z);
  const tz = 2 * (px * y - py * x);
  out[0] = x + q[3]! * tx + (py * tz - pz * ty);
  out[1] = y + q[3]! * ty + (pz * tx - px * tz);
  out[2] = z + q[3]! * tz + (px * ty - py * tx);
}
