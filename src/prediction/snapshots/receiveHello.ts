import { loadTiming } from '../../dynamics';
import { matchVersion, PROTOCOL_VERSION } from '../../protocol';
import type { Hello } from '../../wire';
import { resend } from '../inputs/inputs';
import { changeWorld } from '../lifecycle/changeWorld';
import { changeOwnShip } from '../ownership';
import { beginWorld, type Session } from '../session';
import { serverTime } from '../time/clock';
import { wallOfTick } from '../time/timeline';
import { beginTimeline, refuse } from './receiveSnapshot';
import { loadUntrusted, sameWorld } from '../lifecycle/worldConfig';

/** A new connection starts a new timeline, unless the world is the same and its time continues. */
export function receiveHello(session: Session, hello: Hello, now: number): void {
  const { receiver, counters } = session;
  if (!isCompatible(session, hello)) return;
  const loaded = loadUntrusted(hello, session);
  if (!loaded.ok) {
    refuse(session.sim, `hello.${loaded.reason}`);
    return;
  }
  const ownShipId = typeof hello.shipId === 'string' ? hello.shipId : '';
  changeOwnShip(session, ownShipId);
  const { sim } = session;
  if (sim.newestTick >= 0 && counters.helloReceived && !continuesTimeline(session, hello, now)) {
    beginTimeline(sim, receiver);
    // The hello has them.
    sim.bodiesKnown = true;
  }
  if (!counters.helloReceived) beginWorld(session, loaded.value, hello.bodies);
  else if (!sameWorld(session.config, hello)) changeWorld(session, loaded.value, hello);
  session.config = hello;
  counters.helloReceived = true;
  session.granularity = hello.inputGranularity;
  receiver.fresh = true;
  receiver.firstTick = Number.isSafeInteger(hello.tick) ? hello.tick : 0;
  receiver.sendsEvents = true;
  const { tickRate, timeScale } = hello;
  if (loadTiming(tickRate, timeScale, loaded.value.settings).ok)
    receiver.defaultTempo = { tickRate, timeScale };
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
