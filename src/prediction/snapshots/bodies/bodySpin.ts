import {
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  type BodyMotion,
  LANDED,
  POSITION,
  type Quat,
  REFERENCE_BODY,
  SURFACE_STATE,
  type Vec3,
} from '../../../dynamics';
import {
  compose,
  fromRotationVector,
  quaternion,
  take,
  toRotationVector,
  rotationBetween,
  vector,
} from '../../drawn/rotation';

/**
 * A body's real spin (PREDICTION, Foreign dynamics): measured from its attitudes, or from ships at rest on it, relative to the spin
 * sent.
 */
export interface BodySpin {
  /** The real spin divided by the one sent: 1 while that fits. */
  factor: number;
  readonly byAttitude: Measurement;
  readonly byShips: Measurement;
  /** Angle about the spin axis that is missing from an attitude computed with the spin sent, rad. */
  lacking: number;
  /** Of the last frame that had it. */
  tick: number;
  readonly attitude: Float64Array;
}

/** A ratio that is accepted once two measurements agree. */
interface Measurement {
  believed: number;
  last: number;
}

/** A ratio closer to 1 than this counts as 1: rounding of a ship's ICRF position alone is 1e-6 of the rotation in a tenth of a second. */
const SAME_SPIN = 1e-4;
/** rad/s: slower bodies are not measured. Deviations beyond MAX_DEVIATION of the spin sent are ignored. */
const MIN_SPIN = 1e-9;
const MAX_DEVIATION = 0.5;
/** Sideways deviation of a ship's path from the ground's, as a share of its length, up to which one measurement is enough. */
const ASIDE = 1e-3;

export function createBodySpin(): BodySpin {
  const measurement = (): Measurement => ({ believed: 1, last: Number.NaN });
  return {
    factor: 1,
    byAttitude: measurement(),
    byShips: measurement(),
    lacking: 0,
    tick: -1,
    attitude: quaternion(),
  };
}

/** A body's motion at `tick`, `seconds` of game time after the last one, with its real spin and attitude. */
export function spunMotion(spin: BodySpin, sent: BodyMotion, tick: number, seconds: number): BodyMotion {
  const [x, y, z] = sent.angularVelocity;
  const rate = Math.sqrt(x * x + y * y + z * z);
  now.set(sent.attitude);
  if (spin.tick >= 0 && tick > spin.tick && rate > MIN_SPIN) {
    rotationBetween(turn, now, spin.attitude);
    toRotationVector(way, turn);
    const turned = (way[0]! * x + way[1]! * y + way[2]! * z) / rate;
    accept(spin, spin.byAttitude, turned / (rate * seconds));
    if (isAsSent(spin.byAttitude.believed)) spin.lacking += (spin.factor - 1) * rate * seconds;
  }
  spin.tick = tick;
  spin.attitude.set(now);
  if (spin.factor === 1 && spin.lacking === 0) return sent;
  for (const [k, w] of sent.angularVelocity.entries()) way[k] = (w / rate) * spin.lacking;
  fromRotationVector(turn, way);
  compose(now, turn, now);
  return {
    ...sent,
    attitude: [...now] as unknown as Quat,
    angularVelocity: sent.angularVelocity.map((w) => w * spin.factor) as unknown as Vec3,
  };
}

/**
 * Measures the spin by one ship that was landed in two states, `seconds` of game time apart: it moved with the ground.
 * @param bodies rows with the spin in use, at the second state's tick
 */
export function measureByShip(
  spin: BodySpin,
  before: Float64Array,
  after: Float64Array,
  bodies: Float64Array,
  seconds: number,
): void {
  if (before[SURFACE_STATE] !== LANDED || after[SURFACE_STATE] !== LANDED) return;
  if (before[REFERENCE_BODY] !== after[REFERENCE_BODY]) return;
  take(way, bodies, after[REFERENCE_BODY]! * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  for (let k = 0; k < 3; k++) way[k] = way[k]! / spin.factor;
  for (let k = 0; k < 3; k++) middle[k] = (before[POSITION + k]! + after[POSITION + k]!) / 2;
  let along = 0;
  let squared = 0;
  let moved = 0;
  for (let k = 0; k < 3; k++) {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    const speed = way[i]! * middle[j]! - way[j]! * middle[i]!;
    const step = after[POSITION + k]! - before[POSITION + k]!;
    along += speed * step;
    squared += speed * speed;
    moved += step * step;
  }
  if (!(squared > MIN_SPIN)) return;
  const aside = moved - (along * along) / squared;
  // Exactly along the ground's path: one measurement is enough.
  if (aside < ASIDE * ASIDE * moved) spin.byShips.last = along / (squared * seconds);
  accept(spin, spin.byShips, along / (squared * seconds));
}

function accept(spin: BodySpin, measurement: Measurement, ratio: number): void {
  if (!(Math.abs(ratio - 1) < MAX_DEVIATION)) return;
  if (Math.abs(ratio - measurement.last) < SAME_SPIN) measurement.believed = ratio;
  measurement.last = ratio;
  const { byAttitude, byShips } = spin;
  const real = isAsSent(byAttitude.believed) ? byShips.believed : byAttitude.believed;
  if (isAsSent(real)) spin.factor = 1;
  else if (Math.abs(real - spin.factor) > SAME_SPIN) spin.factor = real;
}

function isAsSent(ratio: number): boolean {
  return Math.abs(ratio - 1) < SAME_SPIN;
}

const now = quaternion();
const turn = quaternion();
const way = vector();
const middle = vector();
