import { SHIP_STRIDE } from '../../dynamics';

/** The state with which a ship's next one is compared. */
export interface LastState {
  readonly row: Float64Array;
  /** -1 before the first. */
  tick: number;
}

export function createLastState(): LastState {
  return { row: new Float64Array(SHIP_STRIDE), tick: -1 };
}
