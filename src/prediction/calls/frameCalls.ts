import type { ClientMessage, PartialFrame, ServerMessage } from '../../wire';
import { createChecks } from '../checks/checks';
import { advanceFrame } from '../advance';
import { lastControls, takeInputs } from '../inputs/sending';
import type { Session } from '../session';
import { viewAt } from '../viewAt';
import type { Predictor } from './api';
import { wallAt } from './callTime';
import type { Lifetime } from './lifetime';

/** A decoded message that arrived at the caller's `now`, client wall second `at`. */
export type Receive = (message: ServerMessage | PartialFrame, now: number, at: number) => void;

export interface Incoming {
  /** Handles a checked message at a client wall second. */
  readonly take: (message: ServerMessage | PartialFrame, at: number) => void;
  /** Decodes the messages that wait for the next frame. */
  readonly decodePending?: (session: Session, receive: Receive) => void;
}

/** The calls of each message and each display frame, and how a message that was decoded late is received. */
export function frameCalls(session: Session, lifetime: Lifetime, { take, decodePending }: Incoming) {
  const checks = createChecks(session);
  const receiveAt: Receive = (message, now, at) => {
    checks?.receive(message, now);
    if (!Number.isNaN(at)) take(message, at);
  };
  return { calls: callsOf(session, lifetime, { checks, receiveAt, decodePending }), receiveAt };
}

interface Frames {
  readonly checks: ReturnType<typeof createChecks>;
  readonly receiveAt: Receive;
  readonly decodePending: Incoming['decodePending'];
}

function callsOf(session: Session, lifetime: Lifetime, { checks, receiveAt, decodePending }: Frames) {
  return {
    receive(message, now) {
      if (lifetime.carriesOut('receive')) receiveAt(message, now, wallAt(session, now));
    },
    advance(controls, now) {
      if (!lifetime.carriesOut('advance')) return;
      checks?.advance(controls, now);
      const at = wallAt(session, now);
      if (Number.isNaN(at)) return;
      decodePending?.(session, receiveAt);
      session.features.pingIfDue?.(session.pings, at);
      session.features.parts?.receiveRest(session.sim, session.receiver);
      if (session.sim.newestTick >= 0) advanceFrame(session, controls, at);
    },
    view(now) {
      lifetime.carriesOut('view');
      checks?.view(now);
      if (Number.isFinite(now)) return viewAt(session, now + session.setBack);
      wallAt(session, now);
      return session.viewBuilder.view;
    },
    takeOutgoing() {
      checks?.taken('takeOutgoing');
      return takeOutgoing(session);
    },
    takeControls() {
      checks?.taken('takeControls');
      return lastControls(takeOutgoing(session));
    },
  } satisfies Partial<Predictor>;
}

function takeOutgoing({ pings, sim, sending, advancedAt, counters }: Session): ClientMessage[] {
  const messages: ClientMessage[] = pings.queued.splice(0);
  const inputs = takeInputs(sim, sending, advancedAt);
  counters.pingsDropped = pings.dropped;
  counters.inputsDropped = sim.inputs.dropped;
  if (inputs.length > 0) messages.push({ kind: 'inputs', inputs });
  return messages;
}
