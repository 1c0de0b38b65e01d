import { actsBetween } from '../../inputs/scheduledInput';
import { hold, startReplay } from '../../simulation/replay';
import type { Simulation } from '../../simulation/simulation';
import { indexOf, type Position, spanOf } from '../../time/timeline';

/** The front waits for a present that is at most this far behind, wall s. */
const MAX_BEHIND = 0.25;

/** After a larger step of the clock the drawn pose snaps, game s. */
const MAX_SKIPPED = 2;

/** Whether the present is so far behind the simulation that the ships must be reset. */
export function isFarBehind(sim: Simulation, target: Position): boolean {
  const { timeline, front } = sim;
  const behind =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, target.tick, target.substep);
  const { timing, timeScale } = spanOf(timeline, target.tick);
  return behind > 2 && (behind * timing.dt) / timeScale > MAX_BEHIND;
}

/** Why the front is moved. */
export interface Realignment {
  /** Time has passed differently than simulated; false if only its division into ticks and substeps changed. */
  readonly resync: boolean;
  /** The clock was corrected at once while page and server were running. */
  readonly stepped: boolean;
}

/**
 * Moves the front to the present without simulating the time between: every ship in step keeps its drawn pose and is replayed from the
 * server's newest state (PREDICTION, Absence) or, if only the division of time changed, from its state after the newest frame. The
 * player's ship is replayed too if it sleeps and an input acts in that time.
 */
export function realign(sim: Simulation, target: Position, how: Realignment): void {
  const skipped = how.stepped ? skippedTo(sim, target) : 0;
  const { own } = sim.fleet;
  if (own?.mode === 'sleeping' && actsBetween(sim.inputs, sim.front.tick, target.tick + 1))
    sim.sleep?.holdSleeping(own);
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

/** Game s from the front to `target`, 0 if that is too far for easing. */
function skippedTo({ timeline, front }: Simulation, target: Position): number {
  const substeps =
    indexOf(timeline, target.tick, target.substep) - indexOf(timeline, front.tick, front.substep);
  const seconds = Math.abs(substeps) * spanOf(timeline, target.tick).timing.dt;
  return seconds <= MAX_SKIPPED ? seconds : 0;
}
