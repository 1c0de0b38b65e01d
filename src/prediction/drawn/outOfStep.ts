import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  FLYING,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  VELOCITY,
} from '../../dynamics';
import type { Simulation } from '../simulation/simulation';
import { copyRow, type Track } from '../simulation/track';
import type { ViewContext } from './viewContext';
import { type Pose, pose } from './pose';
import { compose, cross, put, rotate, rotateBack, relativeRotation, take, vector } from './rotation';

/**
 * The row at the present of a ship that is not in step: asleep, held as last predicted, or in its last server state,
 * turned with its body since then.
 */
export function outOfStep(sim: Simulation, track: Track, context: ViewContext): Float64Array {
  const { picture } = track;
  const { rowOfPolicy } = context.features;
  if (track.policy !== 'predict' && rowOfPolicy) return rowOfPolicy(sim, track, context);
  const known = track.mode === 'sleeping' || picture.hasHeld;
  copyRow(row, 0, known ? sim.fleet.front : track.serverRow, known ? track.at : 0);
  const index = row[REFERENCE_BODY]!;
  const attitude = context.bodyAttitudes[index]!;
  const spin = context.bodySpins[index]!;
  if (track.mode === 'sleeping' && sim.sleep !== null) {
    sim.sleep.writeSleeping(row, 0, track, attitude, spin);
    return row;
  }
  if (picture.hasHeld) {
    seen.position.set(picture.heldPlace);
    seen.attitude.set(picture.heldAttitude);
  } else seeServerState(seen, row, track);
  place(row, seen, attitude);
  if (!picture.hasHeld && row[SURFACE_STATE] !== FLYING) moveWithBody(row, seen, spin);
  return row;
}

/** Converts the server row's pose to the axes of its body at that tick. */
export function seeServerState(seen: Pose, row: Float64Array, { serverBodyAttitude }: Track): void {
  take(seen.position, row, POSITION);
  take(seen.attitude, row, ATTITUDE);
  rotateBack(seen.position, serverBodyAttitude, seen.position);
  relativeRotation(seen.attitude, serverBodyAttitude, seen.attitude);
}

/** Writes a pose in its body's axes into the row, in ICRF axes. */
export function place(row: Float64Array, seen: Pose, attitude: Float64Array): void {
  rotate(seen.position, attitude, seen.position);
  compose(seen.attitude, attitude, seen.attitude);
  put(row, POSITION, seen.position);
  put(row, ATTITUDE, seen.attitude);
}

/** The row's velocity and spin are those of the turning body at its place. */
export function moveWithBody(row: Float64Array, seen: Pose, spin: Float64Array): void {
  cross(velocity, spin, seen.position);
  put(row, VELOCITY, velocity);
  put(row, ANGULAR_VELOCITY, spin);
}

const row = new Float64Array(SHIP_STRIDE);
const seen = pose();
const velocity = vector();
