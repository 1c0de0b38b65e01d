import { forgetRecords } from './inputs/inputs';
import { beginWorld, type Session } from './session';
import { forgetAfter } from './simulation/rings/history';
import type { Simulation } from './simulation/simulation';
import { startReplay } from './simulation/replay';
import { copyRow, removeTrack, type Track } from './simulation/track';
import { loadConfig } from './lifecycle/worldConfig';
import { forgetPings } from './time/pings';

/** Ownership of ships (PREDICTION, Ownership), as set by the caller or the server. */

/** Why a ship was removed. */
export type Removal = 'destroyed' | 'docked' | 'gone';

/** Makes `shipId` the player's ship ('' for none). Inputs belong to the ship they were made for: the old ship's are dropped. */
export function changeOwnShip(session: Session, shipId: string): void {
  const { receiver, sim, pilot } = session;
  if (receiver.ownShipId === shipId) return;
  receiver.ownShipId = shipId;
  forgetRecords(sim.inputs);
  pilot.last = null;
  pilot.released = null;
  const { fleet } = sim;
  if (fleet.own !== null) releaseShip(sim, fleet.own);
  fleet.own = fleet.byId.get(shipId) ?? null;
  if (fleet.own !== null) fleet.own.own = true;
}

/** The ship now belongs to another pilot or to none: it returns to its server state, without the client's inputs. */
function releaseShip(sim: Simulation, track: Track): void {
  track.own = false;
  track.log = null;
  if (track.mode === 'sleeping') {
    copyRow(sim.fleet.front, track.at, track.serverRow, 0);
    copyRow(sim.fleet.previous, track.at, track.serverRow, 0);
  } else if (track.serverTick >= 0 && track.mode !== 'held') {
    startReplay(track, sim, track.serverTick, track.serverRow, 0);
  }
}

/** Removes the ship at once. Frames already received do not restore it; later ones do. */
export function dropShip({ sim, receiver }: Session, shipId: string, reason: Removal): void {
  receiver.removed.set(shipId, sim.newestTick);
  const track = sim.fleet.byId.get(shipId);
  if (track === undefined) return;
  if (reason === 'destroyed') sim.features.events?.confirmEnd(sim, track);
  if (track.own) forgetRecords(sim.inputs);
  removeTrack(sim.fleet, track);
}

/** The ship's next state is shown at once, and no prediction error is counted. */
export function expectTeleport({ sim }: Session, shipId: string): void {
  const track = sim.fleet.byId.get(shipId);
  if (track === undefined) return;
  sim.sleep?.holdSleeping(track);
  forgetAfter(track.history, -1);
  track.states = null;
  track.replaySnaps = true;
}

/** Clears ships, time, inputs and the clock; the world of the hello, the player's ship and listeners stay. */
export function resetSession(session: Session): void {
  const { config, pilot, pings } = session;
  const world = loadConfig(config, session);
  session.pending = null;
  if (world.ok) beginWorld(session, world.value, config.bodies);
  forgetPings(pings);
  pilot.last = null;
  pilot.released = null;
  session.advancedAt = Number.NaN;
}
