import { err } from '../dynamics';
import type { Predictor } from './calls/api';
import { wallAt } from './calls/callTime';
import { commonCalls } from './calls/commonCalls';
import { isShipId } from './calls/shipCalls';
import { requireOptions } from './checks/options';
import { ALL_FEATURES, AWAKE_FEATURES } from './features';
import { configure } from './lifecycle/configure';
import { copyOwned, type Owned } from './lifecycle/fork';
import { changePolicy } from './lifecycle/policy';
import { createLatestMessages, receiveAndKeep, restoreSnapshot, snapshotOf } from './lifecycle/snapshot';
import type { PredictorOptions } from './options';
import { createSession, type SessionFeatures } from './session';
import { checkRollback } from './simulation/rollbackCheck';
import type { Simulation } from './simulation/simulation';
import { decodePending, receivePending } from './snapshots/pending';

/**
 * Creates a predictor without server state.
 * @throws RangeError that names the invalid option
 *
 * @example
 * ```ts
 * const predictor = createPredictor({ ownShipId: 'ship-1', onWarning: (code, message) => console.warn(code, message) });
 * const decoded = decodeFrameJson(message); // a parsed message of the game's server
 * if (decoded.ok) predictor.receive(decoded.value, now);
 * predictor.advance({ ...NEUTRAL_CONTROLS, thrustLevel: 0.4 }, now);
 * const { own } = predictor.view(now);
 * ```
 */
export function createPredictor(options: PredictorOptions = {}): Predictor {
  requireOptions(options);
  const features = (options.forcedRollback ?? 0) > 0 ? rollingBack(options.forcedRollback!) : ALL_FEATURES;
  return predictorOf({ session: createSession(options, features), kept: createLatestMessages() });
}

/** The features of the test mode: ships do not sleep, since each goes back by `ticks` ticks at every boundary. */
function rollingBack(ticks: number): SessionFeatures {
  return Object.freeze({
    ...AWAKE_FEATURES,
    checkRollback: (sim: Simulation, tick: number) => checkRollback(sim, tick, ticks),
  });
}

const owners = new WeakMap<Predictor, Owned>();

/**
 * A second predictor in the same state, independent of the first: with the same input both give the same bits. Listeners stay with the
 * first. For keyframes of a replay. Throws TypeError for anything that createPredictor did not make.
 */
export function forkPredictor(predictor: Predictor): Predictor {
  const owned = owners.get(predictor);
  if (owned === undefined) throw new TypeError('forkPredictor: expected a predictor of createPredictor');
  return predictorOf(copyOwned(owned));
}

function predictorOf(owned: Owned): Predictor {
  const predictor = createApi(owned);
  owners.set(predictor, owned);
  return predictor;
}

function createApi({ session, kept }: Owned): Predictor {
  const { lifetime, calls, receiveAt } = commonCalls(session, {
    take: (message, at) => receiveAndKeep(session, kept, message, at),
    decodePending,
  });
  return {
    ...calls,
    receivePending(message, now) {
      if (lifetime.carriesOut('receivePending')) receivePending(session, message, now, receiveAt);
    },
    setPolicy(shipId, policy) {
      if (lifetime.carriesOut('setPolicy') && isShipId(session, 'setPolicy', shipId))
        changePolicy(session, shipId, policy);
    },
    configure: (changes) =>
      lifetime.carriesOut('configure') ? configure(session, changes) : err('configure: disposed'),
    snapshot: (now) => snapshotOf(session, kept, wallAt(session, now)),
    restore: (snapshot, now) =>
      lifetime.carriesOut('restore')
        ? restoreSnapshot(session, kept, snapshot, wallAt(session, now))
        : err('snapshot: disposed'),
  };
}
