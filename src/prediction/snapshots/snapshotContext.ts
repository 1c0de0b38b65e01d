import type { InputAcknowledgement } from '../../wire';
import type { InputOutcome } from '../inputs/inputs';

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
  /** The frame's acknowledgement of the own ship's inputs. */
  lastInput: InputAcknowledgement | null;
  inputs: InputOutcome;
}

export function createSnapshotContext(): SnapshotContext {
  const none = new Float64Array(0);
  return {
    bodies: none,
    predictedBodies: none,
    turned: 0,
    tick: -1,
    now: 0,
    lastInput: null,
    inputs: 'asPredicted',
  };
}
