import { FLYING, POSITION, SURFACE_STATE, VELOCITY } from '../../../dynamics';
import { has, offsetOf } from '../../simulation/history';
import type { Track } from '../../simulation/track';
import type { Judged } from './lawErrors';

/** Weight of the earlier touches at the next one. */
const KEPT = 0.8;
/** s by which a predicted stay on the ground was wrong for longer than it was right: the ship is then shown in flight. */
const WORSE = 0.02;

/**
 * Learns whether a ship bounces where the dynamics keep it on the ground, as on a server with stiffer springs. It weighs, of each touch
 * predicted since a state in flight, the time on the ground: right if the server has it on the ground too, wrong if it climbs again.
 */
export function weighBounce(track: Track, { state, tick, predicted }: Judged, tickRate: number): void {
  const { fit, evidence } = track;
  if (predicted === null || evidence.row[SURFACE_STATE] !== FLYING) return;
  if (predicted.rows[predicted.at + SURFACE_STATE] === FLYING) return;
  const bounced = state.rows[SURFACE_STATE] === FLYING;
  if (bounced && !climbs(state.rows)) return;
  const seconds = ticksOnGround(track, tick) / tickRate;
  fit.groundedWrongly = fit.groundedWrongly * KEPT + (bounced ? seconds : 0);
  fit.groundedRightly = fit.groundedRightly * KEPT + (bounced ? 0 : seconds);
  fit.bounces = fit.groundedWrongly > fit.groundedRightly + WORSE;
}

/** The predicted ticks on the ground up to `tick`, since the last state. */
function ticksOnGround({ history, evidence }: Track, tick: number): number {
  let first = tick;
  while (first - 1 > evidence.tick && has(history, first - 1)) {
    if (history.rows[offsetOf(history, first - 1) + SURFACE_STATE] === FLYING) break;
    first -= 1;
  }
  return tick - first + 1;
}

function climbs(row: Float64Array): boolean {
  let along = 0;
  for (let k = 0; k < 3; k++) along += row[POSITION + k]! * row[VELOCITY + k]!;
  return along > 0;
}
