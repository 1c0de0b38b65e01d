import { toBodyAxes, writeDot } from '../axes';
import type { Surface } from '../surface';

/**
 * The cross-pointer: velocity along the ground in ship axes, seen along the ship's −Z. A leaning ship is first rotated upright by
 * the shortest rotation from local up to its own, so that the speed keeps its size whatever the tilt.
 */
export interface Drift {
  /** m/s along the ship's +X. */
  x: number;
  /** m/s along the ship's +Y. */
  y: number;
  /** Full deflection, m/s; one of SCALES. */
  scale: number;
}

/** Full deflections, m/s: the next larger one applies when the pointer would leave the dial. */
const SCALES = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000] as const;
/** The next smaller scale applies only below this share of it, so that the scale does not flicker. */
const ROOM_TO_SHRINK = 0.8;

export function createDrift(): Drift {
  return { x: NaN, y: NaN, scale: SCALES[0] };
}

export function forgetDrift(out: Drift): void {
  out.x = NaN;
  out.y = NaN;
}

const stood = new Float64Array(3);
const product = new Float64Array(2);

export function measureDrift(out: Drift, surface: Surface, attitude: Float64Array): void {
  standUp(stood, surface);
  toBodyAxes(stood, attitude, stood);
  out.x = stood[0]!;
  out.y = stood[1]!;
  rescale(out, surface);
}

/** Of 1 + n · up: upside down the shortest rotation has no axis, and quotients must stay finite. */
const MIN_SHARE = 1e-12;

/** v turned by the shortest rotation n → up: v − 2 (v·half) up' in closed form for v ⟂ n. */
function standUp(out: Float64Array, { normal, up, tangential }: Surface): void {
  writeDot(product, 0, tangential, up);
  writeDot(product, 1, normal, up);
  const along = product[0]! / Math.max(MIN_SHARE, 1 + product[1]!);
  for (let k = 0; k < 3; k++) out[k] = tangential[k]! - along * (normal[k]! + up[k]!);
}

function rescale(out: Drift, { tangentialSpeed }: Surface): void {
  let at = 0;
  while (at < SCALES.length - 1 && SCALES[at]! !== out.scale) at++;
  while (at < SCALES.length - 1 && tangentialSpeed > SCALES[at]!) at++;
  while (at > 0 && tangentialSpeed < ROOM_TO_SHRINK * SCALES[at - 1]!) at--;
  out.scale = SCALES[at]!;
}
