import { SHIP_STRIDE } from '../../dynamics';
import type { InputAcknowledgement } from '../../wire';
import type { InputOutcome } from '../inputs/inputs';
import type { Place, Tolerance } from './reconcile/compare';

/** The bodies at a frame's tick, as sent and as predicted. */
export interface BodiesOfFrame {
  bodies: Float64Array;
  predictedBodies: Float64Array;
  /** Largest error of the predicted bodies' attitudes and spins, by component. */
  turned: number;
}

/**
 * The context of a frame for its ships; `bodies` and `predictedBodies` are rows at its tick. One record per connection: a new one per
 * frame would lose its hidden class at the next garbage collection, and the compiled code of a reconciliation with it.
 */
export interface SnapshotContext extends BodiesOfFrame {
  tick: number;
  /** Client wall s. */
  now: number;
  /** The frame's acknowledgement of the inputs of the player's ship. */
  lastInput: InputAcknowledgement | null;
  inputs: InputOutcome;
  /** Of the ship whose state is reconciled. */
  readonly compared: Compared;
}

/** A ship's state in a frame, and where the prediction for its tick is. */
export interface Compared {
  readonly server: Place;
  /** In its history. */
  readonly kept: Place;
  /** The pose of a sleeping ship. */
  readonly asleep: Place;
  /** For a state without relative fields. */
  readonly inexact: Tolerance;
}

/** A ship's newest state, and the prediction for its tick. */
export interface NewestState {
  /** The state; its impact speed is filled in if the server does not send it. */
  readonly row: Float64Array;
  readonly context: SnapshotContext;
  readonly predicted: Place | null;
  readonly agrees: boolean;
  readonly hasImpact: boolean;
}

export function createSnapshotContext(): SnapshotContext {
  const none = new Float64Array(0);
  return {
    bodies: none,
    predictedBodies: none,
    turned: NaN,
    tick: -1,
    now: NaN,
    lastInput: null,
    inputs: 'asPredicted',
    compared: {
      server: createPlace(),
      kept: createPlace(),
      asleep: createPlace(),
      inexact: new Float64Array(3),
    },
  };
}

function createPlace(): Place {
  const rows = new Float64Array(SHIP_STRIDE);
  return { rows, at: 0, bodies: rows };
}
