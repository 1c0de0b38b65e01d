import { CRASHED, IMPACT_SPEED, LANDED, REFERENCE_BODY, SURFACE_STATE, TIPPED } from '../../dynamics';
import { knowsBoundary } from '../snapshots/bodies/bodyTrack';
import { dot } from '../drawn/rotation';
import { sameCommand } from '../inputs/command';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import { actsBetween } from '../inputs/scheduledInput';
import { spanOf } from '../time/timeline';
import { groundOfBounce } from './bounceHeight';
import { fitGround, type Guess } from './fit';
import {
  agePlaces,
  beginReading,
  type GroundPlace,
  keepPlace,
  metresFrom,
  offsetAt,
  placeAt,
} from './learnedGround';
import type { ReceivedState } from './lastState';
import { createObservation, type Observation, observe } from './observe';
import { costOf, createMisfit, type Evidence, replayBetween } from './trial';

/** m: a grounded ship with its feet this far above the ground, or a flying one with its feet this far below, contradicts the ground. */
const ABOVE = 0.1;
const BELOW = 0.03;
/** A landed ship may be this far from its static depth, m. */
const RESTING = 0.06;
/** Costs: below EXPLAINED the ground is right. A new ground must halve the old one's cost and, in flight, explain the states. */
const EXPLAINED = 0.1;
const BETTER = 0.5;
const EXPLAINED_IN_FLIGHT = 2;
/** Most substeps between two replayed states, and most substeps in one frame for fitting other pilots' ships. */
const MAX_INTERVAL = 400;
const OTHERS_BUDGET = 8_000;
/** Approximate number of replays of a fit. */
const REPLAYS = 20;
/** Steepest slope, m/m. */
const STEEPEST = 0.6;

/**
 * Learns the ground from a state that was mispredicted, or is on learned ground: by a replay between the ship's last two states if only the
 * ground can explain them, otherwise from the state alone (PREDICTION, Learned ground). If the grounds agree, nothing is learned.
 */
export function learnGround(sim: Simulation, track: Track, received: ReceivedState): void {
  const { ground } = track;
  const { row, bodies, now } = received;
  beginReading(ground);
  agePlaces(ground, now);
  const seen = observed;
  observe(seen, row, bodies, sim.world);
  if (seen.crashed) return;
  const body = sim.world.bodies[row[REFERENCE_BODY]!]!;
  const [nx, ny, nz] = seen.direction as unknown as [number, number, number];
  const known = offsetAt(ground.places, body.name, nx, ny, nz);
  const old = placeAt(ground, body.name, seen.direction);
  const guess = offsetOfState(seen, received, known);
  const evidence = evidenceOf(sim, track, received);
  if (evidence === null) {
    if (guess !== null) keepPlace(ground, placeOf(seen, received, body, { old, offset: guess }));
    return;
  }
  replayBetween(misfit, sim, track, evidence);
  const before = costOf(misfit, null);
  if (before <= EXPLAINED) {
    if (old !== null) confirmPlace(old, now);
    return;
  }
  const place = placeOf(seen, received, body, { old, offset: known });
  const guesses = guessesOf(seen, received, known, old);
  const cost = fitGround({ sim, track, evidence, seen, place }, ground, guesses, !isResting(seen, row));
  const explains =
    cost < before * BETTER && (seen.grounded ? !isAbove(seen, place) : cost < EXPLAINED_IN_FLIGHT);
  if (explains) keepPlace(ground, place);
  else {
    const offset = guess ?? groundOfBounce(sim, evidence, known);
    if (offset !== null) keepPlace(ground, placeOf(seen, received, body, { old, offset }));
  }
  if (!received.hasImpact && seen.grounded) recallImpact(sim, track, evidence, row);
}

/** The server's ground above ours, m, from a state alone; null for nothing new. */
function offsetOfState(seen: Observation, { row }: ReceivedState, known: number): number | null {
  const above = seen.feet - known;
  const depth = seen.gravity / 100;
  if (isResting(seen, row)) return Math.abs(above + depth) > RESTING ? seen.feet + depth : null;
  if (seen.grounded) return above > ABOVE ? seen.feet + (Math.abs(seen.climb) < 0.5 ? depth : 0) : null;
  return above < -BELOW && seen.climb < 0 ? seen.feet : null;
}

/** Whether a grounded ship is in the air above a ground. */
function isAbove(seen: Observation, { offset }: GroundPlace): boolean {
  return seen.feet - offset > ABOVE;
}

function isResting(seen: Observation, row: Float64Array): boolean {
  return row[SURFACE_STATE] === LANDED || (row[SURFACE_STATE] === TIPPED && seen.speed < 0.5);
}

/** Guesses: the known ground, the ship's static depth, the slope of its climb or of the last place. */
function guessesOf(
  seen: Observation,
  { row }: ReceivedState,
  known: number,
  old: GroundPlace | null,
): Guess[] {
  const slope = old === null ? 0 : dot(old.slope, seen.way);
  const guesses: Guess[] = [{ offset: known, slope }];
  if (!seen.grounded) return guesses;
  const offset = seen.feet + seen.gravity / 100;
  guesses.push({ offset, slope }, { offset, slope: 0 });
  if (isResting(seen, row)) return guesses;
  if (seen.speed > 2 && Math.abs(seen.climb) < STEEPEST * seen.speed)
    guesses.push({ offset, slope: seen.climb / seen.speed });
  const way = old === null ? 0 : metresFrom(old, seen.direction);
  if (old !== null && way > 2 && Math.abs(offset - old.offset) < STEEPEST * way)
    guesses.push({ offset, slope: (offset - old.offset) / way });
  return guesses;
}

/** The last state and this one, if only the ground between them is unknown; otherwise null. */
function evidenceOf(sim: Simulation, track: Track, { row, tick }: ReceivedState): Evidence | null {
  const { evidence } = track;
  const { timeline, bodies } = sim;
  if (evidence.tick < 0 || evidence.tick >= tick || !knowsBoundary(bodies, evidence.tick)) return null;
  const { timing } = spanOf(timeline, tick);
  const span = spanOf(timeline, evidence.tick);
  const substeps = (tick - evidence.tick) * timing.substeps;
  if (span.timing.substeps !== timing.substeps || span.paused || substeps > MAX_INTERVAL) return null;
  if (evidence.row[CRASHED] === 1 || evidence.row[REFERENCE_BODY] !== row[REFERENCE_BODY]) return null;
  if (!sameCommand(evidence.row, 0, row, 0)) return null;
  if (track.own && actsBetween(sim.inputs, evidence.tick, tick)) return null;
  if (!track.own && !spendBudget(sim, tick, substeps)) return null;
  return { from: evidence.row, fromTick: evidence.tick, to: row, toTick: tick };
}

/** Takes `substeps` from a frame's budget for other pilots' ships; false if it is used up: then only the ship's state is used. */
function spendBudget(sim: Simulation, tick: number, substeps: number): boolean {
  const { learning } = sim;
  if (learning.tick !== tick) {
    learning.tick = tick;
    learning.spent = 0;
  }
  if (learning.spent + substeps * REPLAYS > OTHERS_BUDGET) return false;
  learning.spent += substeps * REPLAYS;
  return true;
}

/** Fills in the impact speed of this contact from a replay on the ground as known now; without a touch there, the speed of the fall. */
function recallImpact(sim: Simulation, track: Track, evidence: Evidence, row: Float64Array): void {
  const replayed = replayBetween(misfit, sim, track, evidence);
  if (replayed[SURFACE_STATE] === row[SURFACE_STATE]) row[IMPACT_SPEED] = replayed[IMPACT_SPEED]!;
}

function placeOf(
  { direction }: Observation,
  { now }: ReceivedState,
  body: { readonly name: string; readonly radius: number },
  { old, offset }: { readonly old: GroundPlace | null; readonly offset: number },
): GroundPlace {
  return {
    bodyName: body.name,
    bodyRadius: body.radius,
    offset,
    weight: 1,
    seenAt: now,
    direction: direction.slice(),
    slope: old === null ? new Float64Array(3) : old.slope.slice(),
    states: (old?.states ?? 0) + 1,
  };
}

function confirmPlace(place: GroundPlace, now: number): void {
  place.states += 1;
  place.seenAt = now;
  place.weight = 1;
}

const observed = createObservation();
const misfit = createMisfit();
