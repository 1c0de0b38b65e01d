import { describe } from '../checks/describe';
import { resetSession } from '../ownership';
import type { Session } from '../session';
import { refuse } from '../snapshots/receiveSnapshot';
import type { LeanPredictor } from './api';
import { frameCalls, type Incoming } from './frameCalls';
import { createLifetime } from './lifetime';
import { shipCalls } from './shipCalls';

/** The calls that every predictor has, until `dispose`. */
export function commonCalls(session: Session, incoming: Incoming) {
  const lifetime = createLifetime(session);
  const { calls, receiveAt } = frameCalls(session, lifetime, incoming);
  return {
    lifetime,
    receiveAt,
    calls: {
      ...calls,
      ...shipCalls(session, lifetime),
      refused: (reason) => refuse(session.sim, reason),
      onEvent(listener) {
        if (!lifetime.carriesOut('onEvent') || !isListener(session, listener)) return () => undefined;
        session.listeners.add(listener);
        return () => session.listeners.delete(listener);
      },
      reset: () => resetSession(session),
      dispose() {
        lifetime.end();
        session.listeners.clear();
        resetSession(session);
      },
    } satisfies LeanPredictor,
  };
}

function isListener({ warn }: Session, listener: unknown): boolean {
  if (typeof listener === 'function') return true;
  warn(
    'listener-not-function',
    `onEvent: expected one function (notice) for all events, got ${describe(listener)}.`,
    { listener },
  );
  return false;
}
