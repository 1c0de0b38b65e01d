import {
  BODY_ATTITUDE,
  BODY_STRIDE,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  VELOCITY,
} from '../../dynamics';
import { boundaryAt } from '../snapshots/bodies/bodyTrack';
import { has, offsetOf } from '../simulation/rings/history';
import { lengthOf, quaternion, rotateBack, take, vector } from '../drawn/rotation';
import type { Simulation } from '../simulation/simulation';
import { advanceRow, placeStep } from '../simulation/stepRow';
import { indexOf, spanOf } from '../time/timeline';
import { beginLog, LOGGED_STATE, logLiftOff, logState, logSubstep, logTouch } from './touchdownLog';
import { type Adopted, createTouchdownRing, keepLog, logAt, type TouchdownRing } from './touchdownRing';
import { copyRow, type Track } from '../simulation/track';
import { createRowStep } from '../simulation/rowStep';

/** Largest correction in addition to the distance flown, m; more is a respawn. */
const MAX_CORRECTION = 100;
/** Most substeps by which a log is advanced to a state beyond the simulation: a frame at 100 × has 10,000, about 2 ms. */
const MAX_CARRIED = 12_000;

/**
 * Resets the log together with the player's ship to a server state, so that the log agrees with that state. Must be called while history and
 * replay are unchanged. Without a prediction for that tick a touch may have been missed: then there is no card, unless the ship is
 * still landed in the same place.
 */
export function rewindLog(track: Track, sim: Simulation, to: Adopted): void {
  if (!track.own) return;
  track.log ??= createTouchdownRing(track.history.length);
  const { replayed, front } = track.log;
  const state = to.rows[to.from + SURFACE_STATE]!;
  const known =
    redo(track, sim, track.log, to.tick) ||
    recall(track, track.log, to.tick) ||
    continueLog(track, sim, track.log, to.tick);
  if (track.replaySnaps || (known && wasMoved(sim, track, to))) beginLog(replayed, state);
  else if (known) alignState(replayed, track.log, sim, to);
  else if (front[LOGGED_STATE] === LANDED && state === LANDED && restsUnmoved(track, sim, to))
    replayed.set(front);
  else beginLog(replayed, state);
  keepLog(track.log, to.tick, replayed);
}

/**
 * Repeats the tick before the state with the inputs as the server applied them, so that the log contains the effect of a late input.
 */
function redo(track: Track, sim: Simulation, ring: TouchdownRing, tick: number): boolean {
  const kept = tick < 1 || logAt(ring, tick) === null ? null : logAt(ring, tick - 1);
  if (kept === null || !has(track.history, tick - 1) || !has(track.history, tick)) return false;
  ring.replayed.set(kept);
  copyRow(predicted, 0, track.history.rows, offsetOf(track.history, tick - 1));
  placeStep(step, sim, tick - 1, 0);
  return advanceLog(track, sim, ring, tick);
}

/** The prediction for a tick: row and log. */
function recall(track: Track, ring: TouchdownRing, tick: number): boolean {
  const kept = logAt(ring, tick);
  if (kept === null || !has(track.history, tick)) return false;
  ring.replayed.set(kept);
  copyRow(predicted, 0, track.history.rows, offsetOf(track.history, tick));
  return true;
}

/**
 * Advances only the log to a state beyond the simulation: the page draws seldom or is hidden.
 */
function continueLog(track: Track, sim: Simulation, ring: TouchdownRing, tick: number): boolean {
  const { fleet, front } = sim;
  if (track.replaying) {
    placeStep(step, sim, track.replayTick, track.replaySubstep);
    copyRow(predicted, 0, fleet.replayed, track.at);
  } else if (track.mode === 'stepping' && !sim.frontIsStale) {
    placeStep(step, sim, front.tick, front.substep);
    copyRow(predicted, 0, fleet.front, track.at);
    ring.replayed.set(ring.front);
  } else return false;
  return advanceLog(track, sim, ring, tick);
}

/** Advances the log and its row from `step` to a tick boundary; false if that is in the past or too far ahead. */
function advanceLog(track: Track, sim: Simulation, ring: TouchdownRing, tick: number): boolean {
  const ahead = indexOf(sim.timeline, tick, 0) - indexOf(sim.timeline, step.tick, step.substep);
  if (ahead < 0 || ahead > MAX_CARRIED) return false;
  for (let i = 0; i < ahead; i++) {
    advanceRow(step, sim, track);
    logSubstep(ring.replayed, sim.world, step);
  }
  return true;
}

const predicted = new Float64Array(SHIP_STRIDE);
const step = createRowStep(predicted);

/** Corrects the log where the state is on the ground and the prediction in flight, or the other way round. */
function alignState(log: Float64Array, ring: TouchdownRing, sim: Simulation, to: Adopted): void {
  const { tick, rows, from } = to;
  const state = rows[from + SURFACE_STATE]!;
  if (rows[from + CRASHED] === 1 || log[LOGGED_STATE] === state) return;
  if (log[LOGGED_STATE] === FLYING) {
    // Every touch has a speed: 0 is a state whose server did not send it.
    logTouch(log, rows[from + IMPACT_SPEED]! || -1, predicted, 0, boundaryAt(sim.bodies, sim.timeline, tick));
  } else if (state === FLYING && !undoTouch(log, ring, to)) logLiftOff(log, sim.world, rows, from);
  logState(log, state);
}

/**
 * A falling ship that was predicted to touch in the last tick has not touched: its log is that of a tick ago. A rising ship has
 * touched and left. A hop shorter than a tick that ends in a fall counts as no touch: the server's state does not show it.
 */
function undoTouch(log: Float64Array, ring: TouchdownRing, { tick, rows, from }: Adopted): boolean {
  let rising = 0;
  for (let k = 0; k < 3; k++) rising += rows[from + VELOCITY + k]! * rows[from + POSITION + k]!;
  const earlier = tick < 1 ? null : logAt(ring, tick - 1);
  if (rising > 0 || earlier === null || earlier[LOGGED_STATE] !== FLYING) return false;
  log.set(earlier);
  return true;
}

/** Whether the ship is at another body, or farther away than it could have flown while the server was silent. */
function wasMoved({ timeline }: Simulation, { silence }: Track, { tick, rows, from }: Adopted): boolean {
  if (predicted[REFERENCE_BODY] !== rows[from + REFERENCE_BODY]) return true;
  let way = 0;
  let speed = 0;
  for (let k = 0; k < 3; k++) {
    way += (rows[from + POSITION + k]! - predicted[POSITION + k]!) ** 2;
    speed += rows[from + VELOCITY + k]! ** 2;
  }
  return Math.sqrt(way) > MAX_CORRECTION + Math.sqrt(speed) * silence * spanOf(timeline, tick).timeScale;
}

/** Whether the ship is landed in its sleeping pose, in the body's axes. */
function restsUnmoved({ sleepPlace }: Track, sim: Simulation, { tick, rows, from }: Adopted): boolean {
  const body = rows[from + REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE;
  take(attitude, boundaryAt(sim.bodies, sim.timeline, tick), body);
  take(place, rows, from + POSITION);
  rotateBack(place, attitude, place);
  for (let k = 0; k < 3; k++) place[k]! -= sleepPlace[k]!;
  return lengthOf(place) <= MAX_CORRECTION;
}

const attitude = quaternion();
const place = vector();
