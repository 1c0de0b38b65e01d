import { HEIGHT, LEG_RADIUS } from '../../dynamics';
import type { Track } from '../simulation/track';
import { groundDirection, writeGroundRadius } from './snap/drawnGround';
import { createGroundedPose, type GroundedPose, snapToGround } from './snap/groundSnap';
import { hullOfShip, LEGS } from './snap/hull';
import type { LevelGround } from './snap/levelSnap';
import { measure, rotate } from './rotation';
import type { ViewContext } from './viewContext';
import type { ShipView } from './view';

/** A ship and the ground below it, as predicted and as drawn. */

/** The server's ground below the ship, as learned, and its height above the drawn one. */
export function fillGround(out: ShipView, track: Track, context: ViewContext): void {
  const { world, ground, at, normal, drawn } = context;
  const body = world.bodies[out.body]!;
  const { picture } = track;
  const { places, reading } = track.ground;
  ground.bodyName = body.name;
  ground.radius = body.radius;
  for (let k = 0; k < 3; k++) up[k] = normal[k]!;
  writeGroundRadius(up, ground);
  out.groundRadius = up[HEIGHT]!;
  fillGroundNormal(out, context);
  out.groundOffset = 0;
  out.groundConfidence = 0;
  drawn.groundOffset = 0;
  if (reading === null || places.length === 0) return;
  out.groundOffset = reading.offsetAt(places, body.name, normal[0]!, normal[1]!, normal[2]!);
  out.groundConfidence = reading.confidenceAt(track.ground, body.name, normal);
  out.groundRadius += out.groundOffset;
  // In flight, newly learned ground moves the mesh no faster than a correction.
  const follows = out.surfaceContactState === '' ? 1 - Math.exp(-OFFSET_RATE * at.elapsed) : 1;
  picture.groundOffset += (out.groundOffset - picture.groundOffset) * follows;
  drawn.groundOffset = picture.groundOffset;
}

const up = groundDirection();
/** 1/s */
const OFFSET_RATE = 10;

/** The surface normal below its feet, as the settings define it. */
function fillGroundNormal(out: ShipView, context: ViewContext): void {
  const normal = context.features.slopeBelow?.(out, context) ?? context.normal;
  rotate(out.groundNormal, context.bodyAttitudes[out.body]!, normal);
}

/**
 * Puts the mesh on the drawn ground if the ground is near.
 * @returns whether point by point, or as on level ground
 */
export function fillGrounded(out: ShipView, context: ViewContext, bodyAttitude: Float64Array): boolean {
  const { drawn, distance } = context;
  const legRadius = out.shipClass.constants[LEG_RADIUS]!;
  const { snapToLevel } = context.features;
  const exactly = snapToLevel === undefined || out.own || context.exactSnaps > 0;
  const surface = out.groundRadius - out.groundOffset;
  measure(drawnDistance, drawn.position);
  const above = drawnDistance[0]! - surface;
  // Beyond twice its height no part of the ship can touch the ground.
  const reach = FAR * (out.groundContactOffset + Math.abs(out.groundOffset) * REACH) + legRadius;
  if (above > reach) {
    for (let k = 0; k < 3; k++) out.meshPosition[k] = out.easedPosition[k]!;
    for (let leg = 0; leg < LEGS; leg++) out.legCompression[leg] = 0;
    out.feetHeight = distance[0]! - out.groundRadius - out.groundContactOffset;
    return exactly;
  }
  drawn.grounded = out.surfaceContactState !== '';
  if (exactly) {
    context.exactSnaps -= 1;
    snapToGround(groundedPose, drawn, hullOfShip(out), context.ground);
  } else {
    level.radius = surface;
    snapToLevel(groundedPose, drawn, hullOfShip(out), level);
  }
  rotate(out.meshPosition, bodyAttitude, groundedPose.position);
  for (let leg = 0; leg < LEGS; leg++) out.legCompression[leg] = groundedPose.legCompression[leg]!;
  out.feetHeight = groundedPose.feetHeight;
  return exactly;
}

const FAR = 2;
/** In offsets between the two grounds: at FAR times this height the mesh no longer follows the offset. */
const REACH = 4.5;
const drawnDistance = new Float64Array(1);
const level: LevelGround = { radius: 0 };
const groundedPose: GroundedPose = createGroundedPose(LEGS);
