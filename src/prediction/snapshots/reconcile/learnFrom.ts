import { REFERENCE_BODY } from '../../../dynamics';
import type { Simulation } from '../../simulation/simulation';
import type { Track } from '../../simulation/track';
import { spanOf } from '../../time/timeline';
import type { Place } from './compare';
import type { NewestState } from '../snapshotContext';

/**
 * Learns the ground, the body's spin and the fit of the dynamics from a state (PREDICTION, Learned ground).
 * @returns whether the ship changes between simulation and extrapolation
 */
export function learnFrom(sim: Simulation, track: Track, newest: NewestState): boolean {
  const { row, context, predicted, agrees, hasImpact } = newest;
  const { tick, bodies, now } = context;
  const { fit, ground } = track;
  const { features } = sim;
  const isKnown = features.unknownGround?.knowsGround(row, bodies, sim.world) ?? true;
  const changes = isKnown === (fit.extrapolated === 'ground');
  if (changes) fit.extrapolated = isKnown ? '' : 'ground';
  if (fit.extrapolated !== '') {
    fit.states += 1;
    sim.counters.statesExtrapolated += 1;
  }
  if (!isKnown) return changes;
  if (!agrees || ground.places.length > 0 || fit.extrapolated !== '')
    features.learnGround?.(sim, track, { row, tick, bodies, now, hasImpact });
  if (!agrees) measureSpin(sim, track, newest);
  state.rows = row;
  state.bodies = bodies;
  const isWeighed = features.chooseMotion?.(sim, track, { state, tick, predicted, agrees }) ?? false;
  return changes || isWeighed;
}

/** Measures the body's spin from a ship at rest whose position was mispredicted. */
function measureSpin(sim: Simulation, { evidence }: Track, { row, context }: NewestState): void {
  const { tick, bodies } = context;
  if (evidence.tick < 0 || evidence.tick >= tick) return;
  const seconds = (tick - evidence.tick) * spanOf(sim.timeline, tick).timing.tickSeconds;
  sim.features.spin?.measureByShip(sim.spins[row[REFERENCE_BODY]!]!, evidence.row, row, bodies, seconds);
}

const state: Place = { rows: new Float64Array(0), at: 0, bodies: new Float64Array(0) };
