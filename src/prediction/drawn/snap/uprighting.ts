import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_END_ATTITUDE,
  BODY_STRIDE,
  EVENT_CONTACT,
  REFERENCE_BODY,
} from '../../../dynamics';
import type { Simulation } from '../../simulation/simulation';
import type { Track } from '../../simulation/track';
import type { RowStep } from '../../simulation/rowStep';
import { addToOffset } from '../correction';
import { pose } from '../pose';
import { compose, fromRotationVector, quaternion, relativeRotation, take, vector } from '../rotation';

/** Whether the dynamics turn a ship upright instantly at this event. */
export function uprights(sim: Simulation, event: number): boolean {
  return event === EVENT_CONTACT && sim.world.settings.touchdownAttitude === 'aligned';
}

/**
 * Eases a jump of the dynamics: an aligned touchdown turns the ship upright in one substep. The offset takes up the difference to
 * the attitude that its spin would have led to, so that the drawn ship turns smoothly. Not counted as a correction.
 */
export function easeUprighting(sim: Simulation, track: Track, step: RowStep): void {
  if (!uprights(sim, step.event)) return;
  const { rows, at, before, beforeAt, bodies } = step;
  take(body, bodies, rows[at + REFERENCE_BODY]! * BODY_STRIDE + BODY_END_ATTITUDE);
  take(spin, before, beforeAt + ANGULAR_VELOCITY);
  for (let k = 0; k < 3; k++) spin[k] = spin[k]! * step.dt[0];
  fromRotationVector(turn, spin);
  take(unturned.attitude, before, beforeAt + ATTITUDE);
  compose(unturned.attitude, turn, unturned.attitude);
  take(turned.attitude, rows, at + ATTITUDE);
  relativeRotation(unturned.attitude, body, unturned.attitude);
  relativeRotation(turned.attitude, body, turned.attitude);
  unturned.position.fill(0);
  turned.position.fill(0);
  addToOffset(track.picture.ease, unturned, turned);
  track.picture.sinceUprighting = 0;
}

const body = quaternion();
const turn = quaternion();
const spin = vector();
const unturned = pose();
const turned = pose();
