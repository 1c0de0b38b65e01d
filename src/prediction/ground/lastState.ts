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

/** Keeps a state for comparison with the next. */
export function keepState(state: LastState, row: Float64Array, tick: number): void {
  state.row.set(row);
  state.tick = tick;
}

/** A server state of one ship, and the bodies of its tick. */
export interface ReceivedState {
  readonly row: Float64Array;
  readonly tick: number;
  readonly bodies: Float64Array;
  /** Client wall s. */
  readonly now: number;
  /** The server sent the impact speed; otherwise it comes from the replay. */
  readonly hasImpact: boolean;
}
