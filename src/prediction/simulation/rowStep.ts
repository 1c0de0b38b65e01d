import { NO_EVENT, SHIP_STRIDE } from '../../dynamics';
import type { Position } from '../time/timeline';

/**
 * One ship's row and its time: the step shared by the frame loop, replays, the rollback check, the touchdown log
 * and the fit of the ground. `tick` and `substep` are the start of the next substep.
 */
export interface RowStep extends Position {
  rows: Float64Array;
  at: number;
  /** The row at the start of the substep just taken, relative to its body after it. */
  before: Float64Array;
  beforeAt: number;
  /** False if nothing reads `before`: it is then not written. */
  keepsBefore: boolean;
  /** Cursor into the inputs that act on the player's ship. */
  inputs: number;
  /** Rows of the bodies, turned for the substep just taken, and its game s (Span.step). */
  bodies: Float64Array;
  dt: readonly [dt: number, none: null];
  /** The event of the last substep. */
  event: number;
}

/** A step of the row at `at` in `rows`. */
export function createRowStep(rows = new Float64Array(SHIP_STRIDE), at = 0): RowStep {
  return {
    tick: 0,
    substep: 0,
    rows,
    at,
    before: new Float64Array(SHIP_STRIDE),
    beforeAt: 0,
    keepsBefore: true,
    inputs: 0,
    bodies: new Float64Array(0),
    dt: [0, null],
    event: NO_EVENT,
  };
}
