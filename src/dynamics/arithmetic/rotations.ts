import { ATTITUDE, BODY_TURN, POSITION } from '../state/layout';
import { AXIS, FROM, quantities, ROTATION, type Step, TO, SMI_MASK } from '../contact/quantities';
import { moveWithGround, spinWithGround } from '../contact/pose';

/** Landed or pinned: rotates the ship's position with the ground over the substep; u = Ω × r. */
export function turnPlaceWithGround(step: Step): void {
  const q = quantities;
  const { bodies } = step;
  const bodyAt = step.bodyAt & SMI_MASK;
  const ax = bodies[bodyAt + BODY_TURN]!;
  const ay = bodies[bodyAt + BODY_TURN + 1]!;
  const az = bodies[bodyAt + BODY_TURN + 2]!;
  const aw = bodies[bodyAt + BODY_TURN + 3]!;
  const x = q[POSITION]!;
  const y = q[POSITION + 1]!;
  const z = q[POSITION + 2]!;
  const tx = ay * z - az * y;
  const ty = az * x - ax * z;
  const tz = ax * y - ay * x;
  const twice = 2 * aw;
  // v + 2w (a × v) + 2 a × (a × v), summed from left to right. Another order moves a ship pinned for a minute by 0.1 µm.
  q[POSITION] = x + tx * twice + 2 * (ay * tz - az * ty);
  q[POSITION + 1] = y + ty * twice + 2 * (az * tx - ax * tz);
  q[POSITION + 2] = z + tz * twice + 2 * (ax * ty - ay * tx);
  moveWithGround();
}

/** Landed: also rotates the attitude with the ground; w = Ω. */
export function turnAttitudeWithGround(step: Step): void {
  const q = quantities;
  const { bodies } = step;
  const bodyAt = step.bodyAt & SMI_MASK;
  for (let k = 0; k < 4; k++) q[ROTATION + k] = bodies[bodyAt + BODY_TURN + k]!;
  rotateAttitude();
  spinWithGround();
}

/** q = normalize(ROTATION q): applies a rotation in ICRF axes, on the left. */
export function rotateAttitude(): void {
  const q = quantities;
  const ax = q[ROTATION]!;
  const ay = q[ROTATION + 1]!;
  const az = q[ROTATION + 2]!;
  const aw = q[ROTATION + 3]!;
  const bx = q[ATTITUDE]!;
  const by = q[ATTITUDE + 1]!;
  const bz = q[ATTITUDE + 2]!;
  const bw = q[ATTITUDE + 3]!;
  const x = ax * bw + aw * bx + ay * bz - az * by;
  const y = ay * bw + aw * by + az * bx - ax * bz;
  const z = az * bw + aw * bz + ax * by - ay * bx;
  const w = aw * bw - ax * bx - ay * by - az * bz;
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  q[ATTITUDE] = x * perLength;
  q[ATTITUDE + 1] = y * perLength;
  q[ATTITUDE + 2] = z * perLength;
  q[ATTITUDE + 3] = w * perLength;
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
    perpendicularAxis(quantities, FROM);
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

/** |a_x| from which a × y is used as the axis, since a × x is too short near x. */
const NEAR_X = 0.9;

/** AXIS = unit(a × x) for the unit vector a at `rows[from]`, with x = (1,0,0), or (0,1,0) if |a_x| ≥ 0.9. */
export function perpendicularAxis(rows: Float64Array, from: number): void {
  const q = quantities;
  const ax = rows[from]!;
  const ay = rows[from + 1]!;
  const az = rows[from + 2]!;
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
