import type { Hull } from './hull';
import { measure, rotateBack, vector } from '../rotation';
import { drawnClearance, type GroundPose, type GroundedPose } from './groundSnap';

/** A record, since a double as an argument is boxed at each call. */
export interface LevelGround {
  /** m from the body's centre, under the whole ship. */
  radius: number;
}

/**
 * snapToGround for ground that is level under the whole ship, at a tenth of the cost: for the
 * many ships that are drawn small. On a slope its error is the slope's over the ship's extent.
 */
export function snapToLevel(
  out: GroundedPose,
  pose: GroundPose,
  hull: Hull,
  ground: LevelGround,
): GroundedPose {
  const { position, attitude } = pose;
  const { feet, outline } = hull;
  measure(length, position);
  const distance = length[0]!;
  for (let k = 0; k < 3; k++) up[k] = position[k]! / distance;
  rotateBack(seenUp, attitude, up);
  const x = seenUp[0]!;
  const y = seenUp[1]!;
  const z = seenUp[2]!;
  const centre = distance - ground.radius;
  let lowestFoot = Number.POSITIVE_INFINITY;
  let lowest = Number.POSITIVE_INFINITY;
  for (let i = 0; i < feet.length; i += 3) {
    const height = centre + feet[i]! * x + feet[i + 1]! * y + feet[i + 2]! * z;
    const over = height - pose.groundOffset;
    if (over < lowestFoot) lowestFoot = over;
    const travel = z > 0.1 && over < 0 ? -over / z : 0;
    const pressed = travel > hull.stroke ? hull.stroke : travel;
    out.legCompression[i / 3] = pressed;
    if (height + pressed * z < lowest) lowest = height + pressed * z;
  }
  for (let i = 0; i < outline.length; i += 3) {
    const height = centre + outline[i]! * x + outline[i + 1]! * y + outline[i + 2]! * z;
    if (height < lowest) lowest = height;
  }
  out.feetHeight = lowestFoot;
  out.lift = (pose.grounded ? 0 : drawnClearance(lowest, centre + feet[2]!, pose.groundOffset)) - lowest;
  for (let k = 0; k < 3; k++) out.position[k] = position[k]! + up[k]! * out.lift;
  return out;
}

const length = new Float64Array(1);
const up = vector();
const seenUp = vector();
