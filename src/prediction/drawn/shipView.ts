import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CRASHED,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  MAIN_ENGINE_THRUST,
  NEUTRAL_CONTROLS,
  POSITION,
  RCS_THRUST,
  REFERENCE_BODY,
  SHIP_CLASS,
  SURFACE_STATES,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  VELOCITY,
  type World,
  WHEEL_MOMENTUM,
} from '../../dynamics';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import { spanOf } from '../time/timeline';
import { createTouchdownView } from '../touchdown/touchdownLog';
import { advanceEase } from './ease';
import { fillGhost } from './ghost';
import { LEGS } from './snap/hull';
import { fillGround, fillGrounded } from './onGround';
import { outOfStep } from './outOfStep';
import { writeAttitude } from './pose';
import {
  compose,
  fromRotationVector,
  measure,
  quaternion,
  rotate,
  rotateBack,
  relativeRotation,
  take,
  vector,
} from './rotation';
import type { ViewContext } from './viewContext';
import { fillControls, fillServerState, fillStatus, surfaceStateOf } from './status';
import type { ShipView } from './view';

export function createShipView(track: Track, world: World): ShipView {
  const vectors = () => new Float64Array(3);
  return {
    shipId: track.shipId,
    name: track.name,
    own: track.own,
    shipClass: world.shipClasses[0]!,
    body: 0,
    position: vectors(),
    velocity: vectors(),
    attitude: quaternion(),
    angularVelocity: vectors(),
    wheelMomentum: vectors(),
    fuel: 0,
    impactSpeed: 0,
    surfaceContactState: '',
    crashed: false,
    controls: NEUTRAL_CONTROLS,
    thrust: vectors(),
    groundRadius: 0,
    groundNormal: vectors(),
    groundContactOffset: 0,
    groundOffset: 0,
    groundConfidence: 0,
    extrapolated: '',
    extrapolatedStates: 0,
    easedPosition: vectors(),
    meshAttitude: quaternion(),
    meshPosition: vectors(),
    legCompression: new Float64Array(LEGS),
    feetHeight: 0,
    shownState: '',
    provenance: 'predicted',
    age: 0,
    withdrawn: '',
    touchdown: createTouchdownView(),
    serverPosition: vectors(),
    serverAttitude: quaternion(),
    ghostPosition: vectors(),
    ghostAttitude: quaternion(),
    serverKnown: false,
    missingSends: 0,
  };
}

/** Fills a ship's view: predicted state, drawn pose, ground, shown state. */
export function fillShipView(out: ShipView, sim: Simulation, track: Track, context: ViewContext): void {
  const stepping = track.mode === 'stepping';
  const { fleet, alpha } = sim;
  // The surface state at the present is that of the last substep boundary.
  const rows = stepping ? (alpha === 1 ? fleet.front : fleet.previous) : outOfStep(sim, track, context);
  const from = stepping ? track.at : 0;
  if (stepping) fillBetween(out, sim, track);
  else fillFromRow(out, rows);
  out.fuel = rows[from + FUEL]!;
  take(out.wheelMomentum, rows, from + WHEEL_MOMENTUM);
  out.impactSpeed = rows[from + IMPACT_SPEED]!;
  out.surfaceContactState = SURFACE_STATES[surfaceStateOf(track, rows, from)]!;
  out.crashed = rows[from + CRASHED] === 1;
  out.body = rows[from + REFERENCE_BODY]!;
  out.shipClass = context.world.shipClasses[rows[from + SHIP_CLASS]!]!;
  out.groundContactOffset = rows[from + GROUND_CONTACT_OFFSET]!;
  out.name = track.name;
  out.extrapolated = track.fit.extrapolated;
  out.extrapolatedStates = track.fit.states;
  out.own = track.own;
  out.missingSends = sim.cadence.sends - track.lastSend;
  const attitude = context.bodyAttitudes[out.body]!;
  rowToBodyAxes(out, context, attitude);
  if (track.picture.ease.active)
    advanceEase(
      track.picture.ease,
      context.normal,
      context.at.elapsed,
      context.springs,
      stepping ? Math.min(context.at.elapsed, sinceUprighting(sim, track)) : context.at.elapsed,
    );
  fillDrawn(out, track, context, attitude);
  fillGround(out, track, context);
  const exactly = fillGrounded(out, context, attitude);
  fillThrust(out, rows, from);
  fillControls(out, track.picture.status.commands, rows, from);
  if (fillServerState(out, track, context.at)) {
    fillGhost(out, track);
    context.features.groundGhost?.(out, track, context, exactly);
  }
  fillStatus(out, track, rows, from, context.at);
  if (track.log !== null)
    sim.features.touchdown?.fillTouchdown(
      out.touchdown,
      track.log.front,
      stepping || track.mode === 'sleeping' || track.picture.hasHeld,
    );
}

/** Wall s from its last uprighting to the present. */
function sinceUprighting({ timeline, front, alpha }: Simulation, { picture }: Track): number {
  const { timing, timeScale } = spanOf(timeline, front.tick);
  return (Math.max(0, picture.sinceUprighting - 1 + alpha) * timing.dt) / timeScale;
}

/** The predicted state between the substep boundaries around the present. */
function fillBetween(out: ShipView, sim: Simulation, track: Track): void {
  const { previous, front } = sim.fleet;
  const { alpha } = sim;
  const { position, velocity, angularVelocity } = out;
  const place = track.at + POSITION;
  const speed = track.at + VELOCITY;
  const spin = track.at + ANGULAR_VELOCITY;
  for (let k = 0; k < 3; k++) {
    position[k] = previous[place + k]! + (front[place + k]! - previous[place + k]!) * alpha;
    velocity[k] = previous[speed + k]! + (front[speed + k]! - previous[speed + k]!) * alpha;
    angularVelocity[k] = previous[spin + k]! + (front[spin + k]! - previous[spin + k]!) * alpha;
  }
  writeAttitude(out.attitude, sim, track);
}

function fillFromRow(out: ShipView, from: Float64Array): void {
  take(out.position, from, POSITION);
  take(out.velocity, from, VELOCITY);
  take(out.attitude, from, ATTITUDE);
  take(out.angularVelocity, from, ANGULAR_VELOCITY);
}

/** The pose in the body's axes, and the local up there. */
function rowToBodyAxes(out: ShipView, { seen, normal, distance }: ViewContext, body: Float64Array): void {
  rotateBack(seen.position, body, out.position);
  relativeRotation(seen.attitude, body, out.attitude);
  measure(distance, seen.position);
  const perDistance = 1 / distance[0]!;
  for (let k = 0; k < 3; k++) normal[k] = seen.position[k]! * perDistance;
}

/** drawn = predicted + offset, in the body's axes and back. */
function fillDrawn(out: ShipView, track: Track, { seen, drawn }: ViewContext, body: Float64Array): void {
  const { ease } = track.picture;
  for (let k = 0; k < 3; k++) drawn.position[k] = seen.position[k]!;
  for (let k = 0; k < 4; k++) drawn.attitude[k] = seen.attitude[k]!;
  if (!ease.active) {
    for (let k = 0; k < 3; k++) out.easedPosition[k] = out.position[k]!;
    for (let k = 0; k < 4; k++) out.meshAttitude[k] = out.attitude[k]!;
    return;
  }
  for (let k = 0; k < 3; k++) drawn.position[k] = seen.position[k]! + ease.offset[k]!;
  fromRotationVector(turn, ease.turn);
  compose(drawn.attitude, turn, seen.attitude);
  rotate(out.easedPosition, body, drawn.position);
  compose(out.meshAttitude, body, drawn.attitude);
}

const turn = quaternion();

/** Present thrust of engine and thrusters, N, ICRF (DYNAMICS, Actuators). */
function fillThrust(out: ShipView, rows: Float64Array, from: number): void {
  const { constants } = out.shipClass;
  const burns = out.fuel > 0 && !out.crashed ? 1 : 0;
  for (let k = 0; k < 3; k++)
    force[k] = burns * rows[from + TRANSLATION_INPUT + k]! * constants[RCS_THRUST + k]!;
  force[2] = force[2]! + burns * rows[from + THRUST_LEVEL]! * constants[MAIN_ENGINE_THRUST]!;
  rotate(out.thrust, out.attitude, force);
}

const force = vector();
