import { SHIP_STRIDE } from '../../dynamics';
import { has, offsetOf } from './rings/history';
import type { Simulation } from './simulation';
import { advanceRow, placeStep } from './stepRow';
import { copyRow, type Track } from './track';
import { createRowStep } from './rowStep';

/**
 * The sync test of rollback netcode: at tick boundary `tick` every ship in step is reset by `ticks` ticks, replayed with the stored
 * inputs, and must have the same bits. It finds state that is missing from the row, and differences between replay and front.
 */
export function checkRollback(sim: Simulation, tick: number, ticks: number): void {
  for (const track of sim.fleet.tracks) {
    const from = tick - ticks;
    if (track.mode !== 'stepping' || track.replaying || track.adoptedTick > from || !has(track.history, from))
      continue;
    replayTo(sim, track, from, tick);
    sim.counters.rollbacksCompared += 1;
    if (!sameBits(sim.fleet.front, track.at)) sim.counters.rollbacksDifferent += 1;
  }
}

function replayTo(sim: Simulation, track: Track, from: number, to: number): void {
  copyRow(row, 0, track.history.rows, offsetOf(track.history, from));
  placeStep(step, sim, from, 0);
  while (step.tick < to) advanceRow(step, sim, track);
}

const row = new Float64Array(SHIP_STRIDE);
const step = createRowStep(row);

/** Compares bits, not values: −0 is not 0. */
function sameBits(rows: Float64Array, from: number): boolean {
  for (let k = 0; k < SHIP_STRIDE; k++) if (!Object.is(rows[from + k], row[k])) return false;
  return true;
}
