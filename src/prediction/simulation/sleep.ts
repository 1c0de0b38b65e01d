import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  CRASHED,
  FUEL,
  LANDED,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  VELOCITY,
} from '../../dynamics';
import { boundaryAt, knowsBoundary } from '../snapshots/bodies/bodyTrack';
import { actsBetween } from '../inputs/scheduledInput';
import { keep } from './rings/history';
import { writeBodyAttitude } from '../drawn/pose';
import {
  compose,
  cross,
  put,
  quaternion,
  rotate,
  rotateBack,
  relativeRotation,
  type Share,
  take,
  vector,
} from '../drawn/rotation';
import type { Place } from '../snapshots/reconcile/compare';
import { abandonReplay } from './replay';
import type { Boundary, Simulation } from './simulation';
import { copyRow, type Track } from './track';

/**
 * The sleep of landed ships (PREDICTION, Reconciliation): a landed ship that agrees with the server is constant in the body's axes and
 * costs no substep. An input that burns and a server state that differs wake it.
 */

/** Whether a landed ship's controls wake it: it burns, and may lift off. */
function wakesOn(rows: Float64Array, at: number): boolean {
  if (rows[at + FUEL] === 0) return false;
  if (rows[at + THRUST_LEVEL] !== 0) return true;
  for (let k = 0; k < 3; k++) if (rows[at + TRANSLATION_INPUT + k] !== 0) return true;
  return false;
}

/** Puts a ship to sleep that is at rest on the server and at the front. `serverRow` and `bodies` are of the same tick. */
export function sleepIfAtRest(sim: Simulation, track: Track, bodies: Float64Array): boolean {
  const { fleet } = sim;
  if (sim.sleep === null || !isAtRest(track.serverRow, 0) || !isAtRest(fleet.front, track.at)) return false;
  track.mode = 'sleeping';
  sleepAt(track, bodies);
  return true;
}

/** Whether a ship is landed and its commands leave it there. */
export function isAtRest(rows: Float64Array, at: number): boolean {
  return rows[at + SURFACE_STATE] === LANDED && rows[at + CRASHED] === 0 && !wakesOn(rows, at);
}

/** A ship first seen landed sleeps at once, at its server state. */
export function sleepAtFirst(sim: Simulation, track: Track, bodies: Float64Array): void {
  if (sim.sleep === null || track.mode === 'stepping' || track.picture.hasHeld) return;
  if (!isAtRest(track.serverRow, 0)) return;
  track.off = false;
  copyRow(sim.fleet.front, track.at, track.serverRow, 0);
  copyRow(sim.fleet.previous, track.at, track.serverRow, 0);
  abandonReplay(track);
  if (track.log !== null) sim.features.touchdown?.logLanded(track.log);
  sleepIfAtRest(sim, track, bodies);
}

/** Lets a sleeping ship sleep on at the server's state, which agrees. Returns whether it sleeps. */
export function sleepsOn(sim: Simulation, track: Track, bodies: Float64Array): boolean {
  if (track.mode !== 'sleeping') return false;
  sleepAt(track, bodies);
  if (!track.own) copyRow(sim.fleet.front, track.at, track.serverRow, 0);
  return true;
}

/** Whether a sleeping ship's commands in `sent` leave it asleep: they neither burn nor lift it off. */
export function sleepsThrough(track: Track, sent: Float64Array): boolean {
  return track.mode === 'sleeping' && isAtRest(sent, 0);
}

/** Puts a ship to sleep in the server's pose, so that rounding errors do not accumulate. */
function sleepAt(track: Track, bodies: Float64Array): void {
  take(body, bodies, track.serverRow[REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE);
  take(track.sleepPlace, track.serverRow, POSITION);
  rotateBack(track.sleepPlace, body, track.sleepPlace);
  take(track.sleepAttitude, track.serverRow, ATTITUDE);
  relativeRotation(track.sleepAttitude, body, track.sleepAttitude);
}

/** Writes the sleeping pose into a row, for the given attitude and spin of the body; the rest of the row stays. */
export function writeSleeping(
  rows: Float64Array,
  at: number,
  track: Track,
  attitude: Float64Array,
  spin: Float64Array,
): void {
  rotate(place, attitude, track.sleepPlace);
  put(rows, at + POSITION, place);
  cross(groundVelocity, spin, place);
  put(rows, at + VELOCITY, groundVelocity);
  compose(turned, attitude, track.sleepAttitude);
  put(rows, at + ATTITUDE, turned);
  put(rows, at + ANGULAR_VELOCITY, spin);
}

/**
 * A sleeping ship's row at the boundary, at `place`; null if the front, on a display that has drawn nothing since, has not yet reached an
 * own input before that tick.
 */
export function placeAsleep(
  place: Place,
  sim: Simulation,
  track: Track,
  { tick, bodies }: Boundary,
): Place | null {
  if (track.own && actsBetween(sim.inputs, sim.front.tick, tick)) return null;
  copyRow(place.rows, 0, sim.fleet.front, track.at);
  writeSleepingAt(place.rows, 0, track, bodies);
  place.bodies = bodies;
  return place;
}

/** Writes the sleeping pose as it was at a tick boundary. */
function writeSleepingAt(rows: Float64Array, at: number, track: Track, bodies: Float64Array): void {
  const from = rows[at + REFERENCE_BODY]! * BODY_STRIDE;
  take(body, bodies, from + BODY_ATTITUDE);
  take(spin, bodies, from + BODY_ANGULAR_VELOCITY);
  writeSleeping(rows, at, track, body, spin);
}

/** Wakes a ship, if it sleeps; it is drawn in place until it has been replayed. */
export function holdSleeping(track: Track): void {
  if (track.mode !== 'sleeping') return;
  track.picture.heldPlace.set(track.sleepPlace);
  track.picture.heldAttitude.set(track.sleepAttitude);
  track.picture.hasHeld = true;
  track.mode = 'waiting';
}

/** Wakes a sleeping ship whose command in the row `commanded` burns. Returns whether it did. */
export function wakeIfBurning(sim: Simulation, track: Track, commanded: Float64Array): boolean {
  if (track.mode !== 'sleeping' || !wakesOn(commanded, 0)) return false;
  wake(sim, track);
  return true;
}

/** Puts a sleeping ship back into step: writes its rows at the front and its history since the newest server state. */
export function wake(sim: Simulation, track: Track): void {
  const { fleet, front, timeline } = sim;
  const index = fleet.front[track.at + REFERENCE_BODY]!;
  const first = Math.max(track.serverTick, front.tick - track.history.length + 1);
  for (let tick = first; tick <= front.tick; tick++) {
    if (!knowsBoundary(sim.bodies, tick) && tick === first) continue;
    const bodies = boundaryAt(sim.bodies, timeline, tick);
    copyRow(past, 0, fleet.front, track.at);
    writeSleepingAt(past, 0, track, bodies);
    keep(track.history, tick, past, 0);
    if (track.log !== null) sim.features.touchdown?.keepLog(track.log, tick, track.log.front);
  }
  take(spin, boundaryAt(sim.bodies, timeline, front.tick), index * BODY_STRIDE + BODY_ANGULAR_VELOCITY);
  copyRow(fleet.previous, track.at, fleet.front, track.at);
  writeBodyAttitude(body, sim, index, BEFORE);
  writeSleeping(fleet.previous, track.at, track, body, spin);
  writeBodyAttitude(body, sim, index, FRONT);
  writeSleeping(fleet.front, track.at, track, body, spin);
  track.mode = 'stepping';
}

/** Substep boundaries: the one before the front, and the front. */
const BEFORE: Share = { alpha: 0 };
const FRONT: Share = { alpha: 1 };
const past = new Float64Array(SHIP_STRIDE);
const body = quaternion();
const spin = vector();
const place = vector();
const groundVelocity = vector();
const turned = quaternion();
