import { commandsAnything } from '../simulation/heldControls';
import type { Simulation } from '../simulation/simulation';
import { boundaryAt } from '../snapshots/bodies/bodyTrack';
import { spanOf } from '../time/timeline';
import { createObservation, observe } from './observe';
import type { Evidence } from './trial';

/**
 * The ground below a bounce between two states in flight. The falls before and after it meet at the ground, whatever the server's spring
 * and damping are: only the duration of the contact is taken from the dynamics.
 */

/** s: the contact of a bounce, half a period of the spring (100 s⁻²); and the share by which a server's may differ. */
const CONTACT_SECONDS = 0.3;
const UNSURE = 0.3;
/** m: smaller differences between the grounds are not learned from a bounce, nor are larger ones. */
const NOTABLE = 0.1;
const LARGEST = 1.5;
/** Of the speed of the fall: a slower rebound may be the second. */
const LEAST_REBOUND = 0.2;

/** The server's ground above ours, m, below the bounce between two states; null if there is no bounce, or nothing new. */
export function groundOfBounce(
  { world, timeline, bodies }: Simulation,
  { from, to, fromTick, toTick }: Evidence,
  known: number,
): number | null {
  if (commandsAnything(from, 0)) return null;
  observe(after, to, boundaryAt(bodies, timeline, toTick), world);
  observe(before, from, boundaryAt(bodies, timeline, fromTick), world);
  if (before.grounded || after.grounded) return null;
  const seconds = (toTick - fromTick) * spanOf(timeline, fromTick).timing.tickSeconds;
  const { feet, climb, gravity } = before;
  // Both falls are parabolas of one curvature: their difference is linear in time, and zero where they meet.
  const turn = after.climb - climb + gravity * seconds;
  const met = (feet - after.feet + (after.climb + (gravity * seconds) / 2) * seconds) / turn;
  const fall = gravity * met - climb;
  const rebound = after.climb + gravity * (seconds - met);
  // Below the bounce speed the duration of a contact is unknown.
  const bounced = fall > world.settings.contactBounceSpeed && rebound > LEAST_REBOUND * fall;
  if (!(met > 0 && met < seconds && bounced)) return null;
  const depth = (CONTACT_SECONDS * fall * rebound) / (fall + rebound);
  const offset = feet + (climb - (gravity * met) / 2) * met + depth;
  const apart = Math.abs(offset - known);
  return apart > NOTABLE + UNSURE * depth && apart < LARGEST ? offset : null;
}

const before = createObservation();
const after = createObservation();
