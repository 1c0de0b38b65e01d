import { CRASHED, POSITION, SURFACE_STATE, VELOCITY } from '../../dynamics';
import type { Simulation } from '../simulation/simulation';
import { advanceRow, placeStep } from '../simulation/stepRow';
import { copyRow, type Track } from '../simulation/track';
import { createRowStep } from '../simulation/rowStep';
import type { GroundPlace } from './learnedGround';

/** Two server states of one ship, between which the dynamics depend on the ground. */
export interface Evidence {
  readonly from: Float64Array;
  readonly fromTick: number;
  readonly to: Float64Array;
  readonly toTick: number;
}

/** The error of the dynamics, replayed from the first state, at the second. */
export interface Misfit {
  /** m and m/s along the radius, predicted − server. */
  height: number;
  climb: number;
  /** m along the ground. */
  along: number;
  /** The same surface state. */
  sameState: boolean;
}

export const createMisfit = (): Misfit => ({
  height: Number.NaN,
  climb: Number.NaN,
  along: Number.NaN,
  sameState: false,
});

/** Errors of cost 1: m, m/s, m. */
const HEIGHT = 0.05;
const CLIMB = 0.25;
const ALONG = 0.3;
/** Cost of a surface state that differs from the server's. */
const OTHER_STATE = 4;
/** Offset and slope of cost 1, since small ones are likelier: m, m/m. */
const OFFSET = 5;
const SLOPE = 0.5;

/**
 * Replays the dynamics from one state to the tick of another, on the track's present ground. Returns the row there, valid until the
 * next replay.
 */
export function replayTo(
  sim: Simulation,
  track: Track,
  { from, fromTick, toTick }: Omit<Evidence, 'to'>,
): Float64Array {
  const row = step.rows;
  copyRow(row, 0, from, 0);
  placeStep(step, sim, fromTick, 0);
  const { fit } = track;
  const { extrapolated } = fit;
  fit.extrapolated = '';
  while (step.tick < toTick) advanceRow(step, sim, track);
  fit.extrapolated = extrapolated;
  return row;
}

/** Replays the dynamics from one state to the other and measures the error there. Returns the replayed row, as replayTo does. */
export function replayBetween(out: Misfit, sim: Simulation, track: Track, evidence: Evidence): Float64Array {
  const { to } = evidence;
  const row = replayTo(sim, track, evidence);
  const distance = Math.hypot(to[POSITION]!, to[POSITION + 1]!, to[POSITION + 2]!);
  let height = 0;
  let climb = 0;
  let squared = 0;
  for (let k = 0; k < 3; k++) {
    const n = to[POSITION + k]! / distance;
    const apart = row[POSITION + k]! - to[POSITION + k]!;
    height += apart * n;
    squared += apart * apart;
    climb += (row[VELOCITY + k]! - to[VELOCITY + k]!) * n;
  }
  out.height = height;
  out.climb = climb;
  out.along = Math.sqrt(Math.max(0, squared - height * height));
  out.sameState = row[SURFACE_STATE] === to[SURFACE_STATE] && row[CRASHED] === to[CRASHED];
  return row;
}

/** The cost of a ground: below 1 it explains the two states. */
export function costOf({ height, climb, along, sameState }: Misfit, place: GroundPlace | null): number {
  const steep = place === null ? 0 : Math.hypot(place.slope[0]!, place.slope[1]!, place.slope[2]!);
  return (
    (height / HEIGHT) ** 2 +
    (climb / CLIMB) ** 2 +
    (along / ALONG) ** 2 +
    (sameState ? 0 : OTHER_STATE) +
    ((place?.offset ?? 0) / OFFSET) ** 2 +
    (steep / SLOPE) ** 2
  );
}

const step = createRowStep();
