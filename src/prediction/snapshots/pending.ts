import type { PendingMessage } from '../../wire';
import { wallAt } from '../calls/callTime';
import { describe } from '../checks/describe';
import type { Receive } from '../calls/frameCalls';
import type { Session } from '../session';
import { MAX_KEPT_EVENTS, type PendingFrames, type Waiting } from './pendingFrames';
import { refuse } from './receiveSnapshot';

/** Frames that wait undecoded: more than arrive between two display frames of a visible page. */
const MAX_QUEUED = 4;

function pendingOf(session: Session): PendingFrames {
  return (session.pending ??= { queue: [], events: [] });
}

/** Receives a message at the caller's `now`. Frames wait for `decodePending`; other messages are decoded at once. */
export function receivePending(
  session: Session,
  message: PendingMessage,
  now: number,
  receive: Receive,
): void {
  const at = wallAt(session, now);
  if (Number.isNaN(at)) return;
  if (!isPending(message)) {
    refuse(session.sim, `message: expected what pendingServerMessage returns, got ${describe(message)}`);
    return;
  }
  const { queue, events } = pendingOf(session);
  if (!message.isFrame) {
    decodePending(session, receive);
    decodeOne(session, { message, now, at }, receive);
    return;
  }
  queue.push({ message, now, at });
  if (queue.length <= MAX_QUEUED) return;
  events.push(...queue.shift()!.message.events());
  events.splice(0, Math.max(0, events.length - MAX_KEPT_EVENTS));
  session.counters.framesSuperseded += 1;
}

/** Whether a caller's value has the calls of a pending message: bytes, records and results of a decoder have not. */
function isPending(value: unknown): boolean {
  const { decode, events } = (value ?? {}) as Partial<PendingMessage>;
  return typeof decode === 'function' && typeof events === 'function';
}

/** Decodes and receives the waiting messages. */
export function decodePending(session: Session, receive: Receive): void {
  const { pending } = session;
  if (pending === null || pending.queue.length === 0) return;
  for (const one of pending.queue.splice(0)) decodeOne(session, one, receive);
}

function decodeOne(session: Session, { message, now, at }: Waiting, receive: Receive): void {
  const decoded = message.decode();
  if (!decoded.ok) {
    refuse(session.sim, decoded.reason);
    return;
  }
  const events = decoded.value.kind === 'frame' ? pendingOf(session).events.splice(0) : [];
  const { value } = decoded;
  if (value.kind === 'frame' && events.length > 0)
    receive({ ...value, events: [...events, ...value.events] }, now, at);
  else receive(value, now, at);
}
