import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  CRASHED,
  FUEL,
  IMPACT_SPEED,
  NEUTRAL_CONTROLS,
  POSITION,
  REFERENCE_BODY,
  SHIP_CLASS,
  SHIP_STRIDE,
  SURFACE_STATE,
  SURFACE_STATES,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  VELOCITY,
  type World,
} from '../dynamics';
import { boundaryAt } from './bodyTrack';
import { relax } from './ease';
import { hullOf, LEGS } from './hull';
import { writeLocked } from './landedLock';
import { pose, writeBodyAttitude, writePredicted, writeSeen } from './pose';
import { compose, fromRotationVector, lengthOf, quaternion, rotate, take, vector } from './rotation';
import type { Simulation } from './simulation';
import { createStandingPose, type GroundPose, standOnGround, type StandingPose } from './standOnGround';
import { copyRow, type Track } from './track';
import { fillStatus, type Instant } from './status';
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
    attitude: Float64Array.of(0, 0, 0, 1),
    angularVelocity: vectors(),
    fuel: 0,
    impactSpeed: 0,
    surfaceState: '',
    crashed: false,
    controls: NEUTRAL_CONTROLS,
    thrust: vectors(),
    groundRadius: 0,
    drawnPosition: vectors(),
    drawnAttitude: Float64Array.of(0, 0, 0, 1),
    standPosition: vectors(),
    legCompression: new Float64Array(LEGS),
    feetHeight: 0,
    shownState: '',
    provenance: 'predicted',
    age: 0,
    withdrawn: '',
    serverPosition: vectors(),
    serverAttitude: Float64Array.of(0, 0, 0, 1),
    serverKnown: false,
    missingTicks: 0,
  };
}

/** Fills a ship's view: predicted truth, the drawn pose, where it stands, what is shown of its state. */
export function fillShipView(out: ShipView, sim: Simulation, track: Track, at: Instant): void {
  const row = rowShown(sim, track);
  const index = row[REFERENCE_BODY]!;
  writeBodyAttitude(bodyAttitude, sim, index, sim.alpha);
  fillTruth(out, sim, track, row);
  relax(track.ease, normalOf(out), at.elapsed);
  fillDrawn(out, track);
  fillStanding(out, sim.world);
  fillThrust(out, row);
  fillStatus(out, sim, track, { row, at });
}

/** The row whose states hold at the present: the last substep boundary passed, or what stands in for it. */
function rowShown(sim: Simulation, track: Track): Float64Array {
  const { fleet } = sim;
  if (track.mode === 'stepping') {
    copyRow(shown, 0, sim.alpha === 1 ? fleet.front : fleet.previous, track.at);
    return shown;
  }
  const fromServer = track.mode === 'held' || (track.mode === 'waiting' && !track.hasHeld);
  if (fromServer) copyRow(shown, 0, track.serverRow, 0);
  else copyRow(shown, 0, fleet.front, track.at);
  return shown;
}

const shown = new Float64Array(SHIP_STRIDE);

function fillTruth(out: ShipView, sim: Simulation, track: Track, row: Float64Array): void {
  if (track.mode === 'stepping') {
    between(row, sim, track, VELOCITY, 3);
    between(row, sim, track, ANGULAR_VELOCITY, 3);
    between(row, sim, track, FUEL, 1);
    writePredicted(predicted, sim, track);
    for (let k = 0; k < 3; k++) row[POSITION + k] = predicted.position[k]!;
    for (let k = 0; k < 4; k++) row[ATTITUDE + k] = predicted.attitude[k]!;
  } else if (track.mode === 'locked') {
    const bodies = boundaryAt(sim.bodies, sim.timeline, sim.front.tick);
    take(spin, bodies, row[REFERENCE_BODY]! * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
    writeLocked(row, 0, track, bodyAttitude, spin);
  } else if (track.hasHeld) {
    rotate(held, bodyAttitude, track.heldPlace);
    for (let k = 0; k < 3; k++) row[POSITION + k] = held[k]!;
    compose(heldTurn, bodyAttitude, track.heldAttitude);
    for (let k = 0; k < 4; k++) row[ATTITUDE + k] = heldTurn[k]!;
  }
  take(out.position, row, POSITION);
  take(out.velocity, row, VELOCITY);
  take(out.attitude, row, ATTITUDE);
  take(out.angularVelocity, row, ANGULAR_VELOCITY);
  out.fuel = row[FUEL]!;
  out.impactSpeed = row[IMPACT_SPEED]!;
  out.surfaceState = SURFACE_STATES[row[SURFACE_STATE]!]!;
  out.crashed = row[CRASHED] === 1;
  out.body = row[REFERENCE_BODY]!;
  out.shipClass = sim.world.shipClasses[row[SHIP_CLASS]!]!;
  out.name = track.name;
  out.own = track.own;
}

const held = vector();
const heldTurn = quaternion();
const predicted = pose();
const spin = vector();
const bodyAttitude = quaternion();

/** Interpolates columns of a stepping ship between the boundaries around the present. */
function between(row: Float64Array, sim: Simulation, track: Track, column: number, count: number): void {
  const { previous, front } = sim.fleet;
  for (let k = column; k < column + count; k++) {
    const from = previous[track.at + k]!;
    row[k] = from + (front[track.at + k]! - from) * sim.alpha;
  }
}

/** Local up at the ship in the body's axes. Leaves the pose as seen from there in `seen`. */
function normalOf(out: ShipView): Float64Array {
  truth.position.set(out.position);
  truth.attitude.set(out.attitude);
  writeSeen(seen, truth, bodyAttitude);
  const distance = lengthOf(seen.position);
  for (let k = 0; k < 3; k++) normal[k] = seen.position[k]! / distance;
  return normal;
}

const truth = pose();
const seen = pose();
const normal = vector();

/** drawn = predicted + offset, in the body's axes and back. */
function fillDrawn(out: ShipView, track: Track): void {
  drawn.position.set(seen.position);
  drawn.attitude.set(seen.attitude);
  if (!track.ease.active) {
    out.drawnPosition.set(out.position);
    out.drawnAttitude.set(out.attitude);
    return;
  }
  for (let k = 0; k < 3; k++) drawn.position[k] = seen.position[k]! + track.ease.offset[k]!;
  fromRotationVector(turn, track.ease.turn);
  compose(drawn.attitude, turn, seen.attitude);
  rotate(out.drawnPosition, bodyAttitude, drawn.position);
  compose(out.drawnAttitude, bodyAttitude, drawn.attitude);
}

const drawn: GroundPose = { ...pose(), grounded: false };
const turn = quaternion();

function fillStanding(out: ShipView, world: World): void {
  const body = world.bodies[out.body]!;
  terrain.bodyName = body.name;
  terrain.radius = body.radius;
  terrain.height = world.terrainHeight;
  out.groundRadius = groundRadius(normal[0]!, normal[1]!, normal[2]!);
  const hull = hullOf(out.shipClass);
  const above = lengthOf(drawn.position) - out.groundRadius;
  // No part of the ship reaches as far as twice its height: nothing to stand on.
  if (above > FAR * out.shipClass.groundContactOffset + out.shipClass.legRadius) {
    out.standPosition.set(out.drawnPosition);
    out.legCompression.fill(0);
    out.feetHeight = lengthOf(seen.position) - out.groundRadius - out.shipClass.groundContactOffset;
    return;
  }
  drawn.grounded = out.surfaceState !== '';
  standOnGround(standing, drawn, hull, groundRadius);
  rotate(out.standPosition, bodyAttitude, standing.position);
  out.legCompression.set(standing.legCompression);
  out.feetHeight = standing.feetHeight;
}

const FAR = 2;
const standing: StandingPose = createStandingPose(LEGS);
const terrain: { bodyName: string; radius: number; height: World['terrainHeight'] } = {
  bodyName: '',
  radius: 0,
  height: () => 0,
};

function groundRadius(nx: number, ny: number, nz: number): number {
  return terrain.radius + terrain.height(terrain.bodyName, nx, ny, nz);
}

/** What engine and thrusters give now, N, ICRF (DYNAMICS, Actuators). */
function fillThrust(out: ShipView, row: Float64Array): void {
  const { mainEngineThrust, rcsThrust } = out.shipClass;
  const burns = row[FUEL]! > 0 && !out.crashed ? 1 : 0;
  for (let k = 0; k < 3; k++) force[k] = burns * row[TRANSLATION_INPUT + k]! * rcsThrust[k]!;
  force[2] = force[2]! + burns * row[THRUST_LEVEL]! * mainEngineThrust;
  rotate(out.thrust, out.attitude, force);
}

const force = vector();
