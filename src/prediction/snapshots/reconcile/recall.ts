/** What older servers do not send, from the ship's own prediction (PREDICTION, Reconciliation). */
import { FLYING, IMPACT_SPEED, REFERENCE_BODY, SURFACE_STATE, WHEEL_MOMENTUM } from '../../../dynamics';
import type { Place } from './compare';

/** The impact speed of the contact that `row` is in, m/s; 0, settling, where the prediction is in another contact or there is none. */
export function recalledImpact(row: Float64Array, predicted: Place | null): number {
  if (predicted === null) return 0;
  const { rows, at } = predicted;
  const sameContact =
    rows[at + SURFACE_STATE] !== FLYING && rows[at + REFERENCE_BODY] === row[REFERENCE_BODY];
  return sameContact ? rows[at + IMPACT_SPEED]! : 0;
}

/** Fills in the wheels' momentum of `row`; 0 without a prediction. */
export function recallWheels(row: Float64Array, predicted: Place | null): void {
  for (let k = WHEEL_MOMENTUM; k < WHEEL_MOMENTUM + 3; k++)
    row[k] = predicted === null ? 0 : predicted.rows[predicted.at + k]!;
}
