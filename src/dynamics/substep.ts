import { actuate } from './actuators/actuators';
import { swapPositions, fly } from './contact/flight';
import { moveOnGround } from './contact/forces';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_END_ATTITUDE,
  BODY_STRIDE,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  NO_EVENT,
  REFERENCE_BODY,
  SHIP_CLASS,
  SURFACE_STATE,
  TIPPED,
} from './state/layout';
import {
  BODY_RADIUS,
  DISTANCE_SQUARED,
  DT,
  GRAVITY_PARAMETER,
  GROUND_SPIN,
  LIFT,
  MASS,
  PENETRATION,
  quantities,
  SMI_MASK,
  START_PENETRATION,
  step,
  STEP_BODY,
  STEP_CLASS,
} from './contact/quantities';
import { restOnSide } from './contact/rest';
import { turnAttitudeWithGround, turnPlaceWithGround } from './arithmetic/rotations';
import { turnByTorque } from './contact/spin';
import { readSurface } from './contact/surface';
import { makeTransition } from './contact/transitions';
import type { World } from './constants/world';

/**
 * One substep of one ship, in the order of DYNAMICS ("One substep").
 * @param ships rows; the one at `at` is changed
 * @param bodies rows, turned for this substep by `turnBodies` (step 7)
 * @param dt game seconds, at most the settings' contactLongestSubstep
 * @returns the ship's event, an index into EVENT_NAMES
 */
export function substep(
  ships: Float64Array,
  at: number,
  bodies: Float64Array,
  world: World,
  dt: number,
): number {
  if (ships[at + CRASHED] === 1) return NO_EVENT; // 0
  begin(ships, at, bodies, world, dt);
  return stepShip();
}

/** Steps 1 to 9. */
function stepShip(): number {
  const { ships } = step;
  const at = step.at & SMI_MASK;
  actuate(); // 1
  if (!launches() && ships[at + SURFACE_STATE] === LANDED) return stayLanded(); // 2
  return ships[at + SURFACE_STATE] === FLYING ? flySubstep() : groundSubstep();
}

/** Steps 5 to 9 in flight. */
function flySubstep(): number {
  const q = quantities;
  fly(); // 5
  turnByTorque(false); // 6
  readSurface(BODY_END_ATTITUDE, false);
  return q[PENETRATION]! > 0 ? meetGround() : NO_EVENT; // 9
}

/** Step 9 of a flying ship that is in the ground. Its penetration at the start is read only now: most flying ships do not touch. */
function meetGround(): number {
  const q = quantities;
  swapPositions();
  readSurface(BODY_ATTITUDE, false);
  q[START_PENETRATION] = q[PENETRATION]!;
  swapPositions();
  readSurface(BODY_END_ATTITUDE, true);
  return makeTransition();
}

/** Steps 3 to 9 in contact or tipped. */
function groundSubstep(): number {
  const q = quantities;
  const { ships } = step;
  const at = step.at & SMI_MASK;
  readSurface(BODY_ATTITUDE, false);
  q[START_PENETRATION] = q[PENETRATION]!;
  const pinned = moveOnGround(); // 3, 4, 5
  turnByTorque(q[START_PENETRATION] > 0); // 6
  if (pinned) turnPlaceWithGround(); // 8
  readSurface(BODY_END_ATTITUDE, true);
  if (ships[at + SURFACE_STATE] === TIPPED) restOnSide(); // 8
  return makeTransition(); // 9
}

function begin(ships: Float64Array, at: number, bodies: Float64Array, world: World, dt: number): void {
  const q = quantities;
  step.ships = ships;
  step.at = at;
  step.bodies = bodies;
  if (
    step.world !== world ||
    q[STEP_BODY] !== ships[at + REFERENCE_BODY] ||
    q[STEP_CLASS] !== ships[at + SHIP_CLASS]
  )
    readWorld(world);
  q[DT] = dt;
  const spin = (step.bodyAt + BODY_ANGULAR_VELOCITY) & SMI_MASK;
  q[GROUND_SPIN] = bodies[spin]!;
  q[GROUND_SPIN + 1] = bodies[spin + 1]!;
  q[GROUND_SPIN + 2] = bodies[spin + 2]!;
}

/** Fills `step` with the constants of the world for a ship of this class over this body; kept until one of the three changes. */
function readWorld(world: World): void {
  const q = quantities;
  const { ships, at } = step;
  const reference = ships[at + REFERENCE_BODY]!;
  q[STEP_BODY] = reference;
  const shipClass = ships[at + SHIP_CLASS]!;
  q[STEP_CLASS] = shipClass;
  step.world = world;
  step.bodyAt = reference * BODY_STRIDE;
  const body = world.bodies[reference]!;
  step.body = body;
  q[BODY_RADIUS] = body.radius;
  q[GRAVITY_PARAMETER] = body.gravityParameter;
  step.shipClass = world.shipClasses[shipClass]!.constants;
  step.settings = world.settings.constants;
  step.terrainHeight = world.terrainHeight;
}

/** Step 2: a landed or tipped ship launches if lift exceeds weight, and flies for the rest of the substep. */
function launches(): boolean {
  const q = quantities;
  const { ships, at } = step;
  const state = ships[at + SURFACE_STATE]!;
  if (!(q[LIFT]! > 0) || (state !== LANDED && state !== TIPPED)) return false;
  if (!(q[LIFT]! > q[MASS]! * (q[GRAVITY_PARAMETER]! / q[DISTANCE_SQUARED]!))) return false;
  ships[at + SURFACE_STATE] = FLYING;
  ships[at + IMPACT_SPEED] = 0;
  return true;
}

/** A ship that stays landed only rotates with the ground. */
function stayLanded(): number {
  turnPlaceWithGround();
  turnAttitudeWithGround();
  return NO_EVENT;
}
