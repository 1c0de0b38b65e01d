import type { PendingMessage, ServerMessage, WorldEvent } from '../../wire';
import type { Session } from '../session';
import { noteCall } from './receiveMessage';
import { refuse } from './receiver';

/**
 * Received frames that are not decoded yet. The next `advance` decodes the newest few and reads only the events of those they supersede,
 * so that a page hidden for minutes returns at once.
 */
export interface PendingFrames {
  readonly queue: Waiting[];
  /** Of superseded frames, in order. */
  readonly events: WorldEvent[];
}

/** A message and its arrival, client wall s. */
interface Waiting {
  readonly message: PendingMessage;
  readonly at: number;
}

/** Handles a decoded message. */
type Receive = (message: ServerMessage, now: number) => void;

/** Frames that wait undecoded: more than arrive between two display frames of a visible page. */
const MAX_QUEUED = 4;
/** Events of superseded frames that are kept; the oldest go first. */
export const MAX_KEPT_EVENTS = 1000;

export function createPendingFrames(): PendingFrames {
  return { queue: [], events: [] };
}

/** Drops what waits: it is of another session. */
export function forgetPending({ queue, events }: PendingFrames): void {
  queue.length = 0;
  events.length = 0;
}

/** A message has arrived at client wall second `now`; a frame waits for `decodePending`, anything else does not. */
export function receivePending(
  session: Session,
  message: PendingMessage,
  now: number,
  receive: Receive,
): void {
  if (!noteCall(session, now)) return;
  const { queue, events } = session.pending;
  if (!message.isFrame) {
    decodePending(session, receive);
    decodeOne(session, { message, at: now }, receive);
    return;
  }
  queue.push({ message, at: now });
  if (queue.length <= MAX_QUEUED) return;
  events.push(...queue.shift()!.message.events());
  if (events.length > MAX_KEPT_EVENTS) events.splice(0, events.length - MAX_KEPT_EVENTS);
  session.counters.framesSuperseded += 1;
}

/** Decodes and receives the waiting messages. */
export function decodePending(session: Session, receive: Receive): void {
  const { queue } = session.pending;
  if (queue.length === 0) return;
  for (const one of queue.splice(0)) decodeOne(session, one, receive);
}

function decodeOne(session: Session, { message, at }: Waiting, receive: Receive): void {
  const decoded = message.decode();
  if (!decoded.ok) {
    refuse(session.sim, decoded.reason);
    return;
  }
  const events = decoded.value.kind === 'frame' ? session.pending.events.splice(0) : [];
  const { value } = decoded;
  if (value.kind === 'frame' && events.length > 0)
    receive({ ...value, events: [...events, ...value.events] }, at);
  else receive(value, at);
}
