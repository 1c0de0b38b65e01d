import {
  FLYING,
  GROUND_CONTACT_OFFSET,
  REFERENCE_BODY,
  type LoadedShipClass,
  SURFACE_STATE,
  type World,
} from '../../dynamics';
import { type DrawnGround, groundRadius } from './snap/drawnGround';
import { hullOfShip, LEGS } from './snap/hull';
import { pose } from './pose';
import { lengthOf, rotateBack, seenFrom } from './rotation';
import { createGroundedPose, type GroundPose, snapToGround, type GroundedPose } from './snap/groundSnap';
import { type LevelGround, snapToLevel } from './snap/levelSnap';
import type { Track } from '../simulation/track';
import type { ShipView } from './view';

/**
 * The server's newest state as a ghost: put on the drawn ground by the same function as the ship itself (PREDICTION, Drawing), because a
 * tipped ship's ghost would hover. In the body's axes, so that it turns with the body.
 * @param drawn the drawn ground
 * @param exactly true: point by point, like the ship itself; false: as on level ground
 */
export function fillGhost(
  out: ShipView,
  track: Track,
  world: World,
  drawn: DrawnGround,
  exactly: boolean,
): void {
  const body = world.bodies[track.serverRow[REFERENCE_BODY]!]!;
  rotateBack(ghost.position, track.serverBodyAttitude, out.serverPosition);
  seenFrom(ghost.attitude, track.serverBodyAttitude, out.serverAttitude);
  ghost.grounded = track.serverRow[SURFACE_STATE] !== FLYING;
  out.ghostPosition.set(ghost.position);
  out.ghostAttitude.set(ghost.attitude);
  shape.shipClass = out.shipClass;
  shape.groundContactOffset = track.serverRow[GROUND_CONTACT_OFFSET]!;
  const { position } = ghost;
  const distance = lengthOf(position);
  const nx = position[0]! / distance;
  const ny = position[1]! / distance;
  const nz = position[2]! / distance;
  drawn.bodyName = body.name;
  drawn.radius = body.radius;
  ground.radius = groundRadius(drawn, nx, ny, nz);
  const { places, reading } = track.ground;
  ghost.groundOffset = reading?.offsetAt(places, body.name, nx, ny, nz) ?? 0;
  // Too high to touch the ground, as for the ship itself.
  if (distance - ground.radius > 2 * shape.groundContactOffset + out.shipClass.legRadius) return;
  if (exactly) snapToGround(groundedPose, ghost, hullOfShip(shape), drawn);
  else snapToLevel(groundedPose, ghost, hullOfShip(shape), ground);
  out.ghostPosition.set(groundedPose.position);
}

const ghost: GroundPose = { ...pose(), grounded: false, groundOffset: 0 };
const ground: LevelGround = { radius: 0 };
const shape = { groundContactOffset: 0 } as { shipClass: LoadedShipClass; groundContactOffset: number };
const groundedPose: GroundedPose = createGroundedPose(LEGS);
