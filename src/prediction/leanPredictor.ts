import type { LeanPredictor } from './calls/api';
import { commonCalls } from './calls/commonCalls';
import { checkFeatures } from './checks/features';
import { requireLeanOptions } from './checks/options';
import type { Feature } from './features';
import type { PredictorOptions } from './options';
import { createSession, type SessionFeatures } from './session';
import { receiveMessage } from './snapshots/receiveMessage';

/** Options of a lean predictor: those of createPredictor except the test mode, and the features to load. */
export interface LeanOptions extends Omit<PredictorOptions, 'forcedRollback'> {
  /** None by default. */
  readonly features?: readonly Feature[];
}

/**
 * Creates a smaller predictor: the same dynamics, reconciliation and drawing, bit for bit, as long as the server sends its whole state.
 * Further abilities of createPredictor are passed as `features` or missing: snapshot and restore, configure, policies, undecoded
 * messages, and all terrains but flat (`terrains: TERRAINS` has the others). `defaults` must have ship classes and bodies; the game's are
 * in `gameCatalogue`. `receive` accepts only messages from this library's decoders;
 * records that the caller builds need `checkedRecords`.
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
