import { ATTITUDE, BODY_ATTITUDE, BODY_END_ATTITUDE, BODY_STRIDE, POSITION } from '../../dynamics';
import { boundaryAt, knowsBoundary, rowsAt } from '../snapshots/bodies/bodyTrack';
import { blend, quaternion, rotateBack, relativeRotation, type Share, take, vector } from './rotation';
import type { Simulation } from '../simulation/simulation';
import { spanOf } from '../time/timeline';
import type { Track } from '../simulation/track';

/** A ship's pose at the present, between the substep boundary before the front and the front. ICRF axes, relative to the body. */
export interface Pose {
  readonly position: Float64Array;
  readonly attitude: Float64Array;
}

export const pose = (): Pose => ({ position: vector(), attitude: quaternion() });

/** Writes the predicted pose at the present of a ship whose rows are at the front. */
export function writePredicted(out: Pose, sim: Simulation, track: Track): void {
  const { previous, front } = sim.fleet;
  const { at } = track;
  const { alpha } = sim;
  for (let k = 0; k < 3; k++) {
    const from = previous[at + POSITION + k]!;
    out.position[k] = from + (front[at + POSITION + k]! - from) * alpha;
  }
  writeAttitude(out.attitude, sim, track);
}

/** Writes the predicted attitude at the present of a ship whose rows are at the front. */
export function writeAttitude(out: Float64Array, sim: Simulation, track: Track): void {
  const { previous, front } = sim.fleet;
  take(after, front, track.at + ATTITUDE);
  // If the dynamics turned it instantly at the substep's end, the offset restores the attitude before.
  take(before, track.picture.sinceUprighting === 0 ? front : previous, track.at + ATTITUDE);
  blend(out, before, after, sim);
}

const before = quaternion();
const after = quaternion();

/** Writes a body's attitude at a share of the way from the substep boundary before the front to the front. */
export function writeBodyAttitude(out: Float64Array, sim: Simulation, index: number, share: Share): void {
  const { front, timeline, bodies } = sim;
  const at = index * BODY_STRIDE;
  const tick = front.substep > 0 ? front.tick : front.tick - 1;
  if (share.alpha === 1 || !(front.substep > 0 || knowsBoundary(bodies, tick))) {
    if (front.substep === 0) take(out, boundaryAt(bodies, timeline, front.tick), at + BODY_ATTITUDE);
    else take(out, rowsAt(bodies, timeline, tick, front.substep - 1), at + BODY_END_ATTITUDE);
    return;
  }
  const last = front.substep > 0 ? front.substep : spanOf(timeline, tick).timing.substeps;
  const rows = rowsAt(bodies, timeline, tick, last - 1);
  take(start, rows, at + BODY_ATTITUDE);
  take(end, rows, at + BODY_END_ATTITUDE);
  blend(out, start, end, share);
}

const start = quaternion();
const end = quaternion();

/** Converts an ICRF pose to a body's axes. */
export function writeSeen(out: Pose, given: Pose, body: Float64Array): void {
  rotateBack(out.position, body, given.position);
  relativeRotation(out.attitude, body, given.attitude);
}
