import { FLYING, REFERENCE_BODY, SURFACE_STATE, type World } from '../../dynamics';
import { groundRadius, layGround } from './drawnGround';
import { hullOf, LEGS } from './hull';
import { pose } from './pose';
import { lengthOf, rotateBack, seenFrom } from './rotation';
import { createGroundedPose, type GroundPose, snapToGround, type GroundedPose } from './groundSnap';
import { type LevelGround, snapToLevel } from './levelSnap';
import type { Track } from '../simulation/track';
import type { ShipView } from './view';

/**
 * The server's newest state as a ghost: stood on the drawn ground by the same function as the ship itself (PREDICTION, What is
 * drawn), or a lying ship's ghost would hover; in the body's axes, so that it stays where it was while the body turns.
 * @param exactly point by point, as the ship itself was stood; else as on level ground
 */
export function fillGhost(out: ShipView, track: Track, world: World, exactly: boolean): void {
  const body = world.bodies[track.serverRow[REFERENCE_BODY]!]!;
  rotateBack(ghost.position, track.serverBodyAttitude, out.serverPosition);
  seenFrom(ghost.attitude, track.serverBodyAttitude, out.serverAttitude);
  ghost.grounded = track.serverRow[SURFACE_STATE] !== FLYING;
  out.ghostPosition.set(ghost.position);
  out.ghostAttitude.set(ghost.attitude);
  const { shipClass } = out;
  const { position } = ghost;
  const distance = lengthOf(position);
  layGround(body, world.terrainHeight);
  ground.radius = groundRadius(position[0]! / distance, position[1]! / distance, position[2]! / distance);
  // Out of the ground's reach, as for the ship itself.
  if (distance - ground.radius > 2 * shipClass.groundContactOffset + shipClass.legRadius) return;
  if (exactly) snapToGround(groundedPose, ghost, hullOf(shipClass), groundRadius);
  else snapToLevel(groundedPose, ghost, hullOf(shipClass), ground);
  out.ghostPosition.set(groundedPose.position);
}

const ghost: GroundPose = { ...pose(), grounded: false };
const ground: LevelGround = { radius: 0 };
const groundedPose: GroundedPose = createGroundedPose(LEGS);
