import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import type { GroundPlace, LearnedGround } from './learnedGround';
import type { Observation } from './observe';
import { costOf, createMisfit, type Evidence, replayBetween } from './trial';

/** The ground that explains two states best: the best of several guesses, refined. */

/** An offset, m, and a slope along the way, m/m. */
export interface Guess {
  offset: number;
  slope: number;
}

export interface FitTask {
  readonly sim: Simulation;
  readonly track: Track;
  readonly evidence: Evidence;
  readonly seen: Observation;
  /** The place that holds the guess being tried, the newest of the track's ground. */
  readonly place: GroundPlace;
}

/** Offsets tried when no guess is good, m. */
const SCAN = [-1.2, -0.9, -0.6, -0.3, 0.3, 0.6, 0.9, 1.2];
/** Steps of the finite differences, m and m/m, and the largest step of a refinement. */
const NUDGE = { offset: 0.02, slope: 0.01 };
const MAX_STEP = { offset: 0.6, slope: 0.15 };
const REFINEMENTS = 3;
/** No slope is fitted below this speed, m/s. */
const SLOW = 1;

/** Tries the guesses and refines the best. Returns its cost; the place keeps the best guess. */
export function fitGround(
  task: FitTask,
  ground: LearnedGround,
  guesses: readonly Guess[],
  scans: boolean,
): number {
  ground.places.push(task.place);
  let best = Number.POSITIVE_INFINITY;
  const found: Guess = { offset: 0, slope: 0 };
  const consider = (guess: Guess): void => {
    const cost = tryGuess(task, guess);
    if (!(cost < best)) return;
    best = cost;
    found.offset = guess.offset;
    found.slope = guess.slope;
  };
  for (const guess of guesses) consider(guess);
  if (scans) for (const offset of SCAN) consider({ offset, slope: guesses[0]?.slope ?? 0 });
  for (let i = 0; i < REFINEMENTS && best > 0.05; i++) {
    const before = best;
    consider(refined(task, found));
    if (best === before) break;
  }
  setGuess(task, found);
  ground.places.pop();
  return best;
}

/** One Gauss–Newton step on height and climb at the second state; on the offset alone if the ship does not move along the ground. */
function refined(task: FitTask, at: Guess): Guess {
  const here = residuals(task, at);
  const up = residuals(task, { ...at, offset: at.offset + NUDGE.offset });
  const a = (up[0] - here[0]) / NUDGE.offset;
  const c = (up[1] - here[1]) / NUDGE.offset;
  let offset = -(a * here[0] + c * here[1]) / (a * a + c * c + 1e-6);
  let slope = 0;
  if (task.seen.grounded && task.seen.speed > SLOW) {
    const steeper = residuals(task, { ...at, slope: at.slope + NUDGE.slope });
    const b = (steeper[0] - here[0]) / NUDGE.slope;
    const d = (steeper[1] - here[1]) / NUDGE.slope;
    const determinant = a * d - b * c;
    if (Math.abs(determinant) > 1e-3) {
      offset = (b * here[1] - d * here[0]) / determinant;
      slope = (c * here[0] - a * here[1]) / determinant;
    }
  }
  return {
    offset: at.offset + clamp(offset, MAX_STEP.offset),
    slope: at.slope + clamp(slope, MAX_STEP.slope),
  };
}

function residuals(task: FitTask, guess: Guess): [height: number, climb: number] {
  tryGuess(task, guess);
  return [misfit.height / 0.05, misfit.climb / 0.25];
}

function tryGuess(task: FitTask, guess: Guess): number {
  setGuess(task, guess);
  replayBetween(misfit, task.sim, task.track, task.evidence);
  return costOf(misfit, task.place);
}

function setGuess({ place, seen }: FitTask, guess: Guess): void {
  place.offset = guess.offset;
  for (let k = 0; k < 3; k++) place.slope[k] = guess.slope * seen.way[k]!;
}

function clamp(x: number, most: number): number {
  return Math.max(-most, Math.min(most, x));
}

const misfit = createMisfit();
