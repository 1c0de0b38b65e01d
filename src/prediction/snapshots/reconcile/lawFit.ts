import {
  ATTITUDE,
  BODY_ATTITUDE,
  BODY_STRIDE,
  GROUND_CONTACT_OFFSET,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
} from '../../../dynamics';
import { angleOf, quaternion, rotateBack, take, rotationBetween, vector } from '../../drawn/rotation';
import { createMisfit, replayBetween } from '../../ground/trial';
import { actsBetween } from '../../inputs/scheduledInput';
import { extrapolateRow } from '../../simulation/extrapolate';
import type { Simulation } from '../../simulation/simulation';
import { copyRow, type Track } from '../../simulation/track';
import { spanOf } from '../../time/timeline';
import { boundaryAt, knowsBoundary } from '../bodies/bodyTrack';
import { sameCommand } from '../../inputs/command';
import { learnBounce } from './bounceFit';
import type { Place } from './compare';
import { type ComparedState, type LawFit, WINDOW } from './lawErrors';

/** States needed for a decision. */
const NEEDED = 3;
/** A ship is extrapolated if the dynamics are worse by this factor and by this much per state, m; simulated again once they are not. */
const WORSE = 1.25;
const NOTABLE = 0.03;
const TAKEN_UP = 0.02;
/** Most substeps between two compared states; steps of an extrapolation. */
const MAX_INTERVAL = 400;
const PIECES = 10;

/** Compares the errors of the dynamics and of extrapolation at the last state. Returns whether the ship changes between them. */
export function chooseMotion(sim: Simulation, track: Track, compared: ComparedState): boolean {
  const { fit } = track;
  if (fit.extrapolated === 'ground') return false;
  if (!isComparable(sim, track, compared)) return false;
  learnBounce(sim, track, compared, spanOf(sim.timeline, compared.tick).tickRate);
  const slot = fit.count % WINDOW;
  fit.count += 1;
  const isExtrapolated = fit.extrapolated !== '';
  fit.law[slot] = compared.agrees && !isExtrapolated ? 0 : lawError(sim, track, compared);
  fit.extrapolation[slot] = compared.agrees && !isExtrapolated ? 0 : extrapolationError(sim, track, compared);
  const next = chosenMotion(fit);
  if (next === fit.extrapolated) return false;
  fit.extrapolated = next;
  return true;
}

/** The motion that fits the last states better: '' for the dynamics, `law` for extrapolation. Near a tie the ship keeps its present one. */
function chosenMotion(fit: LawFit): LawFit['extrapolated'] {
  const states = Math.min(fit.count, WINDOW);
  if (states < NEEDED) return fit.extrapolated;
  const law = sumOf(fit.law);
  const extrapolation = sumOf(fit.extrapolation);
  if (fit.extrapolated === '') return law > WORSE * extrapolation + NOTABLE * states ? 'law' : '';
  return law <= extrapolation + TAKEN_UP * states ? '' : 'law';
}

/** Whether nothing but dynamics and ground determined the motion between the last state and this one. */
function isComparable(sim: Simulation, track: Track, { state, tick, predicted }: ComparedState): boolean {
  const { evidence } = track;
  // A late or lost input is no fault of the dynamics.
  if (predicted !== null && !sameCommand(predicted.rows, predicted.at, state.rows, 0)) return false;
  if (track.own && actsBetween(sim.inputs, evidence.tick, tick)) return false;
  if (evidence.tick < 0 || evidence.tick >= tick || !knowsBoundary(sim.bodies, evidence.tick)) return false;
  if (evidence.row[REFERENCE_BODY] !== state.rows[REFERENCE_BODY]) return false;
  const { timing, paused } = spanOf(sim.timeline, evidence.tick);
  const same = spanOf(sim.timeline, tick).timing.substeps === timing.substeps;
  return (
    same &&
    !paused &&
    (tick - evidence.tick) * timing.substeps <= MAX_INTERVAL &&
    sameCommand(evidence.row, 0, state.rows, 0)
  );
}

function lawError(sim: Simulation, track: Track, { state, tick, predicted }: ComparedState): number {
  if (track.fit.extrapolated === '') return predicted === null ? 0 : errorOf(predicted, state);
  const { evidence } = track;
  made.rows = replayBetween(misfit, sim, track, {
    from: evidence.row,
    fromTick: evidence.tick,
    to: state.rows,
    toTick: tick,
  });
  made.bodies = state.bodies;
  return errorOf(made, state);
}

function extrapolationError(sim: Simulation, { evidence }: Track, { state, tick }: ComparedState): number {
  const { tickSeconds } = spanOf(sim.timeline, tick).timing;
  const dt = ((tick - evidence.tick) * tickSeconds) / PIECES;
  const bodies = boundaryAt(sim.bodies, sim.timeline, evidence.tick);
  copyRow(extrapolated, 0, evidence.row, 0);
  for (let i = 0; i < PIECES; i++) extrapolateRow(extrapolated, 0, bodies, sim.world, dt);
  made.rows = extrapolated;
  made.bodies = state.bodies;
  return errorOf(made, state);
}

/** m: of the position relative to the body, and of the attitude times the ship's height. */
function errorOf(a: Place, b: Place): number {
  seen(place, a);
  seen(other, b);
  const apart = Math.hypot(place[0]! - other[0]!, place[1]! - other[1]!, place[2]! - other[2]!);
  take(attitude, a.rows, a.at + ATTITUDE);
  take(otherAttitude, b.rows, b.at + ATTITUDE);
  rotationBetween(turn, attitude, otherAttitude);
  return apart + b.rows[b.at + GROUND_CONTACT_OFFSET]! * angleOf(turn);
}

function seen(out: Float64Array, { rows, at, bodies }: Place): void {
  take(body, bodies, rows[at + REFERENCE_BODY]! * BODY_STRIDE + BODY_ATTITUDE);
  take(out, rows, at + POSITION);
  rotateBack(out, body, out);
}

function sumOf(errors: Float64Array): number {
  let sum = 0;
  for (const error of errors) sum += error;
  return sum;
}

const misfit = createMisfit();
const extrapolated = new Float64Array(SHIP_STRIDE);
const made: Place = { rows: extrapolated, at: 0, bodies: extrapolated };
const place = vector();
const other = vector();
const body = quaternion();
const attitude = quaternion();
const otherAttitude = quaternion();
const turn = quaternion();
