import type { Place } from './compare';

/**
 * Whether the dynamics fit a ship (PREDICTION, Foreign dynamics): if over the last few states they were worse than extrapolation, the
 * ship is extrapolated until they fit again.
 */
export interface LawFit {
  /** '': simulated. 'law': the dynamics do not fit. 'ground': the ground below it is unknown. */
  extrapolated: '' | 'law' | 'ground';
  /** Errors of the last states, m, slot = count mod length. */
  readonly law: Float64Array;
  readonly extrapolation: Float64Array;
  count: number;
  /** How long touches were predicted wrongly and rightly to stay on the ground, s, and whether the ship is shown to bounce instead. */
  groundedWrongly: number;
  groundedRightly: number;
  bounces: boolean;
  /** Speed of the last such rebound, relative to its impact's. */
  rebound: number;
  /** States received while it was extrapolated. */
  states: number;
}

/** A state, the prediction for its tick, and whether the two agree. */
export interface ComparedState {
  readonly state: Place;
  readonly tick: number;
  readonly predicted: Place | null;
  readonly agrees: boolean;
}

/** States over which the errors are summed. */
export const WINDOW = 4;

export function createLawFit(): LawFit {
  return {
    extrapolated: '',
    law: new Float64Array(WINDOW),
    extrapolation: new Float64Array(WINDOW),
    count: 0,
    states: 0,
    groundedWrongly: 0,
    groundedRightly: 0,
    bounces: false,
    rebound: 0,
  };
}

/** Records that a simulated ship's state agreed. Returns false: it stays simulated. */
export function holdLaw(fit: LawFit): boolean {
  const slot = fit.count % WINDOW;
  fit.count += 1;
  fit.law[slot] = 0;
  fit.extrapolation[slot] = 0;
  return false;
}
