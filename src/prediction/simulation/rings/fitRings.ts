import { keptTicks, resizedBodies } from '../../snapshots/bodies/bodyTrack';
import { resized, ringLength, ROW_BYTES } from './history';
import type { Simulation } from '../simulation';
import type { Track } from '../track';

/** Sizes the rings of predicted states: of ten seconds, or fewer if that exceeds the limit of rowsWithin. */

/** The inputs to the length of the rings. */
export interface RingNeeds {
  /** Hz */
  readonly tickRate: number;
  /** Substeps of a tick. */
  readonly substeps: number;
  /** Ships expected. */
  readonly ships: number;
}

/** Resizes the rings; their contents are kept. A ring longer than needed is kept while memory allows it. */
export function fitRings(sim: Simulation, { tickRate, substeps, ships }: RingNeeds): void {
  const { tracks } = sim.fleet;
  sim.ringLength = ringLength(tickRate);
  const most = sim.features.rowsWithin?.(ships) ?? Number.POSITIVE_INFINITY;
  const wanted = Math.min(sim.ringLength, most);
  if (wanted > sim.historyRows || sim.historyRows > most) sim.historyRows = wanted;
  for (const track of tracks) fitTrack(sim, track);
  const bodyRing = Math.max(sim.ringLength, sim.bodies.length);
  if (bodyRing !== sim.bodies.length || sim.bodies.substepRows.length !== keptTicks(substeps))
    sim.bodies = resizedBodies(sim.bodies, bodyRing, substeps);
  sim.counters.historyBytes = historyBytes(sim, ships);
}

/** The length of a new ship's history. */
export function historyLength(sim: Simulation, own: boolean): number {
  return own ? Math.max(sim.ringLength, sim.historyRows) : sim.historyRows;
}

function fitTrack(sim: Simulation, track: Track): void {
  const length = historyLength(sim, track.own);
  const kept = track.history.length;
  if (kept === length || (track.own && kept > length)) return;
  track.history = resized(track.history, length);
  if (track.log !== null) sim.features.touchdown?.resizeLogs(track.log, length);
}

function historyBytes(sim: Simulation, ships: number): number {
  const own = sim.fleet.own === null ? 0 : sim.fleet.own.history.length;
  return (ships * sim.historyRows + own) * ROW_BYTES;
}
