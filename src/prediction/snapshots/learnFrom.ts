import { REFERENCE_BODY } from '../../dynamics';
import { learnGround } from '../ground/learn';
import { knowsGround } from '../ground/unknownGround';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import { spanOf } from '../time/timeline';
import { measureByShip } from './bodies/bodySpin';
import type { Place } from './reconcile/compare';
import { weighLaw } from './reconcile/lawFit';
import type { SnapshotContext } from './snapshotContext';

/** One ship's newest state, and what became of the prediction for its tick. */
export interface Lesson {
  /** The state; its impact speed is filled in where the server does not tell it. */
  readonly row: Float64Array;
  readonly context: SnapshotContext;
  readonly predicted: Place | null;
  readonly agrees: boolean;
  readonly toldImpact: boolean;
}

/** Whether a state that was predicted teaches nothing: the ship is on the ground and under the law that are known. */
export function nothingToLearn({ ground, fit }: Track): boolean {
  return ground.places.length === 0 && fit.carried === '';
}

/**
 * What a state teaches of the ground, of its body's spin and of the law (PREDICTION, Learned ground).
 * @returns whether the ship goes over from the law to being carried on, or back
 */
export function learnFrom(sim: Simulation, track: Track, lesson: Lesson): boolean {
  const { row, context, predicted, agrees, toldImpact } = lesson;
  const { tick, bodies, now } = context;
  const { fit, ground } = track;
  const isKnown = knowsGround(row, bodies, sim.world);
  const changes = isKnown === (fit.carried === 'ground');
  if (changes) fit.carried = isKnown ? '' : 'ground';
  if (fit.carried !== '') {
    fit.states += 1;
    sim.counters.statesCarried += 1;
  }
  if (!isKnown) return changes;
  if (!agrees || ground.places.length > 0 || fit.carried !== '')
    learnGround(sim, track, { row, tick, bodies, now, toldImpact });
  if (!agrees) measureSpin(sim, track, lesson);
  state.rows = row;
  state.bodies = bodies;
  const isWeighed = weighLaw(sim, track, { state, tick, predicted, agrees });
  return changes || isWeighed;
}

/** A ship that lies where it was not predicted tells how fast its body turns. */
function measureSpin(sim: Simulation, { evidence }: Track, { row, context }: Lesson): void {
  const { tick, bodies } = context;
  if (evidence.tick < 0 || evidence.tick >= tick) return;
  const seconds = (tick - evidence.tick) * spanOf(sim.timeline, tick).timing.tickSeconds;
  measureByShip(sim.spins[row[REFERENCE_BODY]!]!, evidence.row, row, bodies, seconds);
}

const state: Place = { rows: new Float64Array(0), at: 0, bodies: new Float64Array(0) };
