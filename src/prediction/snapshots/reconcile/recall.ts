/** Values that older servers do not send, from the ship's own prediction (PREDICTION, Reconciliation). */
import {
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  REFERENCE_BODY,
  SURFACE_STATE,
  WHEEL_MOMENTUM,
} from '../../../dynamics';
import { replayTo } from '../../ground/trial';
import type { Simulation, TickedRow } from '../../simulation/simulation';
import type { Track } from '../../simulation/track';
import { spanOf } from '../../time/timeline';
import { knowsBoundary } from '../bodies/bodyTrack';
import type { Place } from './compare';

/** Most substeps that are replayed for a touch. */
const MAX_REPLAY = 400;

/**
 * The impact speed of the contact that `row`, the ship's state at `tick`, is in, m/s. If the prediction has no such contact, as after
 * a pause in which no frame was drawn, it comes from the dynamics since the last state; 0, settling, where these do not touch either.
 */
export function recalledImpact(
  sim: Simulation,
  track: Track,
  state: TickedRow,
  predicted: Place | null,
): number {
  const { row } = state;
  if (predicted !== null && isSameContact(row, predicted.rows, predicted.at))
    return predicted.rows[predicted.at + IMPACT_SPEED]!;
  return row[SURFACE_STATE] === CONTACT ? (sim.features.replayImpact?.(sim, track, state) ?? 0) : 0;
}

/** The impact speed of the contact in which the dynamics since the last state end, m/s; 0 without one. */
export function replayImpact(sim: Simulation, track: Track, state: TickedRow): number {
  if (!canReplay(sim, track, state)) return 0;
  const { evidence } = track;
  const replayed = replayTo(sim, track, { from: evidence.row, fromTick: evidence.tick, toTick: state.tick });
  return isSameContact(state.row, replayed, 0) ? replayed[IMPACT_SPEED]! : 0;
}

function isSameContact(row: Float64Array, rows: Float64Array, at: number): boolean {
  return rows[at + SURFACE_STATE] !== FLYING && rows[at + REFERENCE_BODY] === row[REFERENCE_BODY];
}

/** Whether a replay from the last state to this one is possible and short enough. */
function canReplay({ bodies, timeline }: Simulation, { evidence }: Track, { row, tick }: TickedRow): boolean {
  if (evidence.tick < 0 || evidence.tick >= tick || !knowsBoundary(bodies, evidence.tick)) return false;
  if (evidence.row[CRASHED] === 1 || evidence.row[REFERENCE_BODY] !== row[REFERENCE_BODY]) return false;
  const { timing, paused } = spanOf(timeline, evidence.tick);
  return !paused && (tick - evidence.tick) * timing.substeps <= MAX_REPLAY;
}

/** Fills in the wheel momentum of `row` from the prediction; 0 without one. */
export function recallWheels(row: Float64Array, predicted: Place | null): void {
  for (let k = WHEEL_MOMENTUM; k < WHEEL_MOMENTUM + 3; k++)
    row[k] = predicted === null ? 0 : predicted.rows[predicted.at + k]!;
}
