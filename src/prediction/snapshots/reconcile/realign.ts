import { hold, startReplay } from '../../simulation/replay';
import type { Simulation } from '../../simulation/simulation';
import { indexOf, type Position, spanOf } from '../../time/timeline';

/** A present this far behind the front is not waited for, wall s. */
const MAX_BEHIND = 0.25;

/** A step of the clock by more than this is another time, whose picture has nothing to do with the last one, game s. */
const MAX_SKIPPED = 2;

/** Whether the present has fallen so far behind what is simulated that the ships must go back. */
export function isFarBehind(sim: Simulation, target: Position): boolean {
  const { timeline, front } = sim;
  const behind =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, target.tick, target.substep);
  const { timing, timeScale } = spanOf(timeline, target.tick);
  return behind > 2 && (behind * timing.dt) / timeScale > MAX_BEHIND;
}

/** Why the front is put elsewhere. */
export interface Realignment {
  /** Time went on otherwise than it was simulated; false where it was only cut anew. */
  readonly resync: boolean;
  /** The clock was put right at once, with the page there and the server heard. */
  readonly stepped: boolean;
}

/**
 * Puts the front where the present is, without simulating what lies between: every ship in step is held as it is drawn and replayed
 * from the server's newest state (PREDICTION, Absence), or, where only time was cut anew, from where the
 * newest frame left it.
 */
export function realign(sim: Simulation, target: Position, how: Realignment): void {
  const skipped = how.stepped ? skippedTo(sim, target) : 0;
  for (const track of sim.fleet.tracks) {
    if (track.mode === 'stepping') hold(sim, track);
    if (track.picture.hasHeld) track.picture.skipped = skipped;
    if (track.mode !== 'waiting' || (track.replaying && !how.resync)) continue;
    if (track.serverTick >= 0 && track.serverTick <= target.tick)
      startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
  sim.front.tick = target.tick;
  sim.front.substep = target.substep;
  sim.alpha = 1;
  sim.frontIsStale = false;
}

/** Game s from the front to `target`, 0 where that is too far for one picture to go over into the other. */
function skippedTo({ timeline, front }: Simulation, target: Position): number {
  const substeps =
    indexOf(timeline, target.tick, target.substep) - indexOf(timeline, front.tick, front.substep);
  const seconds = Math.abs(substeps) * spanOf(timeline, target.tick).timing.dt;
  return seconds <= MAX_SKIPPED ? seconds : 0;
}
