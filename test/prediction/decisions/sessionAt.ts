import { writeShip, SHIP_STRIDE, type SurfaceState } from '../../../src/dynamics';
import { ALL_FEATURES } from '../../../src/prediction/features';
import { createSession, type Session } from '../../../src/prediction/session';
import { fitRings } from '../../../src/prediction/simulation/rings/fitRings';
import type { Simulation } from '../../../src/prediction/simulation/simulation';
import { addTrack, type Track } from '../../../src/prediction/simulation/track';
import { updateBodies } from '../../../src/prediction/snapshots/bodies/updateBodies';
import { setTempo } from '../../../src/prediction/time/timeline';
import { loadScenario } from '../../../src/scenarios';
import { scenarioNamed, value } from '../rig';

export const RATE = 10;
const loaded = value(loadScenario(scenarioNamed('settle')));

/** A predictor's parts after a frame of `tick` at client wall second 0, without ships: one body, flat ground, `rate` Hz. */
export function sessionAt(tick: number, rate = RATE): Session {
  const session = createSession(
    {
      ownShipId: 'own',
      maxSubstepsPerFrame: 1000,
      defaults: { bodies: [loaded.body], shipClasses: [loaded.shipClass] },
    },
    ALL_FEATURES,
  );
  const { sim, receiver } = session;
  setTempo(sim.timeline, tick, { tickRate: rate, timeScale: 1, paused: false }, null);
  fitRings(sim, { tickRate: rate, substeps: 100 / rate, ships: 10 });
  updateBodies(sim.bodies, tick, [loaded.body]);
  sim.newestTick = tick;
  sim.front.tick = tick;
  receiver.fresh = false;
  receiver.acceptedAt = 0;
  receiver.seen[tick % receiver.seen.length] = tick;
  return session;
}

/** A ship `east` m beside the scenario's place, in step at its server state of the newest tick. */
export function shipAt(sim: Simulation, shipId: string, state: SurfaceState, east = 0): Track {
  const track = addTrack(sim.fleet, shipId, sim.ringLength);
  const [x, y, z] = loaded.ship.relativePosition;
  const row = new Float64Array(SHIP_STRIDE);
  const ship = { ...loaded.ship, surfaceContactState: state };
  writeShip(row, 0, { ...ship, relativePosition: [x + east, y, z] }, sim.world);
  track.serverRow.set(row);
  track.serverTick = sim.newestTick;
  sim.fleet.front.set(row, track.at);
  sim.fleet.previous.set(row, track.at);
  track.mode = 'stepping';
  return track;
}
