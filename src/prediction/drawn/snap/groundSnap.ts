import { HEIGHT } from '../../../dynamics';
import { type DrawnGround, groundDirection, writeGroundRadius } from './drawnGround';
import type { Hull } from './hull';
import { rotate, vector } from '../rotation';

/** A pose to be put on the ground: position (m, from the body's centre) and attitude, both in the body's axes. */
export interface GroundPose {
  readonly position: Float64Array;
  readonly attitude: Float64Array;
  /** In contact, tipped or landed. */
  grounded: boolean;
  /** The ground that the pose is predicted on, above the drawn one, m: 0 where the server's ground is the drawn one. */
  groundOffset: number;
}

export interface GroundedPose {
  /** m, from the body's centre, in the body's axes; the attitude stays. */
  readonly position: Float64Array;
  /** Along the local up, m; negative where a tipped ship is lowered. */
  lift: number;
  /** m, one per leg, 0 … stroke. */
  readonly legCompression: Float64Array;
  /** Height of the lowest unloaded foot of the pose as given, above the ground it is predicted on, m. */
  feetHeight: number;
}

export function createGroundedPose(legs: number): GroundedPose {
  return { position: new Float64Array(3), lift: 0, legCompression: new Float64Array(legs), feetHeight: 0 };
}

/** Rounds of lifting: on a slope the lift changes the ground beneath each point. */
const ROUNDS = 3;
/** m: closer than this is touching. */
const TOUCHING = 1e-4;
/** m */
const RELEASE_HEIGHT = 1;
/** In offsets between predicted and drawn ground: from this height on, a flying ship is drawn as predicted. */
const FADE_HEIGHTS = 8;

/**
 * Puts a drawn pose on the drawn ground (PREDICTION, Drawing). The dynamics keep the centre of mass at height h at any
 * tilt, and let impacts sink. Drawn as is, a tipped ship would hover and a landing one would go underground. So the legs give way
 * first, up to their stroke; then the whole ship is lifted along the local up until no point of hull or feet is below the ground,
 * and a grounded one is let down until its lowest point touches.
 * @param out the grounded pose
 * @param pose as drawn
 */
export function snapToGround(
  out: GroundedPose,
  pose: GroundPose,
  hull: Hull,
  ground: DrawnGround,
): GroundedPose {
  out.position.set(pose.position);
  const { position } = pose;
  // Here, not by a function: the double that one returns is boxed.
  const distance = Math.sqrt(
    position[0]! * position[0]! + position[1]! * position[1]! + position[2]! * position[2]!,
  );
  for (let k = 0; k < 3; k++) up[k] = position[k]! / distance;
  pressLegs(out, pose, hull, ground);
  out.lift = 0;
  findLowest(out, pose, hull, ground);
  let clearance = lowest[0]!;
  writeGroundRadius(up, ground);
  const height = distance - up[HEIGHT]! + hull.feet[2]!;
  const target = pose.grounded ? 0 : drawnClearance(clearance, height, pose.groundOffset);
  for (let round = 0; round < ROUNDS && Math.abs(target - clearance) > TOUCHING; round++) {
    const lift = target - clearance;
    out.lift += lift;
    for (let k = 0; k < 3; k++) out.position[k] = out.position[k]! + up[k]! * lift;
    findLowest(out, pose, hull, ground);
    clearance = lowest[0]!;
  }
  return out;
}

/** Presses each leg in as far as its foot is below the ground, up to the stroke; writes the lowest foot's height. */
function pressLegs(out: GroundedPose, pose: GroundPose, hull: Hull, ground: DrawnGround): void {
  rotate(axis, pose.attitude, ALONG);
  // Share of a leg's travel that changes the height: 0 for a ship on its side.
  const upright = axis[0]! * up[0]! + axis[1]! * up[1]! + axis[2]! * up[2]!;
  let lowestFoot = Number.POSITIVE_INFINITY;
  for (let leg = 0; leg * 3 < hull.feet.length; leg++) {
    for (let k = 0; k < 3; k++) point[k] = hull.feet[leg * 3 + k]!;
    writeHeight(point, out.position, pose.attitude, ground);
    const height = point[HEIGHT]! - pose.groundOffset;
    if (height < lowestFoot) lowestFoot = height;
    const travel = upright > 0.1 && height < 0 ? -height / upright : 0;
    out.legCompression[leg] = travel > hull.stroke ? hull.stroke : travel;
  }
  out.feetHeight = lowestFoot;
}

/** Writes the height of the lowest point of hull and pressed legs above the ground, m, to `lowest`. */
function findLowest(out: GroundedPose, pose: GroundPose, hull: Hull, ground: DrawnGround): void {
  let least = Number.POSITIVE_INFINITY;
  for (let leg = 0; leg * 3 < hull.feet.length; leg++) {
    for (let k = 0; k < 3; k++) point[k] = hull.feet[leg * 3 + k]!;
    point[2] = point[2]! + out.legCompression[leg]!;
    writeHeight(point, out.position, pose.attitude, ground);
    if (point[HEIGHT]! < least) least = point[HEIGHT]!;
  }
  for (let i = 0; i < hull.outline.length; i += 3) {
    for (let k = 0; k < 3; k++) point[k] = hull.outline[i + k]!;
    writeHeight(point, out.position, pose.attitude, ground);
    if (point[HEIGHT]! < least) least = point[HEIGHT]!;
  }
  lowest[0] = least;
}

/**
 * The clearance, m, at which a flying ship is drawn that is predicted above ground `offset` m higher than drawn: its own
 * high up, and 0 at touchdown, so that the ship reaches the drawn ground without a jump.
 * @param clearance of its lowest point above the drawn ground, m
 * @param height of the centre of mass above its height at contact with the drawn ground, m
 */
export function drawnClearance(clearance: number, height: number, offset: number): number {
  const above = clearance - offset;
  const over = height - offset;
  const target = above < 0 ? 0 : flyingTarget(above, over);
  if (offset === 0) return target;
  const reach = Math.max(RELEASE_HEIGHT, FADE_HEIGHTS * Math.abs(offset));
  const t = over <= 0 ? 0 : over >= reach ? 1 : over / reach;
  return Math.max(0, target + offset * (t * t * (3 - 2 * t)));
}

/**
 * The clearance, m, at which a flying ship is drawn: its own, except just after a tipped ship has left the ground. Its lowest point is
 * higher than an upright ship's, so it rises from the ground over the first metre instead of popping up.
 * @param height of the centre of mass above its height at contact, m
 */
function flyingTarget(clearance: number, height: number): number {
  const hovering = clearance - (height > 0 ? height : 0);
  if (hovering <= 0 || height >= RELEASE_HEIGHT) return clearance;
  return clearance - hovering * (height <= 0 ? 1 : 1 - height / RELEASE_HEIGHT);
}

/** Writes the height above the ground, m, of the point in ship axes `p` to p[HEIGHT]; the point is overwritten. */
function writeHeight(
  p: Float64Array,
  position: Float64Array,
  attitude: Float64Array,
  ground: DrawnGround,
): void {
  rotate(p, attitude, p);
  const x = p[0]! + position[0]!;
  const y = p[1]! + position[1]!;
  const z = p[2]! + position[2]!;
  const distance = Math.sqrt(x * x + y * y + z * z);
  p[0] = x / distance;
  p[1] = y / distance;
  p[2] = z / distance;
  writeGroundRadius(p, ground);
  p[HEIGHT] = distance - p[HEIGHT]!;
}

const ALONG = Float64Array.of(0, 0, 1);
/** The local up, and the radius of the ground there. */
const up = groundDirection();
const axis = vector();
/** A point of the ship, and its height. */
const point = groundDirection();
const lowest = new Float64Array(1);
