import type { BodyMotion } from '../../dynamics';
import { toBodyAxes, toInertial } from '../axes';

const attitude = new Float64Array(4);
const turned = new Float64Array(4);

/** out: body axes of a place on the ground of `body`, which is at `place` (ICRF axes, m) `seconds` from now. */
export function writeGroundPlace(
  out: Float64Array,
  place: Float64Array,
  body: BodyMotion,
  seconds: number,
): void {
  const spin = body.angularVelocity;
  const rate = Math.sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
  const half = (rate * seconds) / 2;
  const perRate = rate > 0 ? Math.sin(half) / rate : 0;
  for (let k = 0; k < 3; k++) turned[k] = spin[k]! * perRate;
  turned[3] = Math.cos(half);
  toBodyAxes(out, turned, place);
  for (let k = 0; k < 4; k++) attitude[k] = body.attitude[k]!;
  toBodyAxes(out, attitude, out);
}

/** out: the same place as `body` is turned now, ICRF axes, m. */
export function writePlaceNow(out: Float64Array, ground: Float64Array, body: BodyMotion): void {
  for (let k = 0; k < 4; k++) attitude[k] = body.attitude[k]!;
  toInertial(out, attitude, ground);
}
