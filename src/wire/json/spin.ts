import { cosineOfDegrees, type Quat, sineOfDegrees, type Vec3 } from '../../dynamics';
import { type Fields, numberIn, type Reading, refuse, valueIn } from '../fields/reading';
import { optionalVectorIn } from '../fields/vectors';
import { FINITE } from '../limits';

/** Seconds: a body turns no faster than once in a tenth of a second. */
const FASTEST = 0.1;

/** Reads axis and period of a body. */
export interface SpinReader {
  readonly read: typeof spinIn;
  /** Why a body without them and without attitude or spin is refused. */
  readonly missing: string;
}

export const SPIN_READER: SpinReader = {
  read: spinIn,
  missing: 'missing, and so are spin_axis and rotation_period',
};

interface Spin {
  readonly attitude: Quat;
  readonly angularVelocity: Vec3;
}

/** From axis and period (s; negative: retrograde), or null if one of them is absent. */
function spinIn(r: Reading, from: Fields, time: number): Spin | null {
  const axisName = valueIn(r, from, 'spin_axis') === undefined ? 'axis' : 'spin_axis';
  const periodName = valueIn(r, from, 'rotation_period') === undefined ? 'period' : 'rotation_period';
  const axis = optionalVectorIn(r, from, axisName, FINITE);
  if (axis === null || valueIn(r, from, periodName) === undefined) return null;
  const period = numberIn(r, from, periodName, FINITE);
  const length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  if (!(Math.abs(length - 1) <= 1e-3))
    refuse(r, axisName, `expected a unit vector, got one of length ${length}`);
  if (!(Math.abs(period) >= FASTEST)) refuse(r, periodName, `expected at least ${FASTEST} s, got ${period}`);
  return r.reason === null
    ? spinOf([axis[0] / length, axis[1] / length, axis[2] / length], period, time)
    : null;
}

/**
 * Ω = (2π / period) × axis. At game time 0 the prime meridian is where the shortest rotation of the pole (body Y) to the axis
 * takes it: the game does not publish its prime meridian, so longitudes follow this convention.
 */
function spinOf(axis: Vec3, period: number, time: number): Spin {
  const rate = (2 * Math.PI) / period;
  const turns = time / period;
  const degrees = (turns - Math.floor(turns)) * 360;
  const [s, c] = [sineOfDegrees(degrees / 2), cosineOfDegrees(degrees / 2)];
  return {
    attitude: compose([axis[0] * s, axis[1] * s, axis[2] * s, c], poleTo(axis)),
    angularVelocity: [axis[0] * rate, axis[1] * rate, axis[2] * rate],
  };
}

/** Shortest rotation from (0, 1, 0) to `axis`; half a turn about x for the opposite. */
function poleTo([x, y, z]: Vec3): Quat {
  const across = x * x + z * z;
  if (across === 0 && y < 0) return [1, 0, 0, 0];
  // 1 + y, which cancels near −1.
  return unit([z, 0, -x, y < 0 ? across / (1 - y) : 1 + y]);
}

/** First `b`, then `a`. */
function compose([ax, ay, az, aw]: Quat, [bx, by, bz, bw]: Quat): Quat {
  return unit([
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ]);
}

function unit([x, y, z, w]: Quat): Quat {
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  return [x / length, y / length, z / length, w / length];
}
