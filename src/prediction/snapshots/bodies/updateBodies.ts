import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  type BodyMotion,
  setBodyMotion,
  type writeBodyMotion,
} from '../../../dynamics';
import { type BodyTrack, forgetAfter, knowsBoundary } from './bodyTrack';

/** Largest error of predicted bodies: of an attitude's component, and of a spin's, rad/s. */
export interface BodyError {
  attitude: number;
  spin: number;
}

/**
 * Takes the server's bodies at `tick`. The prediction stays in `replaced`; later boundaries are computed again.
 * @param sent one motion for each body, in the world's order
 * @param write writes one; the checked one leaves a body that cannot be as it was
 * @returns the error of the predicted ones: 0 if they agreed to the bit, or nothing was predicted
 */
export function updateBodies(
  track: BodyTrack,
  tick: number,
  sent: readonly BodyMotion[],
  write: typeof writeBodyMotion | typeof setBodyMotion = setBodyMotion,
): BodyError {
  const known = knowsBoundary(track, tick);
  const boundary = track.boundaries[tick % track.length]!;
  if (known) {
    track.replaced.set(boundary);
    if (sent.every((motion, i) => agrees(boundary, i * BODY_STRIDE, motion))) return NO_ERROR;
  }
  for (let i = 0; i < sent.length; i++) write(boundary, i * BODY_STRIDE, sent[i]!);
  if (!known) track.replaced.set(boundary);
  track.ticks[tick % track.length] = tick;
  forgetAfter(track, tick);
  return errorBetween(track.replaced, boundary, track.count);
}

const NO_ERROR: Readonly<BodyError> = Object.freeze({ attitude: 0, spin: 0 });

function agrees(rows: Float64Array, at: number, motion: BodyMotion): boolean {
  return (
    holds(rows, at + BODY_POSITION, motion.position) &&
    holds(rows, at + BODY_VELOCITY, motion.velocity) &&
    holds(rows, at + BODY_ATTITUDE, motion.attitude) &&
    holds(rows, at + BODY_ANGULAR_VELOCITY, motion.angularVelocity)
  );
}

function holds(rows: Float64Array, at: number, values: readonly number[]): boolean {
  for (let k = 0; k < values.length; k++) if (rows[at + k] !== values[k]) return false;
  return true;
}

function errorBetween(a: Float64Array, b: Float64Array, count: number): BodyError {
  const error: BodyError = { attitude: 0, spin: 0 };
  for (let i = 0; i < count; i++) {
    const at = i * BODY_STRIDE;
    error.attitude = Math.max(error.attitude, largest(a, b, at + BODY_ATTITUDE, 4));
    error.spin = Math.max(error.spin, largest(a, b, at + BODY_ANGULAR_VELOCITY, 3));
  }
  return error;
}

function largest(a: Float64Array, b: Float64Array, from: number, count: number): number {
  let most = 0;
  for (let k = from; k < from + count; k++) most = Math.max(most, Math.abs(a[k]! - b[k]!));
  return most;
}
