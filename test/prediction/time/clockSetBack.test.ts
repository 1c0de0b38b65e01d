import { describe, expect, it } from 'vitest';
import { createPredictor, type Predictor } from '../../../src/prediction';
import { frameAt } from '../faults/restingShip';
import { named, OWN, range } from '../faults/feed';

const RATE = 10;
const HOUR = 3600;

/** Ten seconds of frames at RATE, then the caller's clock is set back by an hour. Returns its new time. */
function setBack(predictor: Predictor, state = 'landed'): number {
  for (const tick of range(0, 101)) {
    const surfaceContactState = tick < 95 ? 'landed' : state;
    const ships = [named('ship-1', { surfaceContactState }), named('ship-2')];
    predictor.receive(frameAt(tick, RATE, { ships }), 5000 + tick / RATE);
    predictor.advance(null, 5000 + tick / RATE);
    predictor.view(5000 + tick / RATE);
  }
  return 5010 - HOUR;
}

/** Frames of ship-1 alone for `seconds` from `tick` on. */
function goOn(predictor: Predictor, from: number, tick: number, seconds: number): number {
  for (const next of range(0, seconds * RATE)) {
    predictor.receive(frameAt(tick + next, RATE, { ships: [named('ship-1')] }), from + next / RATE);
    predictor.advance(null, from + next / RATE);
    predictor.view(from + next / RATE);
  }
  return from + seconds;
}

function stay(predictor: Predictor, from: number, seconds: number): number {
  for (const step of range(0, seconds * RATE)) predictor.advance(null, from + step / RATE);
  return from + seconds;
}

describe('after the caller’s clock is set back by an hour', () => {
  it('a silent server is noticed as soon as before', () => {
    const predictor = createPredictor(OWN);
    const now = stay(predictor, setBack(predictor), 12);
    const view = predictor.view(now);
    expect(view.connection).toBe('silent');
    expect(view.own!.provenance).toBe('stale');
    expect(view.silence).toBeGreaterThan(11);
    expect(view.silence).toBeLessThan(13);
  });

  it('a ship that is no longer sent disappears as soon as before', () => {
    const predictor = createPredictor(OWN);
    const now = goOn(predictor, setBack(predictor), 101, 3);
    expect(predictor.view(now).ships.map(({ shipId }) => shipId)).toEqual(['ship-1']);
  });

  it('CONTACT is shown no longer than its dwell time', () => {
    const predictor = createPredictor(OWN);
    const now = goOn(predictor, setBack(predictor, 'contact'), 101, 2);
    expect(predictor.view(now).own!.shownState).toBe('landed');
  });

  it('a snapshot has its true age', () => {
    const predictor = createPredictor(OWN);
    const now = stay(predictor, setBack(predictor), 2);
    expect(predictor.snapshot(now).age).toBeCloseTo(2, 1);
  });

  it('the present is the same if messages are stamped before the frame after which they are handled', () => {
    const ahead = [0, 0.02, 0.1].map((early) => {
      const predictor = createPredictor(OWN);
      for (const tick of range(0, 300)) {
        const now = 5000 + tick / RATE;
        predictor.advance(null, now + early);
        predictor.receive(frameAt(tick, RATE, { ships: [named('ship-1')] }), now);
      }
      predictor.advance(null, 5030);
      const { tick, sinceTick } = predictor.view(5030);
      return tick / RATE + sinceTick - 30;
    });
    for (const seconds of ahead) expect(seconds).toBeCloseTo(ahead[0]!, 1);
  });

  it('the clock offset is relative to the new time', () => {
    const predictor = createPredictor(OWN);
    const before = 5010;
    const now = goOn(predictor, setBack(predictor), 101, 2);
    const { clockOffset } = predictor.view(now).diagnosis;
    expect(clockOffset).toBeGreaterThan(before - HOUR - 13);
    expect(clockOffset).toBeLessThan(before - HOUR - 7);
  });
});

describe('a snapshot at a time that is not a number', () => {
  it('has age 0, and is not restored', () => {
    const predictor = createPredictor(OWN);
    goOn(predictor, 5000, 0, 1);
    const snapshot = predictor.snapshot(Number.NaN);
    expect(snapshot.age).toBe(0);
    const before = predictor.view(5001).tick;
    expect(predictor.restore(snapshot, Number.NaN)).toEqual({
      ok: false,
      reason: 'now: expected finite wall s',
    });
    expect(predictor.view(5001).tick).toBe(before);
  });
});
