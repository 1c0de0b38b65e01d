import { GROUND_CONTACT_OFFSET, SHIP_CLASS, type World } from '../../dynamics';
import { showWorld } from '../drawn/worldView';
import { withoutGround } from '../ground/unknownGround';
import { beginWorld, type Session } from '../session';
import { forgetAfter } from '../simulation/rings/history';
import { abandonReplay, hold } from '../simulation/replay';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import { forgetAfter as forgetBodiesAfter } from '../snapshots/bodies/bodyTrack';
import { sameBodies, type WorldConfig } from './worldConfig';
import { changeLongestSubstep } from '../time/timeline';
import { forgetLogsAfter } from '../touchdown/touchdownRing';

/**
 * Replaces settings, classes, terrain, masses and radii of the running world. Ships, time, inputs and listeners stay: each
 * ship continues from its newest server state, and the drawn pose fades into the new prediction. With other bodies, or before the first
 * frame, a new world begins.
 * @param config the config from which `world` was created
 */
export function changeWorld(session: Session, world: World, config: WorldConfig): void {
  const { sim, viewBuilder } = session;
  session.config = config;
  if (sim.newestTick < 0 || !sameBodies(sim.world, world)) {
    beginWorld(session, world, config.bodies);
    return;
  }
  const before = sim.world;
  for (const track of sim.fleet.tracks) {
    if (track.mode === 'stepping') hold(sim, track);
    sim.sleep?.holdSleeping(track);
  }
  sim.world = world;
  sim.groundless = withoutGround(world);
  changeLongestSubstep(sim.timeline, world.settings.contactLongestSubstep);
  forgetBodiesAfter(sim.bodies, sim.newestTick);
  for (const track of sim.fleet.tracks) carryOver(sim, track, before);
  sim.frontIsStale = true;
  showWorld(viewBuilder, sim);
}

/** Converts the ship's rows to the new world and puts it out of step until it has been replayed. */
function carryOver(sim: Simulation, track: Track, before: World): void {
  const { world, fleet } = sim;
  forgetAfter(track.history, -1);
  if (track.log !== null) forgetLogsAfter(track.log, -1);
  abandonReplay(track);
  track.agreedTick = -1;
  // The learned ground corrected the previous world.
  track.ground.places.length = 0;
  track.evidence.tick = -1;
  const isKnown = [fleet.previous, fleet.front, fleet.replayed]
    .map((rows) => renumber(rows, track.at, before, world))
    .every(Boolean);
  if (renumber(track.serverRow, 0, before, world) && isKnown) return;
  track.unpredictable = true;
  track.mode = 'held';
}

/**
 * Sets the row's class number in the new world, and the contact offset if it was the class's. Returns false for a class that no longer
 * exists.
 */
function renumber(rows: Float64Array, at: number, before: World, world: World): boolean {
  const old = before.shipClasses[rows[at + SHIP_CLASS]!]!;
  const number = world.shipClasses.findIndex(({ name }) => name === old.name);
  rows[at + SHIP_CLASS] = Math.max(0, number);
  const { groundContactOffset } = world.shipClasses[Math.max(0, number)]!;
  if (rows[at + GROUND_CONTACT_OFFSET] === old.groundContactOffset)
    rows[at + GROUND_CONTACT_OFFSET] = groundContactOffset;
  return number >= 0;
}
