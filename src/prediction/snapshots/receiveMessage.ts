import type { Hello, PartialFrame, Pong, ServerFrame, ServerMessage } from '../../wire';
import { resend } from '../inputs/inputs';
import { changeOwnShip } from '../ownership';
import { announce, beginWorld, type Session } from '../session';
import { samplePong } from '../time/clock';
import { answeredPing } from '../time/pings';
import { spanOf, wallOfTick } from '../time/timeline';
import { receiveSnapshot, refuse } from './receiver';
import { loadWorld, sameWorld } from './worldConfig';

/** A message of the server has arrived at client wall second `now`. */
export function receiveMessage(session: Session, message: ServerMessage | PartialFrame, now: number): void {
  if (message.kind === 'hello') takeHello(session, message);
  else if (message.kind === 'frame') takeFrame(session, completed(message, session), now);
  else takePong(session, message, now);
}

/** A frame with what it does not tell filled in: the tempo as it was, no events, bodies moved by the law. */
function completed(frame: PartialFrame, { sim }: Session): ServerFrame {
  const untimed = { tickRate: 1, timeScale: 1 };
  const { tickRate, timeScale } = sim.newestTick < 0 ? untimed : spanOf(sim.timeline, sim.newestTick);
  const untold = { tickRate, timeScale, paused: false, bodies: [], events: [], lastInput: null };
  return { ...untold, ...frame };
}

function takeHello(session: Session, hello: Hello): void {
  const { receiver, counters } = session;
  const loaded = loadWorld(hello, session.terrains);
  if (!loaded.ok) {
    refuse(session.sim, `hello.${loaded.reason}`);
    return;
  }
  changeOwnShip(session, hello.shipId);
  // The same world over a new connection: what was predicted goes on.
  if (!counters.helloReceived || !sameWorld(session.config, hello))
    beginWorld(session, loaded.value, hello.bodies);
  session.config = hello;
  counters.helloReceived = true;
  session.granularity = hello.inputGranularity;
  receiver.fresh = true;
  receiver.tellsEvents = true;
  resend(session.sim.inputs);
}

function takeFrame(session: Session, frame: ServerFrame, now: number): void {
  const { sim, counters, defaults, terrains, receiver } = session;
  if (sim.newestTick < 0 && !counters.helloReceived && frame.bodies.length > 0) {
    // A server without a hello may have other bodies than the defaults: its frames say which.
    const loaded = loadWorld({ ...defaults, bodies: frame.bodies }, terrains);
    if (loaded.ok) beginWorld(session, loaded.value, frame.bodies);
  }
  receiveSnapshot(session.sim, receiver, frame, now);
  announce(session);
}

function takePong({ sim, clock, pings }: Session, pong: Pong, now: number): void {
  const sent = answeredPing(pings, pong.id);
  if (Number.isNaN(sent) || sim.newestTick < 0) return;
  const near = Math.abs(pong.tick - sim.newestTick) < sim.ringLength;
  const paused = near && spanOf(sim.timeline, pong.tick).paused;
  const answeredAt = near && !paused ? wallOfTick(sim.timeline, pong.tick) + pong.sinceTick : null;
  samplePong(clock, sent, answeredAt, now);
}
