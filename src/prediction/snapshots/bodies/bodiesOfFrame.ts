import type { BodyMotion } from '../../../dynamics';
import type { ServerFrame } from '../../../wire';
import type { Simulation } from '../../simulation/simulation';
import { spanOf } from '../../time/timeline';
import { boundaryAt, startBodiesAt } from './bodyTrack';
import { updateBodies } from './updateBodies';
import { isExact } from '../reconcile/adopt';
import type { Receiver } from '../receiver';
import type { BodiesOfFrame } from '../snapshotContext';
import { sameBodies } from '../../lifecycle/worldConfig';

/** Most ticks over which bodies are advanced just for the comparison. */
const MAX_CARRIED = 64;

/** Writes the frame's bodies and compares them with the predicted ones. Without a motion they are advanced by the dynamics. */
export function writeBodiesOfFrame(
  out: BodiesOfFrame,
  sim: Simulation,
  receiver: Receiver,
  frame: ServerFrame,
): void {
  const { tick } = frame;
  if (sim.newestTick === tick && receiver.startsBodies) startBodiesAt(sim.bodies, tick);
  receiver.startsBodies = false;
  const lastTick = receiver.lastBodies.tick;
  const motions = (sim.features.completeBodies ?? sentInOrder)(sim, receiver, frame);
  noteKnown(sim, frame);
  if (motions === null) {
    out.bodies = boundaryAt(sim.bodies, sim.timeline, tick);
    out.predictedBodies = out.bodies;
    out.turned = 0;
    return;
  }
  // The predicted bodies at this tick, for the comparison.
  if (tick - lastTick <= MAX_CARRIED && lastTick >= 0) boundaryAt(sim.bodies, sim.timeline, tick);
  const error = updateBodies(
    sim.bodies,
    tick,
    spun(sim, tick, motions),
    sim.features.records?.writeBodyMotion,
  );
  if (error.attitude > 0 || error.spin > 0) {
    sim.counters.correctionsBody += 1;
    sim.counters.errorBodyAttitude = error.attitude;
    sim.counters.errorBodySpin = error.spin;
  }
  out.bodies = boundaryAt(sim.bodies, sim.timeline, tick);
  out.predictedBodies = sim.bodies.replaced;
  out.turned = Math.max(error.attitude, error.spin);
}

/** Whether the frame has the places of the bodies, if they were unknown. */
function noteKnown(sim: Simulation, { tick, bodies, ships }: ServerFrame): void {
  if (sim.bodiesKnown) return;
  const isPlaced = sim.features.records?.isPlaced ?? (() => true);
  const isSent = ({ name }: { readonly name: string }) =>
    bodies.some((body) => body.name === name && isPlaced(body));
  sim.bodiesKnown = sim.world.bodies.every(isSent);
  if (!sim.bodiesKnown && !ships.every(isExact))
    sim.warn(
      'bodies-unknown',
      'Neither the bodies nor the elapsed game time were sent: no ship is confirmed.',
      {
        tick,
      },
    );
}

/** The motions with the measured spins; the same list if all spins are as sent. */
function spun(sim: Simulation, tick: number, motions: readonly BodyMotion[]): readonly BodyMotion[] {
  const { spin: measuring } = sim.features;
  if (!measuring) return motions;
  const { tickSeconds } = spanOf(sim.timeline, tick).timing;
  let differs = false;
  for (const [i, sent] of motions.entries()) {
    const spin = sim.spins[i]!;
    const motion = measuring.spunMotion(spin, sent, tick, (tick - spin.tick) * tickSeconds);
    measured[i] = motion;
    if (motion !== sent) differs = true;
  }
  return differs ? measured.slice(0, motions.length) : motions;
}

const measured: BodyMotion[] = [];

/** The frame's bodies; null unless they are the world's, in its order. */
function sentInOrder(
  { world }: Simulation,
  { lastBodies }: Receiver,
  { tick, bodies }: ServerFrame,
): readonly BodyMotion[] | null {
  if (bodies.length === 0) return null;
  lastBodies.tick = tick;
  return sameBodies(world, { bodies }) ? bodies : null;
}
