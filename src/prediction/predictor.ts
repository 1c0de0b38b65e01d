import { err } from '../dynamics';
import type { Predictor } from './calls/api';
import { wallAt } from './calls/callTime';
import { frameCalls } from './calls/frameCalls';
import { createLife } from './calls/life';
import { shipCalls } from './calls/shipCalls';
import { describe } from './checks/describe';
import { requireOptions } from './checks/options';
import { configure } from './lifecycle/configure';
import { copyOwned, type Owned } from './lifecycle/fork';
import { createKept, restoreSnapshot, snapshotOf } from './lifecycle/snapshot';
import type { PredictorOptions } from './options';
import { resetSession } from './ownership';
import { createSession, type Session } from './session';
import { refuse } from './snapshots/receiveSnapshot';

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
  return predictorOf({ session: createSession(options), kept: createKept() });
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
  const predictor = createFace(owned);
  owners.set(predictor, owned);
  return predictor;
}

function createFace({ session, kept }: Owned): Predictor {
  const life = createLife(session);
  return {
    ...frameCalls(session, kept, life),
    ...shipCalls(session, life),
    refused: (reason) => refuse(session.sim, reason),
    onEvent(listener) {
      if (!life.carriesOut('onEvent') || !isListener(session, listener)) return () => undefined;
      session.listeners.add(listener);
      return () => session.listeners.delete(listener);
    },
    configure: (changes) =>
      life.carriesOut('configure') ? configure(session, changes) : err('configure: disposed'),
    reset: () => resetSession(session),
    snapshot: (now) => snapshotOf(session, kept, wallAt(session, now)),
    restore: (snapshot, now) =>
      life.carriesOut('restore')
        ? restoreSnapshot(session, kept, snapshot, wallAt(session, now))
        : err('snapshot: disposed'),
    dispose() {
      life.end();
      session.listeners.clear();
      resetSession(session);
    },
  };
}

function isListener({ warn }: Session, listener: unknown): boolean {
  if (typeof listener === 'function') return true;
  const message = `onEvent: expected one function (notice) for all events, got ${describe(listener)}.`;
  warn('listener-not-function', message, { listener });
  return false;
}
