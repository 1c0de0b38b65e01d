import type { ClientMessage, PartialFrame, ServerMessage } from '../../wire';
import { createChecks } from '../checks/checks';
import { advanceFrame } from '../frameLoop';
import { lastControls, takeInputs } from '../inputs/sending';
import { type Kept, receiveAndKeep } from '../lifecycle/snapshot';
import type { Session } from '../session';
import { decodePending, receivePending } from '../snapshots/pending';
import { pingIfDue } from '../time/pings';
import { viewAt } from '../viewAt';
import type { Predictor } from './api';
import { wallAt } from './callTime';
import type { Life } from './life';

/** The calls of each message and each display frame. */
export function frameCalls(session: Session, kept: Kept, life: Life) {
  const checks = createChecks(session);
  const receiveAt = (message: ServerMessage | PartialFrame, now: number, at: number) => {
    checks?.receive(message, now);
    if (!Number.isNaN(at)) receiveAndKeep(session, kept, message, at);
  };
  return {
    receive(message, now) {
      if (life.carriesOut('receive')) receiveAt(message, now, wallAt(session, now));
    },
    receivePending(message, now) {
      if (life.carriesOut('receivePending')) receivePending(session, message, now, receiveAt);
    },
    advance(controls, now) {
      if (!life.carriesOut('advance')) return;
      checks?.advance(controls, now);
      const at = wallAt(session, now);
      if (Number.isNaN(at)) return;
      decodePending(session, receiveAt);
      pingIfDue(session.pings, at);
      if (session.sim.newestTick >= 0) advanceFrame(session, controls, at);
    },
    view(now) {
      checks?.view(now);
      if (Number.isFinite(now)) return viewAt(session, now + session.setBack);
      wallAt(session, now);
      return session.shown.view;
    },
    takeOutgoing() {
      checks?.taken();
      return takeOutgoing(session);
    },
    takeControls() {
      checks?.taken();
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
