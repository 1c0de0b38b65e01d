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
import { writeSleeping } from '../simulation/sleep';
import { copyRow, type Track } from '../simulation/track';
import { fadeFromHeld } from './correction';
import type { Playback } from './interpolate';
import { pose } from './pose';
import { compose, cross, put, rotate, rotateBack, seenFrom, take, vector } from './rotation';

/** The bodies' attitudes at the present. */
export interface TurnedBodies {
  /** Attitude and spin of each body, ICRF. */
  readonly bodyAttitudes: readonly Float64Array[];
  readonly bodySpins: readonly Float64Array[];
  /** The instant at which interpolated ships are drawn. */
  readonly playback: Playback;
}

/**
 * The row at the present of a ship that is not in step: asleep, held as last predicted, or in its last server state,
 * turned with its body since then.
 */
export function outOfStep(sim: Simulation, track: Track, turned: TurnedBodies): Float64Array {
  const { picture } = track;
  if (track.policy !== 'predict') return rowOfPolicy(sim, track, turned);
  const known = track.mode === 'sleeping' || picture.hasHeld;
  copyRow(row, 0, known ? sim.fleet.front : track.serverRow, known ? track.at : 0);
  const index = row[REFERENCE_BODY]!;
  const attitude = turned.bodyAttitudes[index]!;
  const spin = turned.bodySpins[index]!;
  if (track.mode === 'sleeping') {
    writeSleeping(row, 0, track, attitude, spin);
    return row;
  }
  if (picture.hasHeld) {
    seen.position.set(picture.heldPlace);
    seen.attitude.set(picture.heldAttitude);
  } else seeServerState(track);
  place(attitude);
  if (!picture.hasHeld && row[SURFACE_STATE] !== FLYING) moveWithBody(spin);
  return row;
}

/** The row of a ship that the caller chose not to predict: between its server states, or the newest one. */
function rowOfPolicy(sim: Simulation, track: Track, turned: TurnedBodies): Float64Array {
  copyRow(row, 0, track.serverRow, 0);
  const index = row[REFERENCE_BODY]!;
  const attitude = turned.bodyAttitudes[index]!;
  const spin = turned.bodySpins[index]!;
  const { interpolation } = sim.features;
  if (track.policy === 'interpolate' && track.states !== null && interpolation) {
    interpolation.writeBetween(row, track.states, turned.playback);
    take(seen.position, row, POSITION);
    take(seen.attitude, row, ATTITUDE);
    fadeFromHeld(sim, track, seen);
    interpolation.turnWithBody(row, attitude, spin);
    return row;
  }
  seeServerState(track);
  fadeFromHeld(sim, track, seen);
  place(attitude);
  if (row[SURFACE_STATE] !== FLYING) moveWithBody(spin);
  return row;
}

/** Converts the server row's pose to the axes of its body at that tick. */
function seeServerState({ serverBodyAttitude }: Track): void {
  take(seen.position, row, POSITION);
  take(seen.attitude, row, ATTITUDE);
  rotateBack(seen.position, serverBodyAttitude, seen.position);
  seenFrom(seen.attitude, serverBodyAttitude, seen.attitude);
}

/** Writes a pose in its body's axes into the row, in ICRF axes. */
function place(attitude: Float64Array): void {
  rotate(seen.position, attitude, seen.position);
  compose(seen.attitude, attitude, seen.attitude);
  put(row, POSITION, seen.position);
  put(row, ATTITUDE, seen.attitude);
}

function moveWithBody(spin: Float64Array): void {
  cross(velocity, spin, seen.position);
  put(row, VELOCITY, velocity);
  put(row, ANGULAR_VELOCITY, spin);
}

const row = new Float64Array(SHIP_STRIDE);
const seen = pose();
const velocity = vector();
