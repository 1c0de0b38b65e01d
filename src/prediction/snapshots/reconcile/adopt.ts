import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  ATTITUDE_HOLD,
  ATTITUDE_MODE,
  attitudeModeOf,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  CRASHED,
  FLYING,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  LANDED,
  modeNumber,
  POSITION,
  REFERENCE_BODY,
  ROTATION_INPUT,
  SHIP_CLASS,
  SURFACE_STATE,
  SURFACE_STATES,
  TARGET_ATTITUDE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  VELOCITY,
  WHEEL_MOMENTUM,
  type World,
} from '../../../dynamics';
import type { ShipState } from '../../../wire';

/**
 * Writes a ShipState as a row (PREDICTION, Server messages) and completes omitted fields: the relative
 * state from ICRF, the reference body from the body landed on or the nearest in radii, the surface state from `landedBodyName`.
 * IMPACT_SPEED and WHEEL_MOMENTUM are NaN if the server does not send them: only the ship's own history has them.
 * @param row one ship's row; unchanged if a reason is returned
 * @param bodies the bodies' rows at the state's tick
 * @returns null, or the reason, naming the field, why the state cannot be used
 */
export function adopt(
  row: Float64Array,
  state: ShipState,
  bodies: Float64Array,
  world: World,
): string | null {
  const unknown = unknownNameOf(state, world);
  if (unknown !== null) return unknown;
  const shipClass = indexOfName(world.shipClasses, state.shipClass);
  const bodyName = state.referenceBody !== '' ? state.referenceBody : state.landedBodyName;
  const body = bodyName !== '' ? indexOfName(world.bodies, bodyName) : nearestBody(state, bodies, world);
  if (body < 0) return `referenceBody: no body named ${bodyName}`;
  if (tooNearCentre(state, bodies, body)) return 'position: expected ≥ 1 m from the body’s centre';

  writePlace(row, state, bodies, body);
  for (let k = 0; k < 4; k++) row[ATTITUDE + k] = state.attitude[k]!;
  for (let k = 0; k < 3; k++) row[ANGULAR_VELOCITY + k] = state.angularVelocity[k]!;
  row[FUEL] = state.fuel;
  for (let k = 0; k < 3; k++) row[WHEEL_MOMENTUM + k] = state.wheelMomentum?.[k] ?? Number.NaN;
  row[GROUND_CONTACT_OFFSET] = state.groundContactOffset ?? world.shipClasses[shipClass]!.groundContactOffset;
  const named = indexIn(SURFACE_STATES, state.surfaceContactState);
  const surface = named === FLYING && state.landedBodyName !== '' ? LANDED : named;
  row[SURFACE_STATE] = state.crashed ? FLYING : surface;
  row[IMPACT_SPEED] = surface === FLYING ? 0 : (state.contactImpactSpeed ?? Number.NaN);
  row[REFERENCE_BODY] = body;
  row[CRASHED] = state.crashed ? 1 : 0;
  row[SHIP_CLASS] = shipClass;
  writeCommand(row, state);
  return null;
}

/** Why a state can be drawn but not predicted: an unknown class or surface state. Null otherwise. */
export function unknownNameOf({ shipClass, surfaceContactState }: ShipState, world: World): string | null {
  if (indexOfName(world.shipClasses, shipClass) < 0) return `shipClass: no class named ${shipClass}`;
  if (indexIn(SURFACE_STATES, surfaceContactState) < 0)
    return `surfaceContactState: no state named ${surfaceContactState}`;
  return null;
}

/** The state with unknown values replaced by ones that can be drawn: the first class, no contact. */
export function drawableState(state: ShipState, world: World): ShipState {
  const known = indexOfName(world.shipClasses, state.shipClass) >= 0;
  return {
    ...state,
    shipClass: known ? state.shipClass : world.shipClasses[0]!.name,
    surfaceContactState:
      indexIn(SURFACE_STATES, state.surfaceContactState) < 0 ? '' : state.surfaceContactState,
  };
}

/** Whether the server sent the relative state; otherwise it is a difference of ICRF positions. */
export function isExact(state: ShipState): boolean {
  return state.relativePosition !== null && state.relativeVelocity !== null;
}

function writePlace(row: Float64Array, state: ShipState, bodies: Float64Array, body: number): void {
  const { relativePosition, relativeVelocity, position, velocity } = state;
  const at = body * BODY_STRIDE;
  for (let k = 0; k < 3; k++) {
    if (relativePosition !== null) row[POSITION + k] = relativePosition[k]!;
    else row[POSITION + k] = position[k]! - bodies[at + BODY_POSITION + k]!;
    if (relativeVelocity !== null) row[VELOCITY + k] = relativeVelocity[k]!;
    else row[VELOCITY + k] = velocity[k]! - bodies[at + BODY_VELOCITY + k]!;
  }
}

function writeCommand(row: Float64Array, state: ShipState): void {
  row[THRUST_LEVEL] = state.thrustLevel;
  for (let k = 0; k < 3; k++) row[TRANSLATION_INPUT + k] = state.translationInput[k]!;
  for (let k = 0; k < 3; k++) row[ROTATION_INPUT + k] = state.rotationInput[k]!;
  row[ATTITUDE_HOLD] = state.attitudeHold ? 1 : 0;
  row[ATTITUDE_MODE] = modeNumber(attitudeModeOf(state.attitudeMode));
  for (let k = 0; k < 4; k++) row[TARGET_ATTITUDE + k] = state.targetAttitude[k]!;
}

/** The body with the smallest distance / radius; ties go to the one listed first (DYNAMICS, Frame). */
function nearestBody(state: ShipState, bodies: Float64Array, world: World): number {
  let best = -1;
  let nearest = Infinity;
  for (let i = 0; i < world.bodies.length; i++) {
    const { radius } = world.bodies[i]!;
    const measure = distanceSquared(state, bodies, i) / (radius * radius);
    if (measure < nearest) {
      nearest = measure;
      best = i;
    }
  }
  return best;
}

/** Within a metre of the centre the radial direction is undefined. */
function tooNearCentre(state: ShipState, bodies: Float64Array, body: number): boolean {
  const given = state.relativePosition;
  if (given === null) return !(distanceSquared(state, bodies, body) >= 1);
  return !(given[0] * given[0] + given[1] * given[1] + given[2] * given[2] >= 1);
}

function distanceSquared(state: ShipState, bodies: Float64Array, body: number): number {
  const at = body * BODY_STRIDE + BODY_POSITION;
  const x = state.position[0] - bodies[at]!;
  const y = state.position[1] - bodies[at + 1]!;
  const z = state.position[2] - bodies[at + 2]!;
  return x * x + y * y + z * z;
}

/** The index of a name, or −1. */
function indexIn(names: readonly string[], name: string): number {
  return names.indexOf(name);
}

function indexOfName(named: readonly { readonly name: string }[], name: string): number {
  for (let i = 0; i < named.length; i++) if (named[i]!.name === name) return i;
  return -1;
}
