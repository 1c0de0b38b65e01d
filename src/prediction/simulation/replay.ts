import { CRASHED, NO_EVENT } from '../../dynamics';
import { easeCorrection, holdDrawn, captureDrawn } from '../drawn/correction';
import { uprights } from '../drawn/snap/uprighting';
import { indexOf } from '../time/timeline';
import { keep } from './rings/history';
import type { Simulation } from './simulation';
import { enterSubstep, leaveSubstep, placeStep, stepRow } from './stepRow';
import { copyRow, type Track } from './track';
import type { RowStep } from './rowStep';

/**
 * Adopt and replay (PREDICTION, Reconciliation): a ship is reset to a state at a tick and simulated with all stored inputs since. What
 * exceeds a frame's budget continues in the next, while the old prediction is drawn and kept in step.
 */

/** Resets the ship to the row at `from` in `rows`, its state at tick boundary `tick`. */
export function startReplay(
  track: Track,
  sim: Simulation,
  tick: number,
  rows: Float64Array,
  from: number,
): void {
  const { replayed } = sim.fleet;
  sim.features.touchdown?.rewindLog(track, sim, { tick, rows, from });
  copyRow(replayed, track.at, rows, from);
  keep(track.history, tick, rows, from);
  if (track.mode === 'held') track.mode = 'waiting';
  track.replaying = true;
  track.replayTick = tick;
  track.replaySubstep = 0;
  track.adoptedTick = tick;
  track.replayPass = ++track.passes;
}

/** Cancels a replay in progress: a newer server state agrees with the prediction. */
export function abandonReplay(track: Track): void {
  track.replaying = false;
  track.replaySnaps = false;
}

/** Runs replays, that of the player's ship first, for at most `budget` substeps. Returns how many it took. */
export function runReplays(sim: Simulation, budget: number): number {
  let used = 0;
  for (const track of sim.fleet.tracks)
    if (track.own && track.replaying) used += replay(sim, track, budget - used);
  for (const track of sim.fleet.tracks) if (track.replaying) used += replay(sim, track, budget - used);
  sim.counters.replayedSubsteps += used;
  return used;
}

/** Runs one replay for at most `budget` substeps; once it reaches the front, the ship continues from there. */
function replay(sim: Simulation, track: Track, budget: number): number {
  const { fleet, front, timeline } = sim;
  const left =
    indexOf(timeline, front.tick, front.substep) - indexOf(timeline, track.replayTick, track.replaySubstep);
  if (left < 0) return 0;
  const steps = Math.min(left, budget);
  const step = sim.steps.replay;
  step.rows = fleet.replayed;
  step.at = track.at;
  if (left === 0) copyRow(step.before, 0, fleet.replayed, track.at);
  placeStep(step, sim, track.replayTick, track.replaySubstep);
  step.event = NO_EVENT;
  for (let i = 0; i < steps; i++) {
    // Only the log reads the row before each substep; drawing reads it for the last one.
    step.keepsBefore = left - i === 1 || track.log !== null;
    replaySubstep(sim, track, step);
  }
  track.replayTick = step.tick;
  track.replaySubstep = step.substep;
  if (steps === left) arrive(sim, track, step);
  return steps;
}

function replaySubstep(sim: Simulation, track: Track, step: RowStep): void {
  enterSubstep(step, sim);
  stepRow(step, sim, track);
  if (step.event !== NO_EVENT)
    sim.features.events?.recordPredicted(sim, track, step.event, step, track.replayPass);
  if (track.log !== null) sim.features.touchdown?.logSubstep(track.log.replayed, sim.world, step);
  if (!leaveSubstep(step, sim)) return;
  keep(track.history, step.tick, step.rows, track.at);
  if (track.log !== null) sim.features.touchdown?.keepLog(track.log, step.tick, track.log.replayed);
}

/** The replay has reached the front and becomes the prediction; the drawn pose fades into it. */
function arrive(sim: Simulation, track: Track, step: RowStep): void {
  const { fleet } = sim;
  const { at } = track;
  const shown = captureDrawn(sim, track);
  const respawned = fleet.front[at + CRASHED]! > step.rows[at + CRASHED]!;
  copyRow(fleet.previous, at, step.before, 0);
  copyRow(fleet.front, at, step.rows, at);
  track.log?.front.set(track.log.replayed);
  track.replaying = false;
  track.pass = track.replayPass;
  track.mode = 'stepping';
  easeCorrection(sim, track, shown, {
    snaps: track.replaySnaps || respawned,
    uprights: uprights(sim, step.event),
  });
  track.replaySnaps = false;
}

/**
 * Takes a ship out of step because it must be replayed to another front; until then its drawn pose is held in
 * the body's axes.
 */
export function hold(sim: Simulation, track: Track): void {
  if (track.mode === 'stepping') holdDrawn(sim, track);
  track.mode = 'waiting';
}
