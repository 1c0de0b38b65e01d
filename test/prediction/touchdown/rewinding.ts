import { expect } from 'vitest';
import { IMPACT_SPEED, POSITION, SHIP_STRIDE, SURFACE_STATE, VELOCITY } from '../../../src/dynamics';
import { replayTo } from '../../../src/prediction/ground/trial';
import { keep } from '../../../src/prediction/simulation/rings/history';
import type { Simulation } from '../../../src/prediction/simulation/simulation';
import type { Track } from '../../../src/prediction/simulation/track';
import {
  beginLog,
  createTouchdownView,
  fillTouchdown,
  LOG_STRIDE,
  LOGGED_STATE,
  logTouch,
  logState,
} from '../../../src/prediction/touchdown/touchdownLog';
import { createTouchdownRing, keepLog, logAt } from '../../../src/prediction/touchdown/touchdownRing';
import { rewindLog } from '../../../src/prediction/touchdown/touchdownRewind';
import { sessionAt, shipAt } from '../decisions/sessionAt';

export const TICK = 100;
/** Ticks until a ship that is 6 m above the ground and sinks at 2.5 m/s has touched it. */
export const FALL = 22;
const NO_BODIES = new Float64Array(12);

/** The player's ship, falling, in step at TICK; without a history. */
export function falling() {
  const { sim } = sessionAt(TICK);
  sim.frontIsStale = false;
  const track = shipAt(sim, 'own', '');
  track.own = true;
  track.log = createTouchdownRing(track.history.length);
  return { sim, track, ring: track.log };
}

/** The row of a falling ship `ticks` later, by the dynamics. */
export const fallen = (sim: Simulation, track: Track, ticks: number) =>
  replayTo(sim, track, { from: track.serverRow, fromTick: TICK, toTick: TICK + ticks }).slice();

/** A log of a ship in `state`, after a touch at `speed` if there is one, m/s. */
export function logOf(state: number, speed?: number): Float64Array {
  const log = new Float64Array(LOG_STRIDE);
  beginLog(log, state);
  if (speed !== undefined) logTouch(log, speed, new Float64Array(SHIP_STRIDE).fill(1), 0, NO_BODIES);
  logState(log, state);
  return log;
}

/** The rate of climb along the radius, m/s. */
export function climbAt(row: Float64Array, climb: number): Float64Array {
  const distance = Math.hypot(...row.subarray(POSITION, POSITION + 3));
  for (let k = 0; k < 3; k++) row[VELOCITY + k] = (climb * row[POSITION + k]!) / distance;
  return row;
}

/** The card after the log was rewound to a state of `tick`, and the surface state it then has. */
export function cardAfter(sim: Simulation, track: Track, row: Float64Array, tick: number) {
  rewindLog(track, sim, { tick, rows: row, from: 0 });
  const ring = track.log!;
  const card = createTouchdownView();
  fillTouchdown(card, ring.replayed, true);
  expect([...logAt(ring, tick)!]).toEqual([...ring.replayed]);
  return { ...card, state: ring.replayed[LOGGED_STATE] };
}

/** The card where the prediction for TICK had the log `log`, a tick after `earlier`, and the server sends `change` of its row. */
export function cardWhere(
  log: Float64Array,
  change: (row: Float64Array, all: ReturnType<typeof falling>) => void,
  earlier?: Float64Array,
) {
  const all = falling();
  const { sim, track, ring } = all;
  keep(track.history, TICK, track.serverRow, 0);
  keepLog(ring, TICK, log);
  if (earlier) keepLog(ring, TICK - 1, earlier);
  const row = track.serverRow.slice();
  change(row, all);
  return cardAfter(sim, track, row, TICK);
}

export const inState =
  (state: number, impact = 0, climb?: number) =>
  (row: Float64Array) => {
    row[SURFACE_STATE] = state;
    row[IMPACT_SPEED] = impact;
    if (climb !== undefined) climbAt(row, climb);
  };
