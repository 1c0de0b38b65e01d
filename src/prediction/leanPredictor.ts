import type { LeanPredictor } from './calls/api';
import { commonCalls } from './calls/commonCalls';
import { checkFeatures } from './checks/features';
import { requireLeanOptions } from './checks/options';
import type { Feature } from './features';
import type { PredictorOptions } from './options';
import { createSession, type SessionFeatures } from './session';
import { receiveMessage } from './snapshots/receiveMessage';

/** Options of a lean predictor: those of createPredictor without the test mode, and the features that the page loads. */
export interface LeanOptions extends Omit<PredictorOptions, 'forcedRollback'> {
  /** None by default. */
  readonly features?: readonly Feature[];
}

/**
 * Creates a predictor that loads less: the same dynamics, reconciliation and drawing, bit for bit, as long as the server says what it
 * simulates. What createPredictor can do in addition is handed in (`features`) or missing: snapshot and restore, configure, policies,
 * undecoded messages, and all terrains but flat (`terrains: TERRAINS` has the others). `defaults` must have ship classes and bodies; the
 * game's are in `gameCatalogue`. `receive` takes what a decoder of this library
 * returned; only with `checkedRecords` may it be given records of the caller's own making.
 * @throws RangeError that names the invalid option
 *
 * @example
 * ```ts
 * const predictor = createLeanPredictor({ ownShipId: 'ship-1', features: [gameCatalogue, touchdownRecord] });
 * predictor.advance(NEUTRAL_CONTROLS, now);
 * const { own } = predictor.view(now);
 * ```
 */
export function createLeanPredictor(given: LeanOptions = {}): LeanPredictor {
  requireLeanOptions(given);
  const { features = [], ...options } = given;
  const session = createSession(
    options,
    Object.freeze(Object.assign({ checkFeatures }, ...features) as SessionFeatures),
  );
  return commonCalls(session, { take: (message, at) => receiveMessage(session, message, at) }).calls;
}
