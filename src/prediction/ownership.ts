import { EVENT_DESTROYED } from '../dynamics';
import { confirm } from './events';
import { forgetRecords } from './inputs/inputs';
import { beginWorld, type Session } from './session';
import { forgetAfter } from './simulation/history';
import { holdSleeping } from './simulation/sleep';
import type { Simulation } from './simulation/simulation';
import { startReplay } from './simulation/replay';
import { copyRow, removeTrack, type Track } from './simulation/track';
import { forgetPending } from './snapshots/pending';
import { loadConfig } from './snapshots/worldConfig';
import { forgetPings } from './time/pings';

/** Whose ship is whose (PREDICTION, Ownership): what the caller says, and what the server's word comes to. */

/** Why a ship is no longer there. */
export type Removal = 'destroyed' | 'docked' | 'gone';

/** From now on the client flies `shipId` ('' for none). Inputs belong to the ship they were made for: the old ship's are dropped. */
export function changeOwnShip(session: Session, shipId: string): void {
  const { receiver, sim, pilot } = session;
  if (receiver.ownShipId === shipId) return;
  receiver.ownShipId = shipId;
  forgetRecords(sim.inputs);
  pilot.last = null;
  pilot.released = null;
  const { fleet } = sim;
  if (fleet.own !== null) giveUp(sim, fleet.own);
  fleet.own = fleet.byId.get(shipId) ?? null;
  if (fleet.own !== null) fleet.own.own = true;
}

/** Another pilot's from now on, or nobody's: back to the server's word, without what was commanded here. */
function giveUp(sim: Simulation, track: Track): void {
  track.own = false;
  track.log = null;
  if (track.mode === 'sleeping') {
    copyRow(sim.fleet.front, track.at, track.serverRow, 0);
    copyRow(sim.fleet.previous, track.at, track.serverRow, 0);
  } else if (track.serverTick >= 0 && track.mode !== 'held') {
    startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

/** The ship leaves the list at once. Frames already received do not bring it back; a later one does. */
export function dropShip({ sim, receiver }: Session, shipId: string, reason: Removal): void {
  receiver.removed.set(shipId, sim.newestTick);
  const track = sim.fleet.byId.get(shipId);
  if (track === undefined) return;
  if (reason === 'destroyed' && sim.newestTick >= 0) {
    const notice = confirm(track.ledger, EVENT_DESTROYED, birthOfEnd(sim), sim.timeline);
    if (notice !== null) sim.notices.push(notice);
  }
  if (track.own) forgetRecords(sim.inputs);
  removeTrack(sim.fleet, track);
}

/** The server says no more than that it was destroyed: by the newest tick it told of. */
function birthOfEnd({ newestTick }: Simulation): { tick: number; substep: number } {
  return { tick: newestTick, substep: 0 };
}

/** The next state of the ship is where it is: it is shown there at once, and no prediction error is counted. */
export function expectTeleport({ sim }: Session, shipId: string): void {
  const track = sim.fleet.byId.get(shipId);
  if (track === undefined) return;
  if (track.mode === 'sleeping') holdSleeping(track);
  forgetAfter(track.history, -1);
  track.states = null;
  track.replaySnaps = true;
}

/** Ships, time, inputs and the clock are forgotten; the world that a hello told, the own ship and listeners stay. */
export function resetSession(session: Session): void {
  const { config, terrains, pilot, pings, pending } = session;
  const world = loadConfig(config, terrains);
  forgetPending(pending);
  if (world.ok) beginWorld(session, world.value, config.bodies);
  forgetPings(pings);
  pilot.last = null;
  pilot.released = null;
  session.advancedAt = Number.NaN;
}
