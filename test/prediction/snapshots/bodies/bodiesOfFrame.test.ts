import { describe, expect, it } from 'vitest';
import {
  BODIES,
  BODY_POSITION,
  BODY_STRIDE,
  type BodyMotion,
  SHIP_CLASSES,
  writeBodyMotion,
} from '../../../../src/dynamics';
import { createPredictor, type Predictor } from '../../../../src/prediction';
import {
  boundaryAt,
  createBodyTrack,
  startBodiesAt,
} from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { createTimeline, setTempo } from '../../../../src/prediction/time/timeline';
import type { ShipState } from '../../../../src/wire';
import { frameAt, STILL } from '../../faults/restingShip';
import { OWN } from '../../faults/feed';

const LUNA = BODIES[0]!;
const HEIGHT = LUNA.radius + SHIP_CLASSES[0]!.groundContactOffset;
const SPEED = 30_000;
const HALF = Math.SQRT1_2;

/** A body that moves along z and turns about y at `spin` rad/s, as it is at game second 0. */
const bodyOf = (spin: number) => ({
  ...LUNA,
  ...({
    position: [0, 0, 0],
    velocity: [0, 0, SPEED],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, spin, 0],
  } as const),
});

/** A ship landed where x is up, at that game second, in ICRF alone. */
function landedAt(seconds: number, spin: number): ShipState {
  const [s, c] = [Math.sin(spin * seconds), Math.cos(spin * seconds)];
  const [hs, hc] = [Math.sin((spin * seconds) / 2), Math.cos((spin * seconds) / 2)];
  return {
    ...STILL,
    position: [HEIGHT * c, 0, -HEIGHT * s + SPEED * seconds],
    velocity: [-HEIGHT * spin * s, 0, -HEIGHT * spin * c + SPEED],
    // Turned on with the body: about y, after a quarter about y that lays the nose along x.
    attitude: [0, hs * HALF + hc * HALF, 0, hc * HALF - hs * HALF],
    angularVelocity: [0, spin, 0],
    landedBodyName: LUNA.name,
    surfaceContactState: 'landed',
    contactImpactSpeed: null,
    referenceBody: '',
    relativePosition: null,
    relativeVelocity: null,
  };
}

interface Sending {
  readonly spin: number;
  /** Hz */
  readonly tickRate: number;
  readonly bodies: (seconds: number) => readonly (typeof LUNA & BodyMotion)[];
}

/** A frame of that tick, each second of it sent `times` times. */
function hear(predictor: Predictor, tick: number, now: number, { spin, tickRate, bodies }: Sending): void {
  const seconds = tick / tickRate;
  predictor.receive(
    frameAt(tick, tickRate, { bodies: bodies(seconds), ships: [landedAt(seconds, spin)] }),
    now,
  );
}

describe('bodies that are not sent', () => {
  const codes: string[] = [];
  const sending: Sending = { spin: 0, tickRate: 50, bodies: () => [] };
  const predictor = createPredictor({
    ...OWN,
    defaults: { bodies: [bodyOf(0)] },
    onWarning: (code) => codes.push(code),
  });
  const send = (second: number, now: number) => {
    hear(predictor, second * sending.tickRate, now, sending);
  };
  for (let second = 0; second < 8; second++) {
    send(second, second);
    for (let k = 0; k < 60; k++) predictor.advance(null, second + k / 60);
  }
  // 40 s frozen, longer than any history; then all at once.
  for (let second = 8; second <= 48; second++) send(second, 48);
  for (let k = 0; k < 60 * 3; k++) {
    const now = 48 + k / 60;
    if (k > 0 && k % 60 === 0) send(now, now);
    predictor.advance(null, now);
    predictor.view(now);
  }

  it('are where their velocity took them, after a longer absence too', () => {
    const view = predictor.view(50.98);
    const { own, bodies, diagnosis } = view;
    expect(Math.hypot(...own!.position) - HEIGHT).toBeCloseTo(0, 3);
    expect(bodies[0]!.position[2] / SPEED).toBeCloseTo(view.tick / view.tickRate + view.sinceTick, 6);
    expect(diagnosis.correctionsMismatch).toBe(0);
  });

  it('are no reason to warn of a ship off its ground', () => {
    expect(codes).not.toContain('landed-off-ground');
  });
});

it('a body is drawn as it is sent: moved by its velocity and turned by its spin up to the instant', () => {
  const sent = {
    ...LUNA,
    ...({ position: [1e7, -2e7, 3e7], velocity: [100, -200, 300], attitude: [0, 0, 0, 1] } as const),
    angularVelocity: [1e-3, -2e-3, 2e-3] as const,
  };
  const predictor = createPredictor(OWN);
  predictor.receive(frameAt(5, 1, { bodies: [sent], ships: [] }), 0);
  predictor.advance(null, 0.7);
  const { tick, sinceTick, bodies } = predictor.view(0.7);
  const seconds = tick - 5 + sinceTick;
  expect(seconds).toBeGreaterThan(0.5);
  const [body] = bodies;
  expect([...body!.velocity]).toEqual(sent.velocity);
  expect([...body!.angularVelocity]).toEqual(sent.angularVelocity);
  expect(body!.attitude[3]).toBeCloseTo(Math.cos((3e-3 * seconds) / 2), 12);
  for (let k = 0; k < 3; k++) {
    expect(body!.position[k]).toBeCloseTo(sent.position[k]! + sent.velocity[k]! * seconds, 6);
    const part = sent.angularVelocity[k]! / 3e-3;
    expect(body!.attitude[k]).toBeCloseTo(part * Math.sin((3e-3 * seconds) / 2), 9);
  }
});

describe('the bodies at the ticks', () => {
  const timeline = createTimeline(0.01);
  setTempo(timeline, 0, { tickRate: 50, timeScale: 1, paused: false }, 0);
  const rows = new Float64Array(BODY_STRIDE);
  writeBodyMotion(rows, 0, bodyOf(1e-4));
  const track = createBodyTrack(rows, 100, 2);
  startBodiesAt(track, 0);
  const zAt = (tick: number) => boundaryAt(track, timeline, tick)[BODY_POSITION + 2]!;

  it('are known one after the other, and across a gap that is longer than the ring', () => {
    for (let tick = 1; tick <= 50; tick++) expect(zAt(tick)).toBeCloseTo((SPEED * tick) / 50, 6);
    expect(zAt(1000)).toBeCloseTo((SPEED * 1000) / 50, 6);
  });

  it('are also known before the ring, which does not change', () => {
    expect(zAt(880)).toBeCloseTo((SPEED * 880) / 50, 6);
    expect(zAt(1001)).toBeCloseTo((SPEED * 1001) / 50, 6);
    expect(zAt(950)).toBeCloseTo((SPEED * 950) / 50, 6);
  });
});

describe('a body whose attitude is the same in each frame, though it has spin', () => {
  const spin = 1e-4;
  const sending: Sending = {
    spin,
    tickRate: 10,
    bodies: (seconds) => [{ ...bodyOf(spin), position: [0, 0, SPEED * seconds] }],
  };

  it('is turned by the dynamics, as one that is sent without', () => {
    const predictor = createPredictor(OWN);
    let largest = 0;
    for (let frame = 0; frame < 60 * 6; frame++) {
      const now = frame / 60;
      if (frame % 6 === 0) hear(predictor, frame / 6, now, sending);
      predictor.advance(null, now);
      const { tick, sinceTick, bodies, own, ready } = predictor.view(now);
      if (!ready) continue;
      const turned = 2 * Math.asin(bodies[0]!.attitude[1]);
      largest = Math.max(
        largest,
        Math.abs(turned - spin * (tick / 10 + sinceTick)) * Math.hypot(...own!.position),
      );
    }
    // Of the ground under the ship, m.
    expect(largest).toBeLessThan(0.001);
    expect(predictor.view(6).diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsBody: 0 });
  });
});
