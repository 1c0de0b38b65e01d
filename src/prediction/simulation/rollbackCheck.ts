import { SHIP_STRIDE, substep } from '../../dynamics';
import { applyDue, seek } from '../inputs/scheduledInput';
import { rowsAt } from '../snapshots/bodyTrack';
import { has, offsetOf } from './history';
import { beginTick, isReleased, release, type Simulation } from './simulation';
import { spanOf } from '../time/timeline';
import { copyRow, type Track } from './track';

/**
 * The sync test of rollback netcode: at tick boundary `tick` every ship in step goes back `ticks` ticks, is replayed with the stored
 * inputs, and must come out with the same bits. Anything a row does not hold, and anything a replay does otherwise than the front
 * did, shows here.
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
  let cursor = seek(sim.inputs, from, 0);
  for (at.tick = from; at.tick < to; at.tick++) {
    const { dt, substeps } = spanOf(sim.timeline, at.tick).timing;
    for (at.substep = 0; at.substep < substeps; at.substep++) {
      if (at.substep === 0) beginTick(sim, row, 0, at.tick);
      if (isReleased(track, at.tick, at.substep)) release(row, 0);
      if (track.own) cursor = applyDue(sim.inputs, cursor, at, row, 0);
      substep(row, 0, rowsAt(sim.bodies, sim.timeline, at.tick, at.substep), sim.world, dt);
    }
  }
}

const at = { tick: 0, substep: 0 };
const row = new Float64Array(SHIP_STRIDE);

/** Bits, not values: −0 is not 0. */
function sameBits(rows: Float64Array, from: number): boolean {
  for (let k = 0; k < SHIP_STRIDE; k++) if (!Object.is(rows[from + k], row[k])) return false;
  return true;
}
