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
import { wallOfTick } from '../time/timeline';
import type { ServerStates } from '../simulation/rings/serverStates';
import type { Simulation } from '../simulation/simulation';
import { copyRow, type Track } from '../simulation/track';
import { fadeFromHeld } from './correction';
import { moveWithBody, place, seeServerState } from './outOfStep';
import type { Playback, TurnedBodies } from './viewContext';
import { pose } from './pose';
import {
  compose,
  cross,
  fromRotationVector,
  put,
  quaternion,
  rotate,
  take,
  toRotationVector,
  rotationBetween,
  vector,
} from './rotation';

/** The row of a ship that the caller chose not to predict: between its server states, or the newest one. */
export function rowOfPolicy(sim: Simulation, track: Track, turned: TurnedBodies): Float64Array {
  copyRow(drawn, 0, track.serverRow, 0);
  const index = drawn[REFERENCE_BODY]!;
  const attitude = turned.bodyAttitudes[index]!;
  const spin = turned.bodySpins[index]!;
  if (track.policy === 'interpolate' && track.states !== null) {
    writeBetween(drawn, track.states, turned.playback);
    take(seen.position, drawn, POSITION);
    take(seen.attitude, drawn, ATTITUDE);
    fadeFromHeld(sim, track, seen);
    rowToIcrf(drawn, attitude, spin);
    return drawn;
  }
  seeServerState(seen, drawn, track);
  fadeFromHeld(sim, track, seen);
  place(drawn, seen, attitude);
  if (drawn[SURFACE_STATE] !== FLYING) moveWithBody(drawn, seen, spin);
  return drawn;
}

/**
 * Interpolates a ship's row between the two server states around the instant of `playback`; the first state holds before the first,
 * the last one after the last. In flight the position follows the cubic through the states' velocities, on the ground a straight line.
 * @param row a copy of the earlier state, with position, velocity, attitude and spin in the body's axes, the velocity
 *   relative to the turning body
 */
function writeBetween(
  row: Float64Array,
  { ticks, rows }: ServerStates,
  { timeline, at, timeScale }: Playback,
): void {
  let i = rows.length - 1;
  while (i > 0 && wallOfTick(timeline, ticks[i]!) > at) i--;
  const a = rows[i]!;
  const b = rows[i + 1];
  row.set(a);
  if (b === undefined) return;
  const from = wallOfTick(timeline, ticks[i]!);
  const wall = wallOfTick(timeline, ticks[i + 1]!) - from;
  const share = wall > 0 ? Math.max(0, (at - from) / wall) : 1;
  const between: Between = { a, b, share, seconds: wall * timeScale };
  writePlace(row, between);
  blendColumns(row, ANGULAR_VELOCITY, between);
  turnOver(row, between);
}

interface Between {
  readonly a: Float64Array;
  readonly b: Float64Array;
  /** Fraction of the way from a to b, 0 … 1. */
  readonly share: number;
  /** Game s from a to b. */
  readonly seconds: number;
}

function writePlace(row: Float64Array, between: Between): void {
  const { a, b, share: s, seconds } = between;
  blendColumns(row, VELOCITY, between);
  if (a[SURFACE_STATE] !== FLYING || b[SURFACE_STATE] !== FLYING) {
    blendColumns(row, POSITION, between);
    return;
  }
  const [p0, p1] = [(1 + 2 * s) * (1 - s) ** 2, s * s * (3 - 2 * s)];
  const [v0, v1] = [s * (1 - s) ** 2 * seconds, s * s * (s - 1) * seconds];
  for (let k = 0; k < 3; k++)
    row[POSITION + k] =
      p0 * a[POSITION + k]! + p1 * b[POSITION + k]! + v0 * a[VELOCITY + k]! + v1 * b[VELOCITY + k]!;
}

function blendColumns(row: Float64Array, column: number, { a, b, share }: Between): void {
  for (let k = column; k < column + 3; k++) row[k] = a[k]! + (b[k]! - a[k]!) * share;
}

/** The attitude on the shorter arc from a's to b's. */
function turnOver(row: Float64Array, { a, b, share }: Between): void {
  take(first, a, ATTITUDE);
  take(second, b, ATTITUDE);
  rotationBetween(turn, second, first);
  toRotationVector(way, turn);
  for (let k = 0; k < 3; k++) way[k] = way[k]! * share;
  fromRotationVector(turn, way);
  compose(first, turn, first);
  put(row, ATTITUDE, first);
}

/** Converts a row from the axes of a body with this attitude and spin to ICRF axes. */
export function rowToIcrf(row: Float64Array, attitude: Float64Array, spin: Float64Array): void {
  for (const column of [POSITION, VELOCITY, ANGULAR_VELOCITY]) {
    take(way, row, column);
    rotate(way, attitude, way);
    put(row, column, way);
  }
  take(first, row, ATTITUDE);
  compose(first, attitude, first);
  put(row, ATTITUDE, first);
  take(way, row, POSITION);
  cross(groundVelocity, spin, way);
  for (let k = 0; k < 3; k++) row[VELOCITY + k] = row[VELOCITY + k]! + groundVelocity[k]!;
}

const drawn = new Float64Array(SHIP_STRIDE);
const seen = pose();
const first = quaternion();
const second = quaternion();
const turn = quaternion();
const way = vector();
const groundVelocity = vector();
