import { NO_EVENT, REFERENCE_BODY, SHIP_STRIDE } from '../../dynamics';
import { turnPicture } from '../drawn/changeBody';
import { easeUprighting } from '../drawn/snap/uprighting';
import { applyDue, seek } from '../inputs/scheduledInput';
import type { Position } from '../time/timeline';
import { keep } from './rings/history';
import type { Simulation } from './simulation';
import { enterSubstep, leaveSubstep, placeStep, stepRow } from './stepRow';
import { copyRow, type Track } from './track';
import type { RowStep } from './rowStep';

/** Moves the front: every ship in step, substep by substep, up to the present. */

/** Steps every ship in step to `target`, which is not before the front. */
export function stepFront(sim: Simulation, target: Position): void {
  const { front, fleet } = sim;
  const step = sim.steps.front;
  placeStep(step, sim, front.tick, front.substep);
  step.rows = fleet.front;
  step.before = fleet.previous;
  while (front.tick < target.tick || (front.tick === target.tick && front.substep < target.substep)) {
    if (fleet.own !== null && fleet.own.mode !== 'stepping') commandIdle(sim, fleet.own, step);
    enterSubstep(step, sim);
    stepShips(sim, step);
    const isBoundary = leaveSubstep(step, sim);
    front.tick = step.tick;
    front.substep = step.substep;
    if (!isBoundary) continue;
    keepBoundary(sim);
    sim.features.checkRollback?.(sim, front.tick);
  }
}

function stepShips(sim: Simulation, step: RowStep): void {
  const { tracks } = sim.fleet;
  let stepped = 0;
  for (let i = 0; i < tracks.length; i++) {
    const track = tracks[i]!;
    if (track.mode !== 'stepping') continue;
    step.at = track.at;
    step.beforeAt = track.at;
    stepRow(step, sim, track);
    stepped += 1;
    const body = step.rows[step.at + REFERENCE_BODY]!;
    if (track.picture.body !== body) turnPicture(track.picture, step.bodies, body);
    track.picture.sinceUprighting += 1;
    if (step.event !== NO_EVENT) report(sim, track, step);
    if (track.log !== null) sim.features.touchdown?.logSubstep(track.log.front, sim.world, step);
  }
  sim.counters.steppedSubsteps += stepped;
}

function report(sim: Simulation, track: Track, step: RowStep): void {
  sim.features.events?.recordPredicted(sim, track, step.event, step, track.pass);
  easeUprighting(sim, track, step);
}

/** Applies inputs to the player's ship while it is out of step: its row still shows its pilot's controls, and an input that burns wakes it. */
function commandIdle(sim: Simulation, own: Track, step: RowStep): void {
  const { fleet, front, inputs } = sim;
  const cursor = seek(inputs, front.tick, front.substep);
  copyRow(probe, 0, fleet.front, own.at);
  const next = applyDue(inputs, cursor, front, probe, 0);
  step.inputs = cursor;
  if (next === cursor) return;
  if (sim.sleep?.wakeIfBurning(sim, own, probe) !== true) copyRow(fleet.front, own.at, probe, 0);
}

const probe = new Float64Array(SHIP_STRIDE);

function keepBoundary(sim: Simulation): void {
  const { fleet, front } = sim;
  for (const track of fleet.tracks) {
    if (track.mode !== 'stepping') continue;
    keep(track.history, front.tick, fleet.front, track.at);
    if (track.log !== null) sim.features.touchdown?.keepLog(track.log, front.tick, track.log.front);
  }
}
