import {
  FLYING,
  GROUND_CONTACT_OFFSET,
  HEIGHT,
  LEG_RADIUS,
  REFERENCE_BODY,
  type LoadedShipClass,
  SURFACE_STATE,
} from '../../dynamics';
import { groundDirection, writeGroundRadius } from './snap/drawnGround';
import { hullOfShip, LEGS } from './snap/hull';
import { pose } from './pose';
import { measure, rotateBack, relativeRotation } from './rotation';
import { createGroundedPose, type GroundPose, snapToGround, type GroundedPose } from './snap/groundSnap';
import type { LevelGround } from './snap/levelSnap';
import type { ViewContext } from './viewContext';
import type { Track } from '../simulation/track';
import type { ShipView } from './view';

/** The server's newest state as a ghost, in the body's axes, so that it turns with the body. */
export function fillGhost(out: ShipView, { serverBodyAttitude }: Track): void {
  rotateBack(out.ghostPosition, serverBodyAttitude, out.serverPosition);
  relativeRotation(out.ghostAttitude, serverBodyAttitude, out.serverAttitude);
}

/**
 * The ghost is put on the drawn ground by the same function as the ship itself (PREDICTION, Drawing), because a
 * tipped ship's ghost would hover.
 * @param exactly true: point by point, like the ship itself; false: as on level ground
 */
export function groundGhost(
  out: ShipView,
  track: Track,
  { world, ground: drawn, features }: ViewContext,
  exactly: boolean,
): void {
  const body = world.bodies[track.serverRow[REFERENCE_BODY]!]!;
  ghost.position.set(out.ghostPosition);
  ghost.attitude.set(out.ghostAttitude);
  ghost.grounded = track.serverRow[SURFACE_STATE] !== FLYING;
  shape.shipClass = out.shipClass;
  shape.groundContactOffset = track.serverRow[GROUND_CONTACT_OFFSET]!;
  const { position } = ghost;
  measure(length, position);
  const distance = length[0]!;
  for (let k = 0; k < 3; k++) up[k] = position[k]! / distance;
  drawn.bodyName = body.name;
  drawn.radius = body.radius;
  writeGroundRadius(up, drawn);
  ground.radius = up[HEIGHT]!;
  const { places, reading } = track.ground;
  ghost.groundOffset =
    reading === null || places.length === 0 ? 0 : reading.offsetAt(places, body.name, up[0]!, up[1]!, up[2]!);
  // Too high to touch the ground, as for the ship itself.
  const reach = 2 * shape.groundContactOffset + out.shipClass.constants[LEG_RADIUS]!;
  if (distance - ground.radius > reach) return;
  if (exactly || features.snapToLevel === undefined)
    snapToGround(groundedPose, ghost, hullOfShip(shape), drawn);
  else features.snapToLevel(groundedPose, ghost, hullOfShip(shape), ground);
  out.ghostPosition.set(groundedPose.position);
}

const ghost: GroundPose = { ...pose(), grounded: false, groundOffset: 0 };
const length = new Float64Array(1);
/** The local up, and the radius of the ground there. */
const up = groundDirection();
const ground: LevelGround = { radius: 0 };
const shape = { groundContactOffset: 0 } as { shipClass: LoadedShipClass; groundContactOffset: number };
const groundedPose: GroundedPose = createGroundedPose(LEGS);
