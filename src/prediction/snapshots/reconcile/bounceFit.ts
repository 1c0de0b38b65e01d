import {
  FLYING,
  IMPACT_SPEED,
  POSITION,
  REFERENCE_BODY,
  SURFACE_STATE,
  VELOCITY,
  type World,
} from '../../../dynamics';
import { has, offsetOf } from '../../simulation/rings/history';
import type { Simulation } from '../../simulation/simulation';
import type { Track } from '../../simulation/track';
import type { Place } from './compare';
import type { ComparedState } from './lawErrors';

/** Weight of the earlier touches at the next one. */
const KEPT = 0.8;
/** s by which a predicted stay on the ground was wrong for longer than it was right: the ship is then shown in flight. */
const WORSE = 0.02;

/**
 * Learns whether a ship bounces where the dynamics keep it on the ground, as on a server with stiffer springs. It weighs, of each touch
 * predicted since a state in flight, the time on the ground: right if the server has it on the ground too, wrong if it climbs again.
 */
export function learnBounce(
  { world }: Simulation,
  track: Track,
  { state, tick, predicted }: ComparedState,
  tickRate: number,
): void {
  const { fit, evidence } = track;
  if (predicted === null || evidence.row[SURFACE_STATE] !== FLYING) return;
  if (predicted.rows[predicted.at + SURFACE_STATE] === FLYING) return;
  const bounced = state.rows[SURFACE_STATE] === FLYING;
  if (bounced && along(state.rows) <= 0) return;
  const seconds = ticksOnGround(track, tick) / tickRate;
  fit.groundedWrongly = fit.groundedWrongly * KEPT + (bounced ? seconds : 0);
  fit.groundedRightly = fit.groundedRightly * KEPT + (bounced ? 0 : seconds);
  if (bounced)
    fit.rebound = reboundOf(world, state, predicted) / predicted.rows[predicted.at + IMPACT_SPEED]!;
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

/** The speed, m/s, at which the ship left the ground that it is predicted to be on. */
function reboundOf({ bodies }: World, { rows }: Place, predicted: Place): number {
  const distance = distanceOf(rows, 0);
  const climb = along(rows) / distance;
  const height = distance - distanceOf(predicted.rows, predicted.at);
  const gravity = bodies[rows[REFERENCE_BODY]!]!.gravityParameter / (distance * distance);
  return Math.sqrt(Math.max(0, climb * climb + 2 * gravity * height));
}

function distanceOf(rows: Float64Array, at: number): number {
  return Math.hypot(rows[at + POSITION]!, rows[at + POSITION + 1]!, rows[at + POSITION + 2]!);
}

/** Position · velocity, m²/s. */
function along(row: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += row[POSITION + k]! * row[VELOCITY + k]!;
  return sum;
}
