import type { PartialFrame, ServerFrame, ServerMessage } from '../../wire';
import { beginWorld, type Session } from '../session';
import { completeFrame, tempoOf } from './completeFrame';
import { receiveSnapshot, refuse } from './receiveSnapshot';
import { loadConfig } from '../lifecycle/worldConfig';

/**
 * Receives a message of the server at client wall second `now`. Never throws: an invalid message is refused with a reason, and the last
 * valid state stays.
 */
export function receiveMessage(session: Session, message: ServerMessage | PartialFrame, now: number): void {
  const kind = (message as { kind?: unknown } | null | undefined)?.kind;
  const { receiveHello, receivePong } = session.features;
  const take =
    kind === 'frame' ? takeFrame : kind === 'hello' ? receiveHello : kind === 'pong' && receivePong;
  if (take) take(session, message as never, now);
  else refuse(session.sim, `message.kind: expected one that this predictor takes, got ${String(kind)}`);
}

function takeFrame(session: Session, given: PartialFrame, now: number): void {
  const { counters, receiver } = session;
  const complete = completeFrame(session.sim, receiver, given, now);
  if (!complete.ok) {
    refuse(session.sim, complete.reason);
    return;
  }
  const frame = complete.value;
  if (session.sim.newestTick < 0 && !counters.helloReceived && frame.bodies.length > 0)
    beginWithBodies(session, given, frame, now);
  receiveSnapshot(session.sim, receiver, frame, now);
  session.features.announce?.(session);
}

/** Without a hello the bodies of the frames replace the defaults. */
function beginWithBodies(session: Session, given: PartialFrame, frame: ServerFrame, now: number): void {
  const config = { ...session.config, bodies: frame.bodies };
  const load = session.features.records?.loadUntrusted ?? loadConfig;
  const loaded = load(config, session);
  if (loaded.ok) {
    session.config = config;
    beginWorld(session, loaded.value, config.bodies);
  }
  // The world's tempo is measured from this frame on, not from the next.
  tempoOf(session.sim, session.receiver, { ...given, ships: frame.ships, bodies: frame.bodies }, now);
}
