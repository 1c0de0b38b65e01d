import {
  BODY_ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_POSITION,
  BODY_STRIDE,
  BODY_VELOCITY,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  VELOCITY,
} from '../../../dynamics';
import { rowToIcrf } from '../../drawn/interpolate';
import { quaternion, take, vector } from '../../drawn/rotation';
import { boundaryAt, knowsBoundary } from '../bodies/bodyTrack';
import { createServerStates, rowToBodyAxes, type ServerStates } from '../../simulation/rings/serverStates';
import type { Boundary, Simulation } from '../../simulation/simulation';
import type { Track } from '../../simulation/track';

/** States kept: a burst after a stall brings several at once. */
const KEPT = 8;

/** Keeps the state `row` of `tick`. If it is relative to another body than the earlier ones, they are converted to it. */
export function keepServerState(
  sim: Simulation,
  track: Track,
  row: Float64Array,
  { tick, bodies }: Boundary,
): void {
  const states = (track.states ??= createServerStates());
  rebaseStates(states, sim, row[REFERENCE_BODY]!);
  const { ticks, rows } = states;
  const kept = rows.length < KEPT ? new Float64Array(SHIP_STRIDE) : rows.shift()!;
  if (ticks.length === KEPT) ticks.shift();
  kept.set(row);
  rowToBodyAxes(kept, bodies);
  rows.push(kept);
  ticks.push(tick);
}

/**
 * Converts the kept states to another reference body, each by the bodies of its own tick, so that a ship is interpolated across the
 * change. States of ticks whose bodies are no longer known are dropped.
 */
function rebaseStates({ ticks, rows }: ServerStates, sim: Simulation, body: number): void {
  if (rows.at(-1)?.[REFERENCE_BODY] === body) return;
  while (ticks.length > 0 && !knowsBoundary(sim.bodies, ticks[0]!)) {
    ticks.shift();
    rows.shift();
  }
  for (const [i, row] of rows.entries()) rebase(row, boundaryAt(sim.bodies, sim.timeline, ticks[i]!), body);
}

function rebase(row: Float64Array, bodies: Float64Array, to: number): void {
  const old = row[REFERENCE_BODY]! * BODY_STRIDE;
  const next = to * BODY_STRIDE;
  take(attitude, bodies, old + BODY_ATTITUDE);
  take(spin, bodies, old + BODY_ANGULAR_VELOCITY);
  rowToIcrf(row, attitude, spin);
  for (let k = 0; k < 3; k++) {
    row[POSITION + k] =
      row[POSITION + k]! + (bodies[old + BODY_POSITION + k]! - bodies[next + BODY_POSITION + k]!);
    row[VELOCITY + k] =
      row[VELOCITY + k]! + (bodies[old + BODY_VELOCITY + k]! - bodies[next + BODY_VELOCITY + k]!);
  }
  row[REFERENCE_BODY] = to;
  rowToBodyAxes(row, bodies);
}

const attitude = quaternion();
const spin = vector();
