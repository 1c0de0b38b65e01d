import { ATTITUDE, POSITION } from '../state/layout';
import { AXIS, DT, FROM, GROUND_SPIN, quantities, ROTATION, SMI_MASK, step, TO } from '../contact/quantities';
import { moveWithGround, spinWithGround } from '../contact/pose';

/** Landed or pinned: ROTATION = normalize(Ω dt/2, 1) rotates the ship's position with the ground over the substep; u = Ω × r. */
export function turnPlaceWithGround(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const half = 0.5 * q[DT]!;
  const hx = q[GROUND_SPIN]! * half;
  const hy = q[GROUND_SPIN + 1]! * half;
  const hz = q[GROUND_SPIN + 2]! * half;
  const aw = 1 / Math.sqrt(hx * hx + hy * hy + hz * hz + 1);
  const ax = hx * aw;
  const ay = hy * aw;
  const az = hz * aw;
  q[ROTATION] = ax;
  q[ROTATION + 1] = ay;
  q[ROTATION + 2] = az;
  q[ROTATION + 3] = aw;
  const x = ships[at + POSITION]!;
  const y = ships[at + POSITION + 1]!;
  const z = ships[at + POSITION + 2]!;
  const tx = ay * z - az * y;
  const ty = az * x - ax * z;
  const tz = ax * y - ay * x;
  const twice = 2 * aw;
  // v + 2w (a × v) + 2 a × (a × v), summed from left to right. Another order moves a ship pinned for a minute by 0.1 µm.
  ships[at + POSITION] = x + tx * twice + 2 * (ay * tz - az * ty);
  ships[at + POSITION + 1] = y + ty * twice + 2 * (az * tx - ax * tz);
  ships[at + POSITION + 2] = z + tz * twice + 2 * (ax * ty - ay * tx);
  moveWithGround();
}

/** Landed: also rotates the attitude with the ground; w = Ω. */
export function turnAttitudeWithGround(): void {
  rotateAttitude();
  spinWithGround();
}

/** q = normalize(ROTATION q): applies a rotation in ICRF axes, on the left. */
export function rotateAttitude(): void {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  const ax = q[ROTATION]!;
  const ay = q[ROTATION + 1]!;
  const az = q[ROTATION + 2]!;
  const aw = q[ROTATION + 3]!;
  const bx = ships[at + ATTITUDE]!;
  const by = ships[at + ATTITUDE + 1]!;
  const bz = ships[at + ATTITUDE + 2]!;
  const bw = ships[at + ATTITUDE + 3]!;
  const x = ax * bw + aw * bx + ay * bz - az * by;
  const y = ay * bw + aw * by + az * bx - ax * bz;
  const z = az * bw + aw * bz + ax * by - ay * bx;
  const w = aw * bw - ax * bx - ay * by - az * bz;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  ships[at + ATTITUDE] = x * perLength;
  ships[at + ATTITUDE + 1] = y * perLength;
  ships[at + ATTITUDE + 2] = z * perLength;
  ships[at + ATTITUDE + 3] = w * perLength;
}

/** a · b below which two unit vectors count as opposite (179.92° and more): the direction of a × b is then rounding error. */
const OPPOSED = -0.999999;

/** ROTATION = the shortest rotation from unit FROM to unit TO: normalize(a × b, 1 + a·b), or half a turn if they are opposite. */
export function shortestRotation(): void {
  const q = quantities;
  const ax = q[FROM]!;
  const ay = q[FROM + 1]!;
  const az = q[FROM + 2]!;
  const bx = q[TO]!;
  const by = q[TO + 1]!;
  const bz = q[TO + 2]!;
  const dot = ax * bx + ay * by + az * bz;
  if (dot < OPPOSED) {
    perpendicularAxis(FROM);
    q[ROTATION] = q[AXIS]!;
    q[ROTATION + 1] = q[AXIS + 1]!;
    q[ROTATION + 2] = q[AXIS + 2]!;
    q[ROTATION + 3] = 0;
    return;
  }
  const x = ay * bz - az * by;
  const y = az * bx - ax * bz;
  const z = ax * by - ay * bx;
  const w = 1 + dot;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  q[ROTATION] = x * perLength;
  q[ROTATION + 1] = y * perLength;
  q[ROTATION + 2] = z * perLength;
  q[ROTATION + 3] = w * perLength;
}

/** |a_x| from which the axis is a × y, since a × x is too short near x. */
const NEAR_X = 0.9;

/** AXIS = unit(a × x) for the unit vector a at the slot `from`, with x = (1,0,0), or (0,1,0) if |a_x| ≥ 0.9. */
export function perpendicularAxis(from: number): void {
  const q = quantities;
  const ax = q[from]!;
  const ay = q[from + 1]!;
  const az = q[from + 2]!;
  if (ax >= NEAR_X || ax <= -NEAR_X) {
    const perLength = 1 / Math.sqrt(az * az + ax * ax);
    q[AXIS] = -az * perLength;
    q[AXIS + 1] = 0;
    q[AXIS + 2] = ax * perLength;
    return;
  }
  const perLength = 1 / Math.sqrt(az * az + ay * ay);
  q[AXIS] = 0;
  q[AXIS + 1] = az * perLength;
  q[AXIS + 2] = -ay * perLength;
}
