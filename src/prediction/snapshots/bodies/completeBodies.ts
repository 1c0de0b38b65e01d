import { BODY_STRIDE, type BodyMotion, readBodyMotion } from '../../../dynamics';
import type { BodyState, ServerFrame } from '../../../wire';
import type { Simulation } from '../../simulation/simulation';
import type { Receiver } from '../receiver';
import { areNumbers } from '../shipFault';
import { boundaryAt } from './bodyTrack';

/**
 * The frame's bodies in the world's order; null if it has none. Bodies that are not sent, lack attitude or spin, or repeat the last
 * frame's are advanced by the dynamics.
 */
export function completeBodies(
  sim: Simulation,
  receiver: Receiver,
  frame: ServerFrame,
): readonly BodyMotion[] | null {
  const { tick, bodies } = receiver.lastBodies;
  return areOld(sim, receiver, frame) ? null : motionsOf(sim, frame, frame.tick === tick ? [] : bodies);
}

/** Whether the server sends outdated bodies: none has moved since the last frame, but some should have. */
function areOld({ warn }: Simulation, receiver: Receiver, { tick, bodies }: ServerFrame): boolean {
  const { lastBodies } = receiver;
  if (bodies.length === 0) return false;
  const { tick: before, bodies: sent } = lastBodies;
  lastBodies.tick = tick;
  lastBodies.bodies = bodies;
  if (tick === before || sent.length !== bodies.length) return false;
  let moves = false;
  for (const [i, body] of bodies.entries()) {
    const last = sent[i]!;
    if (last.name !== body.name || !sameVector(last.position, body.position)) return false;
    if (body.velocity.some((v) => Math.abs(v) > 1e-6)) moves = true;
  }
  if (moves) {
    const details = { tick, lastTick: before };
    warn(
      'bodies-old',
      'Bodies did not move between two ticks: they are extrapolated by their velocity.',
      details,
    );
  }
  return moves;
}

function sameVector(a: readonly number[], b: readonly number[]): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}

/** The frame's bodies in the world's order; null if it has none. `before`: the bodies of the frame before it. */
function motionsOf(
  sim: Simulation,
  frame: ServerFrame,
  before: readonly BodyState[],
): readonly BodyMotion[] | null {
  const { bodies } = sim.world;
  if (frame.bodies.length === 0) return null;
  const inOrder =
    frame.bodies.length === bodies.length &&
    frame.bodies.every(
      (body, i) => body.name === bodies[i]!.name && isWhole(body) && !standsStill(body, before[i]),
    );
  if (inOrder) return frame.bodies;
  const byLaw = boundaryAt(sim.bodies, sim.timeline, frame.tick);
  return bodies.map(({ name }, i) => {
    const predicted = readBodyMotion(byLaw, i * BODY_STRIDE);
    const sent = frame.bodies.find((body) => body.name === name);
    if (sent === undefined) return predicted;
    const motion = completed(sent, predicted);
    const last = before.find((body) => body.name === name);
    return standsStill(sent, last) ? { ...motion, attitude: predicted.attitude } : motion;
  });
}

/** Whether a body has spin, and its attitude is the last frame's to the bit: the reader of the frame filled it in. */
function standsStill({ name, attitude, angularVelocity }: BodyState, before: BodyState | undefined): boolean {
  if (before?.name !== name || !areNumbers(attitude, 4) || !areNumbers(angularVelocity, 3)) return false;
  for (let k = 0; k < 4; k++) if (attitude[k] !== before.attitude[k]) return false;
  return angularVelocity.some((w) => w !== 0);
}

/** The body's motion: finite members as sent, the others as predicted. */
function completed(sent: BodyState, predicted: BodyMotion): BodyMotion {
  const moves = areNumbers(sent.position, 3) && areNumbers(sent.velocity, 3);
  return {
    position: moves ? sent.position : predicted.position,
    velocity: moves ? sent.velocity : predicted.velocity,
    attitude: areNumbers(sent.attitude, 4) ? sent.attitude : predicted.attitude,
    angularVelocity: areNumbers(sent.angularVelocity, 3) ? sent.angularVelocity : predicted.angularVelocity,
  };
}

function isWhole({ position, velocity, attitude, angularVelocity }: BodyState): boolean {
  return (
    areNumbers(position, 3) &&
    areNumbers(velocity, 3) &&
    areNumbers(attitude, 4) &&
    areNumbers(angularVelocity, 3)
  );
}
