import { chooseReferenceBody, substep } from '../../dynamics';
import { applyDue, seek } from '../inputs/scheduledInput';
import { boundaryAt, rowsAt } from '../snapshots/bodies/bodyTrack';
import { spanOf } from '../time/timeline';
import { isReleased, release } from './heldControls';
import type { Simulation } from './simulation';
import { copyRow, type Track } from './track';
import type { RowStep } from './rowStep';

/** Sets the row's time to the start of substep `substep` of `tick`. */
export function placeStep(step: RowStep, sim: Simulation, tick: number, substepOfTick: number): void {
  step.tick = tick;
  step.substep = substepOfTick;
  step.inputs = seek(sim.inputs, tick, substepOfTick);
}

/** Reads what all ships share in the next substep. */
export function enterSubstep(step: RowStep, sim: Simulation): void {
  step.dt = spanOf(sim.timeline, step.tick).step;
  step.bodies = rowsAt(sim.bodies, sim.timeline, step.tick, step.substep);
}

/**
 * Advances one ship by one substep: re-base at a tick's start, save, apply the controls that act from here on, advance by the law
 * (DYNAMICS, Frame and One substep).
 */
export function stepRow(step: RowStep, sim: Simulation, track: Track): void {
  const { rows, at } = step;
  if (step.substep === 0)
    chooseReferenceBody(rows, at, boundaryAt(sim.bodies, sim.timeline, step.tick), sim.world);
  if (step.keepsBefore) copyRow(step.before, step.beforeAt, rows, at);
  if (isReleased(track, step.tick, step.substep)) release(rows, at);
  if (track.own) step.inputs = applyDue(sim.inputs, step.inputs, step, rows, at);
  const { ground } = track;
  const world = ground.reading === null ? sim.world : ground.reading.worldOf(ground, sim.world);
  if (track.fit.extrapolated === '') step.event = substep(rows, at, step.bodies, world, step.dt[0]);
  else sim.features.extrapolate?.(step, sim, track);
}

/** Moves to the next substep. Returns whether a tick boundary was reached. */
export function leaveSubstep(step: RowStep, sim: Simulation): boolean {
  step.substep += 1;
  if (step.substep < spanOf(sim.timeline, step.tick).timing.substeps) return false;
  step.tick += 1;
  step.substep = 0;
  return true;
}

/** Advances one ship alone by one substep. Returns whether a tick boundary was reached. */
export function advanceRow(step: RowStep, sim: Simulation, track: Track): boolean {
  enterSubstep(step, sim);
  stepRow(step, sim, track);
  return leaveSubstep(step, sim);
}
