import { actuate, commandsThrust } from './actuators/actuators';
import { fly } from './contact/flight';
import { moveOnGround, press } from './contact/forces';
import {
  BODY_ANGULAR_VELOCITY,
  BODY_AXES,
  BODY_END_AXES,
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
import { addGroundMoments } from './contact/moments';
import { readAxes } from './contact/pose';
import { copyIn, copyOut } from './state/rowCopy';
import {
  DT,
  end,
  GRAVITY,
  GROUND_SPIN,
  LIFT,
  MASS,
  NORMAL_FORCE,
  PENETRATION,
  quantities,
  SMI_MASK,
  start,
  type Step,
  STEP_BODY,
  STEP_CLASS,
  WEIGHT,
} from './contact/quantities';
import { restOnSide } from './contact/rest';
import { turnAttitudeWithGround, turnPlaceWithGround } from './arithmetic/rotations';
import { turnByTorque } from './contact/spin';
import { readPlace, readSurface } from './contact/surface';
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
  const event = stepShip(step);
  copyOut(ships, at);
  return event;
}

/** Steps 1 to 9 on the row in `quantities`. */
function stepShip(step: Step): number {
  const q = quantities;
  if (q[SURFACE_STATE] === LANDED && !commandsThrust()) return stayLanded(step); // 1, 2: without thrust there is no lift
  readAxes();
  readPlace(start, step);
  actuate(step); // 1
  if (!launches() && q[SURFACE_STATE] === LANDED) return stayLanded(step); // 2
  return q[SURFACE_STATE] === FLYING ? flySubstep(step) : groundSubstep(step);
}

/** Steps 5 to 9 in flight. */
function flySubstep(step: Step): number {
  fly(step); // 5
  turnByTorque(step); // 6
  readSurface(end, step, BODY_END_AXES, false);
  if (!(end[PENETRATION]! > 0)) return NO_EVENT; // 9
  readSurface(start, step, BODY_AXES, false);
  return makeTransition(step); // 9
}

/** Steps 3 to 9 in contact or tipped. */
function groundSubstep(step: Step): number {
  const q = quantities;
  readSurface(start, step, BODY_AXES, false);
  const inGround = start[PENETRATION]! > 0;
  const pinned = inGround && press(step); // 3, 4
  if (!inGround) q[NORMAL_FORCE] = 0;
  if (!pinned) moveOnGround(step); // 5
  if (inGround) addGroundMoments(step); // 6
  turnByTorque(step); // 6
  if (pinned) turnPlaceWithGround(step); // 8
  readPlace(end, step);
  readSurface(end, step, BODY_END_AXES, true);
  if (q[SURFACE_STATE] === TIPPED) restOnSide(step); // 8
  return makeTransition(step); // 9
}

const step: Step = { at: 0, bodies: new Float64Array(0), bodyAt: 0 } as Step;

function begin(ships: Float64Array, at: number, bodies: Float64Array, world: World, dt: number): void {
  copyIn(ships, at);
  const q = quantities;
  step.at = at;
  step.bodies = bodies;
  if (step.world !== world || q[STEP_BODY] !== q[REFERENCE_BODY] || q[STEP_CLASS] !== q[SHIP_CLASS])
    readWorld(world);
  q[DT] = dt;
  const spin = (step.bodyAt + BODY_ANGULAR_VELOCITY) & SMI_MASK;
  q[GROUND_SPIN] = bodies[spin]!;
  q[GROUND_SPIN + 1] = bodies[spin + 1]!;
  q[GROUND_SPIN + 2] = bodies[spin + 2]!;
}

/** Fills `step` with what a ship of this class over this body reads of a world. It is kept until one of the three changes. */
function readWorld(world: World): void {
  const q = quantities;
  const reference = q[REFERENCE_BODY]!;
  q[STEP_BODY] = reference;
  const shipClass = q[SHIP_CLASS]!;
  q[STEP_CLASS] = shipClass;
  step.world = world;
  step.bodyAt = reference * BODY_STRIDE;
  step.body = world.bodies[reference]!;
  step.shipClass = world.shipClasses[shipClass]!.constants;
  step.settings = world.settings.constants;
  step.terrainHeight = world.terrainHeight;
}

/** Step 2: a landed or tipped ship launches if lift exceeds weight, and flies for the rest of the substep. */
function launches(): boolean {
  const q = quantities;
  const state = q[SURFACE_STATE]!;
  q[WEIGHT] = q[MASS]! * start[GRAVITY]!;
  if ((state !== LANDED && state !== TIPPED) || !(q[LIFT]! > q[WEIGHT])) return false;
  q[SURFACE_STATE] = FLYING;
  q[IMPACT_SPEED] = 0;
  return true;
}

/** A ship that stays landed only rotates with the ground. */
function stayLanded(step: Step): number {
  turnPlaceWithGround(step);
  turnAttitudeWithGround(step);
  return NO_EVENT;
}
