import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CRASHED,
  flatTerrain,
  FUEL,
  GROUND_CONTACT_OFFSET,
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
  WHEEL_MOMENTUM,
  writeGroundNormal,
} from '../../dynamics';
import { relax } from './ease';
import { fillGhost } from './ghost';
import { type DrawnGround, groundRadius } from './drawnGround';
import { confidenceOf, offsetAt, placeAt } from '../ground/learnedGround';
import { hullOf, LEGS } from './hull';
import { writeSleeping } from '../simulation/sleep';
import { pose, writeAttitude } from './pose';
import {
  compose,
  fromRotationVector,
  lengthOf,
  put,
  quaternion,
  rotate,
  rotateBack,
  seenFrom,
  take,
  vector,
} from './rotation';
import type { Simulation } from '../simulation/simulation';
import { createGroundedPose, type GroundPose, snapToGround, type GroundedPose } from './groundSnap';
import { type LevelGround, snapToLevel } from './levelSnap';
import { fillControls, fillServerState, fillStatus, type Instant } from './status';
import { createTouchdownView, fillTouchdown } from '../touchdown/touchdownLog';
import { copyRow, type Track } from '../simulation/track';
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
    carried: '',
    carriedStates: 0,
    easedPosition: vectors(),
    meshAttitude: Float64Array.of(0, 0, 0, 1),
    meshPosition: vectors(),
    legCompression: new Float64Array(LEGS),
    feetHeight: 0,
    shownState: '',
    provenance: 'predicted',
    age: 0,
    withdrawn: '',
    touchdown: createTouchdownView(),
    serverPosition: vectors(),
    serverAttitude: Float64Array.of(0, 0, 0, 1),
    ghostPosition: vectors(),
    ghostAttitude: Float64Array.of(0, 0, 0, 1),
    serverKnown: false,
    missingSends: 0,
  };
}

/** What all ships of one view share. */
export interface Scene {
  readonly world: World;
  /** Of the body under the ship at hand. */
  readonly ground: DrawnGround;
  /** Attitude and spin of each body at the present, ICRF. */
  bodyAttitudes: Float64Array[];
  bodySpins: Float64Array[];
  /** Ships that still may be put on the ground point by point: beyond them the ground counts as level under a ship. */
  exactSnaps: number;
  readonly at: Instant;
}

/** Fills a ship's view: predicted truth, the drawn pose, its ground, what is shown of its state. */
export function fillShipView(out: ShipView, sim: Simulation, track: Track, scene: Scene): void {
  const stepping = track.mode === 'stepping';
  const { fleet, alpha } = sim;
  // The states that hold at the present are those of the last substep boundary passed.
  const rows = stepping ? (alpha === 1 ? fleet.front : fleet.previous) : outOfStep(sim, track, scene);
  const from = stepping ? track.at : 0;
  if (stepping) fillBetween(out, sim, track);
  else fillFromRow(out, rows);
  out.fuel = rows[from + FUEL]!;
  take(out.wheelMomentum, rows, from + WHEEL_MOMENTUM);
  out.impactSpeed = rows[from + IMPACT_SPEED]!;
  out.surfaceContactState = SURFACE_STATES[rows[from + SURFACE_STATE]!]!;
  out.crashed = rows[from + CRASHED] === 1;
  out.body = rows[from + REFERENCE_BODY]!;
  out.shipClass = scene.world.shipClasses[rows[from + SHIP_CLASS]!]!;
  out.groundContactOffset = rows[from + GROUND_CONTACT_OFFSET]!;
  out.name = track.name;
  out.carried = track.fit.carried;
  out.carriedStates = track.fit.states;
  out.own = track.own;
  out.missingSends = sim.cadence.sends - track.lastSend;
  const attitude = scene.bodyAttitudes[out.body]!;
  seeFromBody(out, attitude);
  if (track.picture.ease.active) relax(track.picture.ease, normal, scene.at.elapsed);
  fillDrawn(out, track, attitude);
  fillGround(out, track, scene);
  const exactly = fillGrounded(out, scene, attitude);
  fillThrust(out, rows, from);
  fillControls(out, track.picture.status.commands, rows, from);
  if (fillServerState(out, track, scene.at)) fillGhost(out, track, scene.world, scene.ground, exactly);
  fillStatus(out, track, rows, from, scene.at);
  if (track.log !== null)
    fillTouchdown(
      out.touchdown,
      track.log.front,
      stepping || track.mode === 'sleeping' || track.picture.hasHeld,
    );
}

/** Predicted truth between the substep boundaries around the present. */
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

/** The row of a ship that is not in step, placed at the present. */
function outOfStep(sim: Simulation, track: Track, scene: Scene): Float64Array {
  const known = track.mode === 'sleeping' || track.picture.hasHeld;
  copyRow(row, 0, known ? sim.fleet.front : track.serverRow, known ? track.at : 0);
  const body = row[REFERENCE_BODY]!;
  const attitude = scene.bodyAttitudes[body]!;
  if (track.mode === 'sleeping') {
    writeSleeping(row, 0, track, attitude, scene.bodySpins[body]!);
  } else if (track.picture.hasHeld) {
    rotate(held.position, attitude, track.picture.heldPlace);
    put(row, POSITION, held.position);
    compose(held.attitude, attitude, track.picture.heldAttitude);
    put(row, ATTITUDE, held.attitude);
  }
  return row;
}

const row = new Float64Array(SHIP_STRIDE);
const held = pose();

function fillFromRow(out: ShipView, from: Float64Array): void {
  take(out.position, from, POSITION);
  take(out.velocity, from, VELOCITY);
  take(out.attitude, from, ATTITUDE);
  take(out.angularVelocity, from, ANGULAR_VELOCITY);
}

/** The pose as seen from the body's axes, and the local up there. */
function seeFromBody(out: ShipView, body: Float64Array): void {
  rotateBack(seen.position, body, out.position);
  seenFrom(seen.attitude, body, out.attitude);
  const perDistance = 1 / lengthOf(seen.position);
  for (let k = 0; k < 3; k++) normal[k] = seen.position[k]! * perDistance;
}

const seen = pose();
const normal = vector();

/** drawn = predicted + offset, in the body's axes and back. */
function fillDrawn(out: ShipView, track: Track, body: Float64Array): void {
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

const drawn: GroundPose = { ...pose(), grounded: false, groundOffset: 0 };
const turn = quaternion();

/** The ground under the ship, as the server has it by what was learned, and how far that is above the drawn one. */
function fillGround(out: ShipView, track: Track, { world, ground, at, bodyAttitudes }: Scene): void {
  const body = world.bodies[out.body]!;
  const { picture } = track;
  const { places } = track.ground;
  const [nx, ny, nz] = [normal[0]!, normal[1]!, normal[2]!];
  ground.bodyName = body.name;
  ground.radius = body.radius;
  out.groundRadius = groundRadius(ground, nx, ny, nz);
  fillGroundNormal(out, world, bodyAttitudes[out.body]!);
  out.groundOffset = 0;
  out.groundConfidence = 0;
  drawn.groundOffset = 0;
  if (places.length === 0) return;
  out.groundOffset = offsetAt(places, body.name, nx, ny, nz);
  out.groundConfidence = confidenceOf(placeAt(track.ground, body.name, normal));
  out.groundRadius += out.groundOffset;
  // What is learned in flight moves the mesh no faster than a correction.
  const follows = out.surfaceContactState === '' ? 1 - Math.exp(-OFFSET_RATE * at.elapsed) : 1;
  picture.groundOffset += (out.groundOffset - picture.groundOffset) * follows;
  drawn.groundOffset = picture.groundOffset;
}

/** The slope is looked for where the ship's feet are nearer to the ground than this, m. */
const SLOPE_HEIGHT = 100;

function fillGroundNormal(out: ShipView, world: World, bodyAttitude: Float64Array): void {
  const feet = lengthOf(seen.position) - out.groundRadius - out.groundContactOffset;
  if (world.settings.surfaceNormal !== 'terrain' || feet > SLOPE_HEIGHT) {
    rotate(out.groundNormal, bodyAttitude, normal);
    return;
  }
  const { name, radius } = world.bodies[out.body]!;
  under.bodyName = name;
  under.radius = radius;
  under.legRadius = out.shipClass.legRadius;
  under.terrainHeight = world.terrainHeight;
  writeGroundNormal(slope, normal, under);
  rotate(out.groundNormal, bodyAttitude, slope);
}

const slope = vector();
const under = { bodyName: '', radius: 1, legRadius: 1, terrainHeight: flatTerrain };

/** 1/s */
const OFFSET_RATE = 10;

/** @returns whether point by point, or as on level ground */
function fillGrounded(out: ShipView, scene: Scene, bodyAttitude: Float64Array): boolean {
  const { shipClass } = out;
  const exactly = out.own || scene.exactSnaps > 0;
  const surface = out.groundRadius - out.groundOffset;
  const above = lengthOf(drawn.position) - surface;
  // No part of the ship reaches as far as twice its height: nothing is under it.
  const reach = FAR * (out.groundContactOffset + Math.abs(out.groundOffset) * REACH) + shipClass.legRadius;
  if (above > reach) {
    for (let k = 0; k < 3; k++) out.meshPosition[k] = out.easedPosition[k]!;
    for (let leg = 0; leg < LEGS; leg++) out.legCompression[leg] = 0;
    out.feetHeight = lengthOf(seen.position) - out.groundRadius - out.groundContactOffset;
    return exactly;
  }
  drawn.grounded = out.surfaceContactState !== '';
  if (exactly) {
    scene.exactSnaps -= 1;
    snapToGround(groundedPose, drawn, hullOf(shipClass), scene.ground);
  } else {
    level.radius = surface;
    snapToLevel(groundedPose, drawn, hullOf(shipClass), level);
  }
  rotate(out.meshPosition, bodyAttitude, groundedPose.position);
  for (let leg = 0; leg < LEGS; leg++) out.legCompression[leg] = groundedPose.legCompression[leg]!;
  out.feetHeight = groundedPose.feetHeight;
  return exactly;
}

const FAR = 2;
/** Of the offset between the two grounds: twice this height above the ground the mesh has left it behind. */
const REACH = 4.5;
const level: LevelGround = { radius: 0 };
const groundedPose: GroundedPose = createGroundedPose(LEGS);

/** What engine and thrusters give now, N, ICRF (DYNAMICS, Actuators). */
function fillThrust(out: ShipView, rows: Float64Array, from: number): void {
  const { mainEngineThrust, rcsThrust } = out.shipClass;
  const burns = out.fuel > 0 && !out.crashed ? 1 : 0;
  for (let k = 0; k < 3; k++) force[k] = burns * rows[from + TRANSLATION_INPUT + k]! * rcsThrust[k]!;
  force[2] = force[2]! + burns * rows[from + THRUST_LEVEL]! * mainEngineThrust;
  rotate(out.thrust, out.attitude, force);
}

const force = vector();
