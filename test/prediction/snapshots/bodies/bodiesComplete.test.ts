import { describe, expect, it } from 'vitest';
import type { BodyState } from '../../../../src/wire';
import { completeBodies } from '../../../../src/prediction/snapshots/bodies/completeBodies';
import { boundaryAt } from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { readBodyMotion } from '../../../../src/dynamics';
import { frameAt } from '../../faults/restingShip';
import { RATE, sessionAt } from '../../decisions/sessionAt';

const TICK = 100;
type Sent = Partial<Record<keyof BodyState, unknown>>;

/** What is made of the bodies of frame 101, after those of frame `before` were sent. */
function completed(change: Sent | null, before: Sent | null = {}, beforeTick = TICK) {
  const { sim, receiver } = sessionAt(TICK);
  const [body] = sim.world.bodies;
  const motion = readBodyMotion(boundaryAt(sim.bodies, sim.timeline, TICK), 0);
  const sent = { ...body!, ...motion, velocity: [10, 20, -30] } as unknown as BodyState;
  const bodyOf = (more: Sent | null) => (more === null ? [] : [{ ...sent, ...more } as BodyState]);
  Object.assign(receiver.lastBodies, { tick: beforeTick, bodies: bodyOf(before) });
  const bodies = bodyOf(change);
  const made = completeBodies(sim, receiver, frameAt(TICK + 1, RATE, { bodies }));
  const predicted = readBodyMotion(boundaryAt(sim.bodies, sim.timeline, TICK + 1), 0);
  return { made, bodies, predicted, sent, last: receiver.lastBodies };
}
const MOVED = { position: [1, 2, 3], attitude: [0, 0, 0.6, 0.8] };

describe('bodies sent in full', () => {
  it('are used as sent, and stored', () => {
    const { made, bodies, last } = completed(MOVED);
    expect(made).toBe(bodies);
    expect(last).toEqual({ tick: TICK + 1, bodies });
  });

  it('stay stored when a frame has none', () => {
    const { made, last } = completed(null);
    expect([made, last.tick, last.bodies.length]).toEqual([null, TICK, 1]);
  });
});

describe('a body sent in part', () => {
  it.each([
    ['attitude', [0, 0, Number.NaN, 1]],
    ['attitude', undefined],
    ['angularVelocity', [0, 0]],
    ['angularVelocity', [Number.NaN, 0, 0]],
  ] as const)('without %s (%o) has the predicted one', (field, value) => {
    const { made, predicted } = completed({ ...MOVED, [field]: value });
    const [body] = made!;
    expect(body![field]).toEqual(predicted[field]);
    expect(body!.position).toEqual(MOVED.position);
    expect(body!.velocity).toEqual([10, 20, -30]);
  });

  it.each(['position', 'velocity'] as const)('without %s has the predicted place and velocity', (field) => {
    const { made, predicted } = completed({ ...MOVED, [field]: [1, 2, Number.POSITIVE_INFINITY] });
    expect(made![0]).toMatchObject({
      position: predicted.position,
      velocity: predicted.velocity,
      attitude: MOVED.attitude,
    });
  });

  it('is ignored if the world does not have it', () => {
    const { made, predicted } = completed({ ...MOVED, name: 'Vulcan' });
    expect(made).toEqual([predicted]);
  });
});

describe('a body with a constant attitude', () => {
  const turning = { angularVelocity: [0, 0, 1e-5], position: [1, 2, 3] };

  it('gets the predicted attitude if it has spin', () => {
    const { made, predicted } = completed(turning);
    expect(made![0]!.attitude).toEqual(predicted.attitude);
    expect(made![0]!.position).toEqual([1, 2, 3]);
  });

  it('is as sent where it has no spin, where it turned at all, or is of another body or tick', () => {
    const isSent = ({ made, bodies }: ReturnType<typeof completed>) => made === bodies;
    expect(isSent(completed({ ...turning, angularVelocity: [0, 0, 0] }))).toBe(true);
    for (let k = 0; k < 4; k++) {
      const { sent } = completed(turning);
      const attitude = sent.attitude.map((x, i) => (i === k ? x + 1e-12 : x));
      expect(isSent(completed({ ...turning, attitude }))).toBe(true);
    }
    expect(isSent(completed(turning, { name: 'Vulcan' }))).toBe(true);
    expect(isSent(completed(turning, {}, TICK + 1))).toBe(true);
    expect(isSent(completed(turning, null))).toBe(true);
  });
});

describe('bodies that did not move since the last frame', () => {
  it('are outdated if they have a velocity, and ignored', () => {
    expect(completed({}).made).toBeNull();
    expect(completed({ velocity: [0, 0, 2e-6] }).made).toBeNull();
  });

  it('are current if they have no velocity, moved at all, or have the same tick', () => {
    expect(completed({ velocity: [0, 0, 0.9e-6] }).made).not.toBeNull();
    for (let k = 0; k < 3; k++) {
      const { sent } = completed({});
      const position = sent.position.map((x, i) => (i === k ? x + 1 : x));
      expect(completed({ position }).made).not.toBeNull();
    }
    expect(completed({}, {}, TICK + 1).made).not.toBeNull();
    expect(completed({}, null).made).not.toBeNull();
  });
});
