import { REFERENCE_BODY, VELOCITY } from '../../dynamics';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import { spanOf, wallOfTick } from '../time/timeline';
import { type Ease, restartEase, snap } from './ease';
import { LONG_AGO } from './picture';
import { type Pose, pose, writeBodyAttitude, writePredicted, writeSeen } from './pose';
import {
  angleOf,
  compose,
  fromRotationVector,
  lengthOf,
  normalize,
  quaternion,
  take,
  toRotationVector,
  rotationBetween,
  vector,
} from './rotation';

/** Easing of corrections (PREDICTION, Drawing): the old drawn pose fades into the new predicted one. */

/** Larger corrections snap: m, and rad. */
const SNAP_DISTANCE = 25;
const SNAP_ANGLE = Math.PI / 3;

/** The prediction at the present before a correction, in the axes of the ship's body then. */
export interface DrawnBefore {
  readonly pose: Pose;
  body: number;
  /** m/s of game time, relative to the body. */
  speed: number;
  /** False if there is no drawn pose to ease from. */
  known: boolean;
}

/** How a correction is shown. */
export interface CorrectionStyle {
  /** Do not ease: the ship respawned. */
  readonly snaps: boolean;
  /** The last substep turned the ship upright. */
  readonly uprights: boolean;
}

/** A ship's drawn pose before its rows are replaced; one record, valid until the next call. */
export function captureDrawn(sim: Simulation, track: Track): DrawnBefore {
  const { picture } = track;
  drawn.body = sim.fleet.front[track.at + REFERENCE_BODY]!;
  drawn.speed = speedOf(sim.fleet.front, track.at);
  drawn.known = track.mode === 'stepping' || picture.hasHeld;
  if (picture.hasHeld) {
    drawn.pose.position.set(picture.heldPlace);
    drawn.pose.attitude.set(picture.heldAttitude);
  } else if (drawn.known) writeSeenPresent(drawn.pose, sim, track);
  return drawn;
}

const drawn: DrawnBefore = { pose: pose(), body: 0, speed: 0, known: false };

/** Eases or snaps the correction, and counts it if the ship was drawn before. */
export function easeCorrection(
  sim: Simulation,
  track: Track,
  before: DrawnBefore,
  style: CorrectionStyle,
): void {
  const { picture, at } = track;
  const { front } = sim.fleet;
  const unseen = Math.max(track.silence, picture.skipped) + ageOf(sim, track);
  picture.skipped = 0;
  picture.hasHeld = false;
  picture.sinceUprighting = style.uprights ? 0 : LONG_AGO;
  if (!before.known) {
    snap(picture.ease);
    return;
  }
  picture.body = front[at + REFERENCE_BODY]!;
  writeSeenPresent(now, sim, track);
  const sameBody = before.body === front[at + REFERENCE_BODY];
  const { timeScale } = spanOf(sim.timeline, sim.front.tick);
  const covered = Math.max(before.speed, speedOf(front, at)) * unseen * timeScale;
  if (!style.snaps && sameBody && isEasable(before.pose, now, covered)) {
    addToOffset(picture.ease, before.pose, now);
    return;
  }
  snap(picture.ease);
  sim.counters.snaps += 1;
}

/** Keeps the drawn pose, in the body's axes, while the ship is out of step. */
export function holdDrawn(sim: Simulation, track: Track): void {
  const { picture } = track;
  writeSeenPresent(now, sim, track);
  picture.heldPlace.set(now.position);
  picture.heldAttitude.set(now.attitude);
  picture.hasHeld = true;
}

/**
 * Eases a change of policy: the pose drawn before fades into `seen`. The drawn pose is kept, in case the policy changes again.
 * @param seen the pose drawn from now on, in its body's axes
 */
export function fadeFromHeld(sim: Simulation, { picture, at, serverRow }: Track, seen: Pose): void {
  if (picture.hasHeld) {
    picture.hasHeld = false;
    held.position.set(picture.heldPlace);
    held.attitude.set(picture.heldAttitude);
    const sameBody = sim.fleet.front[at + REFERENCE_BODY] === serverRow[REFERENCE_BODY];
    const { timeScale } = spanOf(sim.timeline, sim.front.tick);
    if (sameBody && isEasable(held, seen, speedOf(serverRow, 0) * POLICY_STALL * timeScale))
      addToOffset(picture.ease, held, seen);
    else snap(picture.ease);
  }
  picture.heldPlace.set(seen.position);
  picture.heldAttitude.set(seen.attitude);
}

const held: Pose = pose();
/** Wall s: if two policies draw a ship at instants further apart, the change snaps. */
export const POLICY_STALL = 2;

/** Applies a correction: offset += old predicted − new predicted, both at one instant and in the body's axes (PREDICTION, Drawing). */
export function addToOffset(ease: Ease, old: Pose, next: Pose): void {
  for (let k = 0; k < 3; k++) ease.offset[k] = ease.offset[k]! + (old.position[k]! - next.position[k]!);
  rotationBetween(turn, old.attitude, next.attitude);
  fromRotationVector(eased, ease.turn);
  compose(turn, eased, turn);
  normalize(turn);
  toRotationVector(ease.turn, turn);
  restartEase(ease);
}

function writeSeenPresent(out: Pose, sim: Simulation, track: Track): void {
  writeBodyAttitude(body, sim, sim.fleet.front[track.at + REFERENCE_BODY]!, sim);
  writePredicted(out, sim, track);
  writeSeen(out, out, body);
}

/** How far the front is ahead of the ship's newest state, wall s. */
function ageOf({ timeline, front }: Simulation, { serverTick }: Track): number {
  const { timing, timeScale } = spanOf(timeline, front.tick);
  const into = (front.substep * timing.dt) / timeScale;
  return Math.max(0, wallOfTick(timeline, front.tick) + into - wallOfTick(timeline, serverTick));
}

/** Whether a correction is within 60°, and within 25 m plus `covered`, m: the distance flown since the last state, or skipped. */
function isEasable(old: Pose, next: Pose, covered: number): boolean {
  for (let k = 0; k < 3; k++) jump[k] = old.position[k]! - next.position[k]!;
  rotationBetween(turn, old.attitude, next.attitude);
  return lengthOf(jump) <= SNAP_DISTANCE + covered && angleOf(turn) <= SNAP_ANGLE;
}

function speedOf(rows: Float64Array, at: number): number {
  take(velocity, rows, at + VELOCITY);
  return lengthOf(velocity);
}

const now = pose();
const body = quaternion();
const turn = quaternion();
const eased = quaternion();
const jump = vector();
const velocity = vector();
