/**
 * Angle of a vector by + − × ÷ and a polynomial: the same bits in every language (ORDER, Heightmap). The error is below 6e-16 rad.
 */

/** Minimax polynomial of atan(x) / x in x², on 0 … tan²(π/8). */
const C1 = -0.3333333333332844;
const C2 = 0.19999999998855109;
const C3 = -0.14285714180976392;
const C4 = 0.11111106180452865;
const C5 = -0.0909077307473686;
const C6 = 0.07689953495298942;
const C7 = -0.06640233921673451;
const C8 = 0.056883491809884175;
const C9 = -0.04348052083340628;
const C10 = 0.021135371536498415;

const PI = 3.141592653589793;
const HALF_PI = 1.5707963267948966;
const QUARTER_PI = 0.7853981633974483;
/** tan(π/8) */
const SPLIT = 0.41421356237309503;

/** Argument and result of angleOf, in scratch doubles so that none is boxed (see quantities.ts). */
export const arc = new Float64Array(3);
export const ARC_Y = 0;
export const ARC_X = 1;
export const ARC_ANGLE = 2;

/** arc[ARC_ANGLE] = angle from the x axis to (x, y), rad, −π … π; 0 for the zero vector. x and y must be finite. */
export function angleOf(): void {
  const y = arc[ARC_Y]!;
  const x = arc[ARC_X]!;
  const ax = x < 0 ? -x : x;
  const ay = y < 0 ? -y : y;
  const larger = ay > ax ? ay : ax;
  const smaller = ay > ax ? ax : ay;
  if (larger === 0) {
    arc[ARC_ANGLE] = 0;
    return;
  }
  const isSteep = smaller > SPLIT * larger;
  const reduced = isSteep ? (smaller - larger) / (smaller + larger) : smaller / larger;
  const u = reduced * reduced;
  const high = C6 + u * (C7 + u * (C8 + u * (C9 + u * C10)));
  const low = C1 + u * (C2 + u * (C3 + u * (C4 + u * (C5 + u * high))));
  const small = reduced + reduced * (u * low);
  const octant = isSteep ? QUARTER_PI + small : small;
  const quadrant = ay > ax ? HALF_PI - octant : octant;
  const half = x < 0 ? PI - quadrant : quadrant;
  arc[ARC_ANGLE] = y < 0 ? -half : half;
}
