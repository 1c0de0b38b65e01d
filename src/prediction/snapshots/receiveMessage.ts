import { matchVersion, PROTOCOL_VERSION } from '../../protocol';
import type { Hello, PartialFrame, Pong, ServerFrame, ServerMessage } from '../../wire';
import { resend } from '../inputs/inputs';
import { changeWorld } from '../lifecycle/changeWorld';
import { changeOwnShip } from '../ownership';
import { announce, beginWorld, type Session } from '../session';
import type { Simulation } from '../simulation/simulation';
import { type Answer, samplePong, serverTime } from '../time/clock';
import { answeredPing } from '../time/pings';
import { spanOf, wallOfTick } from '../time/timeline';
import { completeFrame } from './completeFrame';
import { receiveSnapshot, refuse, startAnew } from './receiveSnapshot';
import { loadGiven, sameWorld } from './worldConfig';

/**
 * Receives a message of the server at client wall second `now`. Never throws: an invalid message is refused with a reason, and the last
 * valid state stays.
 */
export function receiveMessage(session: Session, message: ServerMessage | PartialFrame, now: number): void {
  switch (kindOf(message)) {
    case 'hello':
      takeHello(session, message as Hello, now);
      break;
    case 'frame':
      takeFrame(session, message as PartialFrame, now);
      break;
    case 'pong':
      takePong(session, message as Pong, now);
      break;
    default:
      refuse(session.sim, `message.kind: expected hello, frame or pong, got ${String(kindOf(message))}`);
      session.warn('message-kind', 'A message is neither hello, frame nor pong: set its kind.', { message });
  }
}

function kindOf(message: unknown): unknown {
  return (message as { kind?: unknown } | null | undefined)?.kind;
}

/** A new connection starts a new timeline, unless the world is the same and its time continues. */
function takeHello(session: Session, hello: Hello, now: number): void {
  const { receiver, counters } = session;
  if (!isCompatible(session, hello)) return;
  const loaded = loadGiven(hello, session.terrains);
  if (!loaded.ok) {
    refuse(session.sim, `hello.${loaded.reason}`);
    return;
  }
  const ownShipId = typeof hello.shipId === 'string' ? hello.shipId : '';
  changeOwnShip(session, ownShipId);
  const { sim } = session;
  if (sim.newestTick >= 0 && counters.helloReceived && !continuesTimeline(session, hello, now))
    startAnew(sim, receiver);
  if (!counters.helloReceived) beginWorld(session, loaded.value, hello.bodies);
  else if (!sameWorld(session.config, hello)) changeWorld(session, loaded.value, hello);
  session.config = hello;
  counters.helloReceived = true;
  session.granularity = hello.inputGranularity;
  receiver.fresh = true;
  receiver.firstTick = Number.isSafeInteger(hello.tick) ? hello.tick : 0;
  receiver.sendsEvents = true;
  resend(session.sim.inputs);
}

/** Whether the server's version is compatible: another major version is refused, a newer minor one causes a warning. */
function isCompatible({ sim, warn }: Session, { protocolVersion: version }: Hello): boolean {
  const match = matchVersion(version);
  if (match === 'same' || match === 'older') return true;
  const isForeign = match === 'foreign';
  const mismatch = `hello.protocolVersion is ${String(version)}, but this client speaks ${PROTOCOL_VERSION}`;
  const effect = isForeign
    ? 'The hello is refused: use the client for that server.'
    : 'It is accepted, and additions of the newer version are ignored: update the client.';
  warn('protocol-version', `${mismatch}. ${effect}`, { value: version, known: PROTOCOL_VERSION });
  const [major] = PROTOCOL_VERSION.split('.');
  if (isForeign) refuse(sim, `hello.protocolVersion: expected ${major}.x, got ${String(version)}`);
  return !isForeign;
}

/** Whether the hello's tick agrees with the server's clock; that of a restarted server does not. */
function continuesTimeline({ sim, clock }: Session, { tick, tickRate }: Hello, now: number): boolean {
  if (tick < sim.newestTick) return false;
  const ahead = wallOfTick(sim.timeline, tick) - serverTime(clock, now);
  return Math.abs(ahead) <= Math.max(MAX_CLOCK_ERROR, 2 / tickRate);
}

/** s: largest apparent clock error of a server that continues its timeline. */
const MAX_CLOCK_ERROR = 2;

function takeFrame(session: Session, given: PartialFrame, now: number): void {
  const { counters, receiver } = session;
  const complete = completeFrame(session.sim, session.meter, given);
  if (!complete.ok) {
    refuse(session.sim, complete.reason);
    return;
  }
  const frame = complete.value;
  if (session.sim.newestTick < 0 && !counters.helloReceived && frame.bodies.length > 0)
    beginWithBodies(session, given, frame);
  receiveSnapshot(session.sim, receiver, frame, now);
  announce(session);
}

/** Without a hello the bodies of the frames replace the defaults. */
function beginWithBodies(session: Session, given: PartialFrame, frame: ServerFrame): void {
  const config = { ...session.config, bodies: frame.bodies };
  const loaded = loadGiven(config, session.terrains);
  if (loaded.ok) changeWorld(session, loaded.value, config);
  // The world's game time is measured from this frame on, not from the next.
  session.sim.features.measureGameTime?.(session.meter, { ...given, ...frame }, null);
}

function takePong({ sim, clock, pings }: Session, pong: Pong, now: number): void {
  if (![pong.id, pong.tick, pong.sinceTick].every(Number.isFinite)) {
    refuse(
      sim,
      `pong: expected finite numbers, got id ${pong.id}, tick ${pong.tick}, sinceTick ${pong.sinceTick}`,
    );
    return;
  }
  const sent = answeredPing(pings, pong.id);
  if (Number.isNaN(sent) || sim.newestTick < 0) return;
  pings.answeredAt = now;
  samplePong(clock, sent, answerTime(sim, pong), now);
}

/** A tick this late is overdue, s. */
const OVERDUE = 0.01;

/**
 * When a pong was sent, or null if its stamp is unusable. If a tick is overdue, the server has stopped: its time is at the next
 * tick's boundary.
 */
function answerTime(
  { timeline, newestTick, ringLength }: Simulation,
  { tick, sinceTick }: Pong,
): Answer | null {
  if (Math.abs(tick - newestTick) >= ringLength || !(sinceTick >= 0)) return null;
  const { paused, tickRate } = spanOf(timeline, tick);
  if (paused) return null;
  const interval = 1 / tickRate;
  const at = wallOfTick(timeline, tick) + Math.min(sinceTick, interval);
  return { at, standing: sinceTick > interval + OVERDUE };
}
