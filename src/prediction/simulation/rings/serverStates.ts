import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  POSITION,
  REFERENCE_BODY,
  VELOCITY,
} from '../../../dynamics';
import { cross, put, quaternion, rotateBack, relativeRotation, take, vector } from '../../drawn/rotation';

/**
 * The newest server states of one ship, oldest first, for interpolation. In each row position, velocity, attitude and
 * spin are in the axes of the reference body, and the velocity is relative to the turning body: between two states the body turns.
 */
export interface ServerStates {
  readonly ticks: number[];
  readonly rows: Float64Array[];
}

export function createServerStates(): ServerStates {
  return { ticks: [], rows: [] };
}

/** Converts a row from ICRF axes to those of its reference body, with the velocity relative to the turning body. */
export function rowToBodyAxes(row: Float64Array, bodies: Float64Array): void {
  const at = row[REFERENCE_BODY]! * BODY_STRIDE;
  take(body, bodies, at + BODY_ATTITUDE);
  take(spin, bodies, at + BODY_ANGULAR_VELOCITY);
  take(place, row, POSITION);
  cross(groundVelocity, spin, place);
  for (let k = 0; k < 3; k++) row[VELOCITY + k] = row[VELOCITY + k]! - groundVelocity[k]!;
  for (const column of [POSITION, VELOCITY, ANGULAR_VELOCITY]) {
    take(place, row, column);
    rotateBack(place, body, place);
    put(row, column, place);
  }
  take(attitude, row, ATTITUDE);
  relativeRotation(attitude, body, attitude);
  put(row, ATTITUDE, attitude);
}

const body = quaternion();
const attitude = quaternion();
const spin = vector();
const groundVelocity = vector();
const place = vector();
