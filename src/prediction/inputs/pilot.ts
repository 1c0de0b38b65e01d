import { type Controls, loadControls } from '../../dynamics';
import { holdsCommand, sameControls } from './command';
import { isPlanned } from './scheduledInput';
import { releaseKeys, store } from './inputs';
import type { Simulation } from '../simulation/simulation';
import { createPosition, isBefore } from '../time/timeline';

/** The pilot's input device. */
export interface Pilot {
  last: Controls | null;
  /** Keys held before an absence, which count as released until they change. */
  released: Controls | null;
}

/** Context of a sample. */
export interface Sampling {
  /** Client wall s. */
  readonly now: number;
  /** Steering of the lead, s. */
  readonly steer: number;
  readonly granularity: 'substep' | 'tick';
}

export function createPilot(): Pilot {
  return { last: null, released: null };
}

/**
 * Samples own controls. Controls that differ from those in force, or already sent, become an input that acts from the front on or, with a
 * server of whole-tick inputs, from the next tick on. Controls that are not finite are ignored.
 */
export function sampleControls(sim: Simulation, pilot: Pilot, given: Controls, sampling: Sampling): void {
  const track = sim.fleet.own;
  if (track === null) return;
  const { front, inputs, fleet } = sim;
  const newest = inputs.records.at(-1);
  const pending = newest !== undefined && !isBefore(newest.tick, newest.substep, front.tick, front.substep);
  // The first sample ends the plan, even if it equals the controls in force.
  const takesOver = isPlanned(inputs, front);
  if (!takesOver && pilot.released === null && !pending && holdsCommand(fleet.front, track.at, given)) {
    pilot.last = given;
    return;
  }
  const checked = loadControls(given);
  if (!checked.ok) return;
  if (pilot.released !== null && !sameControls(checked.value, pilot.released)) pilot.released = null;
  pilot.last = checked.value;
  const wanted = pilot.released === null ? checked.value : releaseKeys(checked.value);
  const isNothingNew = pending
    ? sameControls(newest.record.controls, wanted)
    : holdsCommand(fleet.front, track.at, wanted);
  if (isNothingNew && !takesOver) return;
  const wait = sampling.granularity === 'tick' && front.substep > 0;
  stamp.tick = wait ? front.tick + 1 : front.tick;
  stamp.substep = wait ? 0 : front.substep;
  store(inputs, wanted, stamp, sampling.now, sampling.steer);
}

const stamp = createPosition();
